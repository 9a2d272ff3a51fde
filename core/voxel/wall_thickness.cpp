#include "voxel/wall_thickness.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace voluta::voxel {

namespace {
constexpr double kFacing = -0.906; // Cosine between two normals 155 degrees apart
constexpr double kMaxPoints = 60'000.0;
constexpr double kPlaceCells = 3.0; // In widths: thin points closer than this belong to one place

struct ThinPoint {
  Eigen::Vector3d at;
  double thickness, area;
  std::size_t facet;
};

// Returns into how many parts each side of a facet is divided for its sample points.
std::vector<int> divisions(const geometry::TriangleMesh& mesh, double width) {
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    area += geometry::triangleArea(mesh, t);
  const double budget = std::max(1.0, kMaxPoints - static_cast<double>(mesh.triangles.size()));
  const double square = std::max(width * width, area / budget);
  std::vector<int> out(mesh.triangles.size());
  for (std::size_t t = 0; t < out.size(); ++t)
    out[t] = std::max(1, static_cast<int>(std::sqrt(geometry::triangleArea(mesh, t) / square)));
  return out;
}

// Returns whether beads of this width do not fit into a wall with this normal.
bool isThin(double thickness, const Eigen::Vector3d& normal, double width,
            std::optional<double> layerMm) {
  return !layerMm || thickness < width * normal.head<2>().norm() ||
         thickness < *layerMm * std::abs(normal.z());
}

void measureFacet(const geometry::TriangleMesh& mesh, const geometry::MeshQuery& query,
                  std::size_t t, int n, double width, std::optional<double> layerMm,
                  std::vector<ThinPoint>& out) {
  const double area = geometry::triangleArea(mesh, t);
  const Eigen::Vector3d normal = geometry::triangleNormal(mesh, t);
  if (!(area > 0.0) || !(normal.squaredNorm() > 0.5))
    return;
  const Eigen::Vector3d a = mesh.corner(t, 0), u = (mesh.corner(t, 1) - a) / n,
                        v = (mesh.corner(t, 2) - a) / n;
  const auto measure = [&](double x, double y) {
    const Eigen::Vector3d at = a + x * u + y * v;
    const Eigen::Vector3d from = at - 1e-4 * width * normal,
                          to = at - (1.0 - 1e-3) * width * normal;
    const auto hit = query.firstHit(from, to);
    if (!hit || normal.dot(geometry::triangleNormal(
                    mesh, static_cast<std::size_t>(hit->triangle))) > kFacing)
      return;
    const double thickness = (from + hit->t * (to - from) - at).norm();
    if (isThin(thickness, normal, width, layerMm))
      out.push_back({at, thickness, area / (n * n), t});
  };
  // Centres of the n^2 triangles into which it is divided.
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      measure(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j + 1 < n)
        measure(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
}

// Groups adjacent boxes with thin points into one place.
std::vector<std::vector<std::size_t>> places(const std::vector<ThinPoint>& points, double side) {
  using Box = std::array<int, 3>;
  std::map<Box, std::vector<std::size_t>> boxes;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Eigen::Array3i at = (points[p].at / side).array().floor().cast<int>();
    boxes[{at.x(), at.y(), at.z()}].push_back(p);
  }
  std::vector<std::vector<std::size_t>> out;
  while (!boxes.empty()) {
    std::vector<Box> open{boxes.begin()->first};
    std::vector<std::size_t> members;
    while (!open.empty()) {
      const Box at = open.back();
      open.pop_back();
      const auto found = boxes.find(at);
      if (found == boxes.end())
        continue;
      members.insert(members.end(), found->second.begin(), found->second.end());
      boxes.erase(found);
      for (int n = 0; n < 27; ++n)
        open.push_back({at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1});
    }
    std::sort(members.begin(), members.end());
    out.push_back(std::move(members));
  }
  return out;
}

ThinPlace placeOf(const std::vector<ThinPoint>& points, std::vector<std::size_t> members) {
  ThinPlace place;
  std::size_t lastFacet = points.size();
  for (const std::size_t p : members) {
    place.areaMm2 += points[p].area;
    if (place.facets == 0 || points[p].facet != lastFacet)
      ++place.facets;
    lastFacet = points[p].facet;
  }
  std::sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
    return points[a].thickness != points[b].thickness ? points[a].thickness < points[b].thickness
                                                      : a < b;
  });
  place.at = points[members.front()].at;
  place.minMm = points[members.front()].thickness;
  double half = 0.0;
  for (const std::size_t p : members) {
    place.usualMm = points[p].thickness;
    half += points[p].area;
    if (half >= 0.5 * place.areaMm2)
      break;
  }
  return place;
}

} // namespace

std::vector<ThinPlace> thinPlaces(const geometry::TriangleMesh& mesh, double width,
                                  const base::RunContext& ctx, std::optional<double> layerMm) {
  base::require(width > 0.0, "thinPlaces: width > 0");
  const geometry::MeshQuery query(mesh);
  const std::vector<int> parts = divisions(mesh, width);
  constexpr std::size_t kGrain = 256;
  std::vector<std::vector<ThinPoint>> found((mesh.triangles.size() + kGrain - 1) / kGrain);
  base::parallelChunks(ctx, mesh.triangles.size(), kGrain, [&](std::size_t b, std::size_t e) {
    for (std::size_t t = b; t < e && !ctx.cancelled(); ++t)
      measureFacet(mesh, query, t, parts[t], width, layerMm, found[b / kGrain]);
  });
  std::vector<ThinPoint> points;
  for (const auto& chunk : found)
    points.insert(points.end(), chunk.begin(), chunk.end());

  std::vector<ThinPlace> out;
  for (auto& members : places(points, kPlaceCells * width)) {
    const ThinPlace place = placeOf(points, std::move(members));
    if (place.areaMm2 >= width * width)
      out.push_back(place);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const ThinPlace& a, const ThinPlace& b) { return a.areaMm2 > b.areaMm2; });
  return out;
}

} // namespace voluta::voxel
