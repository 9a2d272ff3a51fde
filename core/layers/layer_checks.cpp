#include "layers/layer_checks.h"

#include "base/parallel.h"
#include "geometry/edges.h"
#include "geometry/measures.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voluta::layers {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

constexpr std::size_t kMostSamples = 400; // a patch
constexpr double kRounding = 1e-9;        // mm
constexpr double kDownwards = 0.5;

// The first `count` patches as one mesh.
struct Floor {
  geometry::TriangleMesh mesh;
  std::vector<int> patchOf;          // per triangle
  std::vector<double> halfThickness; // per triangle
  double most = 0.0;                 // of halfThickness
};

Floor floorOf(const LayerStack& stack, std::size_t count) {
  Floor floor;
  for (std::size_t p = 0; p < count; ++p) {
    const Patch& patch = stack.patches[p];
    const int base = static_cast<int>(floor.mesh.vertices.size());
    floor.mesh.vertices.insert(floor.mesh.vertices.end(), patch.surface.vertices.begin(),
                               patch.surface.vertices.end());
    for (const auto& t : patch.surface.triangles) {
      floor.mesh.triangles.push_back({base + t[0], base + t[1], base + t[2]});
      floor.patchOf.push_back(static_cast<int>(p));
      floor.halfThickness.push_back((patch.thicknessMm[at(t[0])] + patch.thicknessMm[at(t[1])] +
                                     patch.thicknessMm[at(t[2])]) /
                                    6.0);
      floor.most = std::max(floor.most, floor.halfThickness.back());
    }
  }
  return floor;
}

SupportCheck supportOf(std::size_t p, const Patch& patch, const Floor& floor,
                       const geometry::MeshQuery& query, double reachShare) {
  const std::size_t n = patch.surface.triangles.size();
  const std::size_t step = std::max<std::size_t>(1, n / kMostSamples);
  double whole = 0.0, supported = 0.0;
  std::map<int, int> met;
  std::vector<geometry::MeshQuery::Hit> hits;
  SupportCheck check;
  for (std::size_t t = 0; t < n; t += step) {
    const auto& tri = patch.surface.triangles[t];
    const double area = geometry::triangleArea(patch.surface, t);
    const Eigen::Vector3d centre =
        (patch.surface.corner(t, 0) + patch.surface.corner(t, 1) + patch.surface.corner(t, 2)) / 3;
    const double half = (patch.thicknessMm[at(tri[0])] + patch.thicknessMm[at(tri[1])] +
                         patch.thicknessMm[at(tri[2])]) /
                        6.0;
    whole += area;
    if (centre.z() <= 2.0 * reachShare * half) {
      supported += area;
      ++met[-1];
      continue;
    }
    const Eigen::Vector3d down = -patch.direction[at(tri[0])];
    // What ends beside it carries nothing: half the way at least has to lead downwards.
    const auto lies = [&](int triangle, const Eigen::Vector3d& place) {
      if (triangle < 0 || floor.patchOf[at(triangle)] >= static_cast<int>(p))
        return false;
      const double halves = half + floor.halfThickness[at(triangle)];
      return (place - centre).norm() <= reachShare * halves &&
             (place - centre).dot(down) >= kDownwards * halves;
    };
    // What is under it is nearest to a point a thickness down; else anything straight below.
    int lower = -1;
    const auto found = query.closest(centre + 2.0 * half * down, 2.0 * half * reachShare);
    if (found.triangle >= 0 && lies(found.triangle, found.point)) {
      lower = found.triangle;
    } else {
      const double reach = reachShare * (half + floor.most);
      query.hits(centre + 0.1 * half * down, centre + reach * down, hits);
      for (const auto& hit : hits)
        if (lies(hit.triangle, centre + (0.1 * half + hit.t * (reach - 0.1 * half)) * down)) {
          lower = hit.triangle;
          break;
        }
    }
    if (lower >= 0) {
      supported += area;
      ++met[floor.patchOf[at(lower)]];
    } else {
      check.unsupportedAt = centre;
    }
  }
  check.supportedFraction = whole > 0.0 ? supported / whole : 1.0;
  int most = 0;
  for (const auto& [lower, count] : met)
    if (count > most) {
      most = count;
      check.lower = lower;
    }
  return check;
}

} // namespace

