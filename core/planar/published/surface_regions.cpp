#include "planar/published/surface_regions.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "planar/published/gaussian_mixture.h"
#include "planar/published/graph_cut.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kMaxClusters = 8;
constexpr double kMinShare = 0.01;    // of the surface, for a region
constexpr double kSmoothness = 0.3;   // weight of agreeing neighbours against that of the diameters
constexpr double kConvexShare = 0.08; // share of a convex edge's angle that counts
constexpr double kMinAngle = 1e-3, kMinLikely = 1e-4;

struct Border {
  std::size_t a = 0, b = 0; // triangles
  double lengthMm = 0.0;
  double angle = 0.0; // sharpness of the edge as a share of a half turn; reduced for convex edges
};

std::vector<Border> bordersOf(const geometry::TriangleMesh& mesh) {
  std::vector<Border> out;
  const std::vector<geometry::HalfEdge> sides = geometry::sortedHalfEdges(mesh);
  geometry::forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i + 1 < end; ++i) {
      const geometry::HalfEdge &e = sides[i], &f = sides[i + 1];
      Border border{static_cast<std::size_t>(e.triangle), static_cast<std::size_t>(f.triangle)};
      const Vector3d &p = mesh.vertices[static_cast<std::size_t>(e.low)],
                     &q = mesh.vertices[static_cast<std::size_t>(e.high)];
      border.lengthMm = (q - p).norm();
      const Vector3d n = geometry::triangleNormal(mesh, border.a),
                     m = geometry::triangleNormal(mesh, border.b);
      const Vector3d& opposite = mesh.corner(border.b, (f.side + 2) % 3);
      const double bend = std::acos(std::clamp(n.dot(m), -1.0, 1.0)) / base::kPi;
      border.angle = n.dot(opposite - p) > 0.0 ? bend : kConvexShare * bend;
      out.push_back(border);
    }
  });
  return out;
}

void hangTogether(const std::vector<Border>& borders, const std::vector<std::size_t>& labels,
                  SurfaceRegions& out) {
  geometry::UnionFind sets(labels.size());
  for (const Border& b : borders)
    if (labels[b.a] == labels[b.b])
      sets.join(static_cast<int>(b.a), static_cast<int>(b.b));
  std::map<int, int> index;
  out.ofTriangle.resize(labels.size());
  for (std::size_t t = 0; t < labels.size(); ++t)
    out.ofTriangle[t] =
        index.try_emplace(sets.find(static_cast<int>(t)), static_cast<int>(index.size()))
            .first->second;
  out.count = static_cast<int>(index.size());
}

// Merges small regions, smallest first, into the neighbour with the longest common border.
void absorbSmall(const std::vector<Border>& borders, const std::vector<double>& area, double all,
                 SurfaceRegions& out) {
  const auto count = static_cast<std::size_t>(out.count);
  std::vector<double> size(count, 0.0);
  for (std::size_t t = 0; t < area.size(); ++t)
    size[static_cast<std::size_t>(out.ofTriangle[t])] += area[t];
  std::vector<std::map<int, double>> common(count);
  for (const Border& b : borders) {
    const int i = out.ofTriangle[b.a], j = out.ofTriangle[b.b];
    if (i != j) {
      common[static_cast<std::size_t>(i)][j] += b.lengthMm;
      common[static_cast<std::size_t>(j)][i] += b.lengthMm;
    }
  }
  std::vector<int> into(count);
  for (std::size_t r = 0; r < count; ++r)
    into[r] = static_cast<int>(r);
  std::vector<bool> merged(count, false);
  while (true) {
    std::size_t smallest = count;
    for (std::size_t r = 0; r < count; ++r)
      if (!merged[r] && !common[r].empty() && size[r] < kMinShare * all &&
          (smallest == count || size[r] < size[smallest]))
        smallest = r;
    if (smallest == count)
      break;
    const auto longest =
        std::max_element(common[smallest].begin(), common[smallest].end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    const auto host = static_cast<std::size_t>(longest->first);
    merged[smallest] = true;
    into[smallest] = longest->first;
    size[host] += size[smallest];
    for (const auto& [other, length] : common[smallest]) {
      auto& theirs = common[static_cast<std::size_t>(other)];
      theirs.erase(static_cast<int>(smallest));
      if (static_cast<std::size_t>(other) == host)
        continue;
      theirs[static_cast<int>(host)] += length;
      common[host][other] += length;
    }
  }
  std::map<int, int> index;
  for (int& region : out.ofTriangle) {
    while (merged[static_cast<std::size_t>(region)])
      region = into[static_cast<std::size_t>(region)];
    region = index.try_emplace(region, static_cast<int>(index.size())).first->second;
  }
  out.count = static_cast<int>(index.size());
}

} // namespace

SurfaceRegions surfaceRegions(const geometry::TriangleMesh& mesh,
                              const std::vector<double>& diameters, std::size_t clusters) {
  const std::size_t n = mesh.triangles.size();
  base::require(diameters.size() == n, "surfaceRegions: a diameter a triangle");
  SurfaceRegions out;
  if (n == 0)
    return out;
  std::vector<double> area(n), weights(n);
  double all = 0.0;
  for (std::size_t t = 0; t < n; ++t)
    all += area[t] = geometry::triangleArea(mesh, t);
  for (std::size_t t = 0; t < n; ++t)
    weights[t] = area[t] * static_cast<double>(n) / std::max(1e-30, all);
  const GaussianMixture mixture = clusters == 0 ? bestMixture(diameters, weights, kMaxClusters)
                                                : fitMixture(diameters, weights, clusters);
  out.clusters = mixture.parts.size();
  std::vector<std::vector<double>> costs(out.clusters, std::vector<double>(n));
  for (std::size_t t = 0; t < n; ++t) {
    const std::vector<double> shares = mixture.sharesOf(diameters[t]);
    for (std::size_t k = 0; k < out.clusters; ++k)
      costs[k][t] = -weights[t] * std::log(std::max(kMinLikely, shares[k]));
  }
  const std::vector<Border> borders = bordersOf(mesh);
  double length = 0.0;
  for (const Border& b : borders)
    length += b.lengthMm;
  const double mean = std::max(1e-30, length / static_cast<double>(borders.size()));
  std::vector<LabelEdge> edges;
  for (const Border& b : borders)
    edges.push_back(
        {{b.a, b.b}, -kSmoothness * std::log(std::max(kMinAngle, b.angle)) * b.lengthMm / mean});
  hangTogether(borders, graphCut(costs, edges), out);
  absorbSmall(borders, area, all, out);
  return out;
}

} // namespace voluta::planar
