#include "planar/published/piece_graph.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

namespace voluta::planar {

namespace {

// Returns the contact area of each region with the plate.
std::vector<double> contacts(const geometry::MeshQuery& query, const SurfaceRegions& regions,
                             const Piece& whole, const RiskRule& rule) {
  std::vector<double> out(static_cast<std::size_t>(regions.count), 0.0);
  const geometry::TriangleMesh& fine = whole.solid.mesh;
  const std::vector<std::uint8_t> stands = standsOn(whole, rule);
  for (std::size_t t = 0; t < stands.size(); ++t)
    if (stands[t]) {
      const int at =
          query.closest((fine.corner(t, 0) + fine.corner(t, 1) + fine.corner(t, 2)) / 3.0).triangle;
      out[static_cast<std::size_t>(regions.ofTriangle[static_cast<std::size_t>(at)])] +=
          geometry::triangleArea(fine, t);
    }
  return out;
}

int rootOf(const geometry::MeshQuery& query, const SurfaceRegions& regions,
           const std::vector<double>& contact, const std::optional<Eigen::Vector3d>& root) {
  if (!root)
    return static_cast<int>(std::max_element(contact.begin(), contact.end()) - contact.begin());
  const int triangle = query.closest(*root).triangle;
  const int region = regions.ofTriangle[static_cast<std::size_t>(triangle)];
  if (!(contact[static_cast<std::size_t>(region)] > 0.0))
    throw base::Error(
        base::ErrorCode::UnusableInput,
        base::message("the root at {x:.1f}, {y:.1f}, {z:.1f} mm is not on the plate"_text,
                      base::number(root->x()), base::number(root->y()), base::number(root->z())),
        "pieceRoot"_name,
        "pick a point on a piece that touches the plate, or place the part on the face "
        "to start from"_text);
  return region;
}

} // namespace

PieceGraph pieceGraph(const geometry::TriangleMesh& mesh, const SurfaceRegions& regions,
                      const std::vector<RegionPlane>& planes, const Piece& whole,
                      const RiskRule& rule, const std::optional<Eigen::Vector3d>& root) {
  base::require(regions.count > 0, "pieceGraph: a region at least");
  PieceGraph out;
  const geometry::MeshQuery query(mesh);
  const std::vector<double> contact = contacts(query, regions, whole, rule);
  out.root = rootOf(query, regions, contact, root);
  const auto count = static_cast<std::size_t>(regions.count);
  std::vector<int> place(count, -1);
  const auto visit = [&](int region) {
    int& at = place[static_cast<std::size_t>(region)];
    if (at >= 0)
      return;
    at = static_cast<int>(out.order.size());
    out.order.push_back(region);
  };
  visit(out.root);
  std::vector<int> standing;
  for (std::size_t r = 0; r < count; ++r)
    if (contact[r] > 0.0)
      standing.push_back(static_cast<int>(r));
  std::stable_sort(standing.begin(), standing.end(), [&](int a, int b) {
    return contact[static_cast<std::size_t>(a)] > contact[static_cast<std::size_t>(b)];
  });
  std::for_each(standing.begin(), standing.end(), visit);
  for (std::size_t next = 0; next < out.order.size(); ++next)
    for (const RegionPlane& p : planes) {
      if (p.from == out.order[next])
        visit(p.to);
      else if (p.to == out.order[next])
        visit(p.from);
    }
  const auto placeOf = [&](int region) {
    const int at = place[static_cast<std::size_t>(region)];
    return at < 0 ? regions.count : at;
  };
  for (const RegionPlane& p : planes)
    out.outwards.push_back(placeOf(p.from) <= placeOf(p.to) ? p : reversed(p));
  std::stable_sort(out.outwards.begin(), out.outwards.end(),
                   [&](const RegionPlane& a, const RegionPlane& b) {
                     return std::tuple(placeOf(a.from), placeOf(a.to)) <
                            std::tuple(placeOf(b.from), placeOf(b.to));
                   });
  return out;
}

} // namespace voluta::planar