LayerStatistics layerStatistics(const LayerStack& stack, const HeightLimits& limits) {
  LayerStatistics s;
  s.count = stack.layerCount;
  std::vector<std::pair<double, double>> samples; // thickness, area
  double sum = 0.0, squares = 0.0, within = 0.0;
  for (const Patch& p : stack.patches) {
    if (p.group == kSupportGroup)
      continue;
    ++s.patches;
    for (std::size_t t = 0; t < p.surface.triangles.size(); ++t) {
      const auto& tri = p.surface.triangles[t];
      const double area = geometry::triangleArea(p.surface, t);
      const double thickness =
          (p.thicknessMm[at(tri[0])] + p.thicknessMm[at(tri[1])] + p.thicknessMm[at(tri[2])]) / 3.0;
      samples.emplace_back(thickness, area);
      if (thickness >= limits.minMm - kRounding && thickness <= limits.maxMm + kRounding)
        within += area;
      s.areaMm2 += area;
      sum += area * thickness;
      squares += area * thickness * thickness;
    }
  }
  if (s.areaMm2 <= 0.0)
    return s;
  s.withinLimitsFraction = within / s.areaMm2;
  s.thicknessMeanMm = sum / s.areaMm2;
  s.thicknessStdMm =
      std::sqrt(std::max(0.0, squares / s.areaMm2 - s.thicknessMeanMm * s.thicknessMeanMm));
  std::sort(samples.begin(), samples.end());
  const auto percentile = [&](double share) {
    double passed = 0.0;
    for (const auto& [thickness, area] : samples) {
      passed += area;
      if (passed >= share * s.areaMm2)
        return thickness;
    }
    return samples.back().first;
  };
  s.thicknessP01Mm = percentile(0.01);
  s.thicknessP99Mm = percentile(0.99);
  return s;
}

std::vector<BoundaryCheck> checkBoundaries(const LayerStack& stack, const geometry::MeshQuery& part,
                                           double toleranceMm, const base::RunContext& ctx) {
  std::vector<BoundaryCheck> checks(stack.patches.size());
  base::parallelChunks(ctx, checks.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const auto& mesh = stack.patches[p].surface;
      BoundaryCheck& check = checks[p];
      const auto edges = geometry::sortedHalfEdges(mesh);
      std::vector<int> ends(mesh.vertices.size(), 0);
      std::vector<double> distance(mesh.vertices.size(), -1.0);
      double whole = 0.0, on = 0.0;
      geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
        if (e - b > 2 || (e - b == 2 && edges[b].forward == edges[b + 1].forward))
          check.simple = false;
        if (e - b != 1)
          return;
        const int low = edges[b].low, high = edges[b].high;
        for (int v : {low, high}) {
          ++ends[at(v)];
          if (distance[at(v)] < 0.0)
            distance[at(v)] = part.closest(mesh.vertices[at(v)]).distance;
          check.farthestMm = std::max(check.farthestMm, distance[at(v)]);
        }
        const double length = (mesh.vertices[at(low)] - mesh.vertices[at(high)]).norm();
        whole += length;
        if (std::max(distance[at(low)], distance[at(high)]) <= toleranceMm)
          on += length;
      });
      check.onSurface = whole > 0.0 ? on / whole : 1.0;
      for (int count : ends)
        if (count != 0 && count != 2)
          check.simple = false;
    }
  });
  return checks;
}

std::vector<SupportCheck> checkSupport(const LayerStack& stack, double reachShare,
                                       const base::RunContext& ctx,
                                       const std::vector<std::size_t>& which) {
  std::vector<SupportCheck> checks(which.empty() ? stack.patches.size() : which.size());
  const Floor floor = floorOf(stack, which.empty() ? stack.patches.size() : which.back());
  const geometry::MeshQuery query(floor.mesh);
  base::parallelChunks(ctx, checks.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t p = which.empty() ? n : which[n];
      checks[n] = supportOf(p, stack.patches[p], floor, query, reachShare);
    }
  });
  return checks;
}

} // namespace voluta::layers
