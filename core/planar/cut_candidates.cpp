#include "planar/cut_candidates.h"

#include "base/parallel.h"
#include "geometry/edges.h"
#include "geometry/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace voluta::planar {

using Eigen::Vector3d;

std::vector<Vector3d> evenDirections(int count, double zMin) {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::vector<Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (1.0 - zMin) * (i + 0.5) / count;
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    directions.emplace_back(r * std::cos(golden * i), r * std::sin(golden * i), z);
  }
  return directions;
}

namespace {

struct Faces {
  std::vector<Vector3d> centre, normal;
  std::vector<double> area, risky; // risky: area that needs support as things are
  std::vector<std::uint8_t> stands;
  std::vector<std::array<int, 3>> neighbour; // -1: none
};

Faces facesOf(const Piece& piece, const RiskRule& rule) {
  const geometry::TriangleMesh& mesh = piece.solid.mesh;
  const std::size_t n = mesh.triangles.size();
  Faces f;
  f.stands = standsOn(piece, rule);
  f.neighbour.assign(n, {-1, -1, -1});
  for (std::size_t t = 0; t < n; ++t) {
    f.centre.push_back((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0);
    f.normal.push_back(geometry::triangleNormal(mesh, t));
    f.area.push_back(geometry::triangleArea(mesh, t));
    f.risky.push_back(!f.stands[t] && isRisky(f.normal[t], piece.base.normal, rule) ? f.area[t]
                                                                                    : 0.0);
  }
  const std::vector<geometry::HalfEdge> sides = geometry::sortedHalfEdges(mesh);
  geometry::forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i + 1 < end; ++i) {
      const auto a = static_cast<std::size_t>(sides[i].triangle);
      const auto b = static_cast<std::size_t>(sides[i + 1].triangle);
      f.neighbour[a][static_cast<std::size_t>(sides[i].side)] = static_cast<int>(b);
      f.neighbour[b][static_cast<std::size_t>(sides[i + 1].side)] = static_cast<int>(a);
    }
  });
  return f;
}

// What hangs together above the falling plane.
struct Part {
  double before = 0.0, after = 0.0; // risky area
  bool stands = false;
  int top = -1; // its highest face
};

void sweep(const Faces& f, const Vector3d& normal, const RiskRule& rule,
           const CandidateOptions& options, std::vector<CutCandidate>& out) {
  const std::size_t n = f.centre.size();
  std::vector<double> height(n);
  double lowest = 1e300, highest = -1e300;
  for (std::size_t t = 0; t < n; ++t) {
    height[t] = normal.dot(f.centre[t]);
    lowest = std::min(lowest, height[t]);
    highest = std::max(highest, height[t]);
  }
  const int bins = std::max(1, static_cast<int>(std::floor((highest - lowest) / options.stepMm)));
  const double step = (highest - lowest) / bins;
  if (!(step > 0.0))
    return;
  std::vector<int> first(static_cast<std::size_t>(bins) + 1, 0), order(n);
  const auto binOf = [&](std::size_t t) {
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>((height[t] - lowest) / step), 0, bins - 1));
  };
  for (std::size_t t = 0; t < n; ++t)
    ++first[binOf(t) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  {
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t t = 0; t < n; ++t)
      order[static_cast<std::size_t>(next[binOf(t)]++)] = static_cast<int>(t);
  }

  geometry::UnionFind sets(n);
  std::vector<Part> part(n);
  std::vector<std::uint8_t> above(n, 0);
  std::vector<int> roots;
  std::vector<CutCandidate> found;
  for (int bin = bins - 1; bin > 0; --bin) {
    for (int i = first[static_cast<std::size_t>(bin)]; i < first[static_cast<std::size_t>(bin) + 1];
         ++i) {
      const auto t = static_cast<std::size_t>(order[static_cast<std::size_t>(i)]);
      above[t] = 1;
      part[t] = {f.risky[t], !f.stands[t] && isRisky(f.normal[t], normal, rule) ? f.area[t] : 0.0,
                 f.stands[t] != 0, static_cast<int>(t)};
      roots.push_back(static_cast<int>(t));
      for (const int w : f.neighbour[t]) {
        if (w < 0 || !above[static_cast<std::size_t>(w)])
          continue;
        const int a = sets.find(static_cast<int>(t)), b = sets.find(w);
        if (a == b)
          continue;
        sets.join(a, b);
        const auto root = static_cast<std::size_t>(sets.find(a));
        const Part &p = part[static_cast<std::size_t>(a)], &q = part[static_cast<std::size_t>(b)];
        const bool higher =
            height[static_cast<std::size_t>(p.top)] >= height[static_cast<std::size_t>(q.top)];
        part[root] = {p.before + q.before, p.after + q.after, p.stands || q.stands,
                      higher ? p.top : q.top};
      }
    }
    std::erase_if(roots, [&](int r) { return sets.find(r) != r; });
    for (const int r : roots) {
      const Part& p = part[static_cast<std::size_t>(r)];
      if (p.stands || p.before - p.after < options.leastMm2)
        continue;
      found.push_back({{normal, lowest + bin * step},
                       p.before - p.after,
                       p.after,
                       f.centre[static_cast<std::size_t>(p.top)]});
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const CutCandidate& a, const CutCandidate& b) {
    return a.gainMm2 > b.gainMm2;
  });
  if (found.size() > static_cast<std::size_t>(options.perNormal))
    found.resize(static_cast<std::size_t>(options.perNormal));
  out = std::move(found);
}

} // namespace

std::vector<CutCandidate> cutCandidates(const Piece& piece, const RiskRule& rule,
                                        const std::vector<Vector3d>& normals,
                                        const CandidateOptions& options,
                                        const base::RunContext& ctx) {
  const Faces faces = facesOf(piece, rule);
  std::vector<std::vector<CutCandidate>> found(normals.size());
  base::parallelChunks(ctx, normals.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      sweep(faces, normals[i], rule, options, found[i]);
  });
  std::vector<CutCandidate> all;
  for (const auto& of : found)
    all.insert(all.end(), of.begin(), of.end());
  std::stable_sort(all.begin(), all.end(), [](const CutCandidate& a, const CutCandidate& b) {
    return a.gainMm2 > b.gainMm2;
  });
  return all;
}

} // namespace voluta::planar
