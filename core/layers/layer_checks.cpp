#include "layers/layer_checks.h"

#include "base/index.h"
#include "base/parallel.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "layers/stack_query.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voluta::layers {

namespace {

using base::at;

constexpr std::size_t kMaxSamples = 400; // per patch
constexpr double kRounding = 1e-9;       // mm
constexpr double kDownwards = 0.5;

double halfThickness(const Patch& patch, std::size_t triangle) {
  const auto& t = patch.surface.triangles[triangle];
  return (patch.thicknessMm[at(t[0])] + patch.thicknessMm[at(t[1])] + patch.thicknessMm[at(t[2])]) /
         6.0;
}

double maxThickness(const LayerStack& stack) {
  double maximum = 0.0;
  for (const Patch& patch : stack.patches)
    for (double t : patch.thicknessMm)
      maximum = std::max(maximum, t);
  return maximum;
}

// Returns the search radius for the support of a point: from its mid-surface to that of the patch
// below.
double reachOf(double maxThicknessMm, double reachShare) {
  return (1.0 + reachShare) * maxThicknessMm;
}

SupportCheck supportOf(const LayerStack& stack, std::size_t p, const StackQuery& query,
                       double maxThicknessMm, double reachShare, const Ground& ground) {
  const Patch& patch = stack.patches[p];
  const std::size_t n = patch.surface.triangles.size();
  const std::size_t step = std::max<std::size_t>(1, n / kMaxSamples);
  double whole = 0.0, supported = 0.0;
  std::map<int, int> met;
  std::vector<StackQuery::Place> hits;
  Eigen::AlignedBox3d box = geometry::bounds(patch.surface);
  box.min().array() -= reachOf(maxThicknessMm, reachShare);
  box.max().array() += reachOf(maxThicknessMm, reachShare);
  const std::vector<int> earlier = query.near(box, 0, static_cast<int>(p));
  SupportCheck check;
  for (std::size_t t = 0; t < n; t += step) {
    const auto& tri = patch.surface.triangles[t];
    const double area = geometry::triangleArea(patch.surface, t);
    const Eigen::Vector3d centre =
        (patch.surface.corner(t, 0) + patch.surface.corner(t, 1) + patch.surface.corner(t, 2)) / 3;
    const double half = halfThickness(patch, t);
    whole += area;
    if (ground.over(centre) <= 2.0 * reachShare * half) {
      supported += area;
      ++met[-1];
      continue;
    }
    const Eigen::Vector3d down = -patch.direction[at(tri[0])];
    // A patch that ends beside the point does not carry it: at least half of the distance must be
    // downwards.
    const auto carries = [&](const StackQuery::Place& place) {
      if (place.patch < 0)
        return false;
      const double halves =
          half + halfThickness(stack.patches[at(place.patch)], at(place.triangle));
      return (place.point - centre).norm() <= reachShare * halves &&
             (place.point - centre).dot(down) >= kDownwards * halves;
    };
    // The support is nearest to a point one thickness below; otherwise anything straight below
    // counts.
    int lower = -1;
    const StackQuery::Place found =
        query.closest(earlier, centre + 2.0 * half * down, 2.0 * half * reachShare);
    if (carries(found)) {
      lower = found.patch;
    } else {
      const double reach = reachShare * (half + 0.5 * maxThicknessMm);
      query.hits(earlier, centre + 0.1 * half * down, centre + reach * down, hits);
      const auto hit = std::find_if(hits.begin(), hits.end(), carries);
      if (hit != hits.end())
        lower = hit->patch;
    }
    if (lower >= 0) {
      supported += area;
      ++met[lower];
    } else {
      check.unsupportedAt = centre;
    }
  }
  check.supportedFraction = whole > 0.0 ? supported / whole : 1.0;
  int maximum = 0;
  for (const auto& [lower, count] : met)
    if (count > maximum) {
      maximum = count;
      check.lower = lower;
    }
  return check;
}

} // namespace

plan::LayerStatistics layerStatistics(const LayerStack& stack, const HeightLimits& limits) {
  plan::LayerStatistics s;
  s.withinLimitsFraction = 1.0; // of no area at all
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
      if (samples.empty() || samples.back().first != thickness)
        samples.emplace_back(thickness, 0.0);
      samples.back().second += area;
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
                                       const std::vector<std::size_t>& which,
                                       const Ground& ground) {
  std::vector<SupportCheck> checks(which.empty() ? stack.patches.size() : which.size());
  const double maximum = maxThickness(stack);
  std::vector<Eigen::AlignedBox3d> around;
  for (std::size_t n = 0; n < checks.size(); ++n)
    around.push_back(geometry::bounds(stack.patches[which.empty() ? n : which[n]].surface));
  const StackQuery query(stack.patches, around, reachOf(maximum, reachShare), ctx);
  base::parallelChunks(ctx, checks.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      checks[n] =
          supportOf(stack, which.empty() ? n : which[n], query, maximum, reachShare, ground);
  });
  return checks;
}

} // namespace voluta::layers
