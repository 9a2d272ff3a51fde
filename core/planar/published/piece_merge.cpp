#include "planar/published/piece_merge.h"

#include <algorithm>
#include <array>
#include <map>

namespace voluta::planar {

namespace {

using Place = std::array<double, 3>;
Place placeOf(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

} // namespace

std::optional<Piece> merged(const Piece& lower, const Piece& upper) {
  constexpr double kBelowMm = 1e-6;
  const std::int32_t tag = upper.baseTag;
  if (std::find(lower.solid.tag.begin(), lower.solid.tag.end(), tag) == lower.solid.tag.end())
    return std::nullopt;
  if (std::any_of(upper.solid.mesh.vertices.begin(), upper.solid.mesh.vertices.end(),
                  [&](const Eigen::Vector3d& v) { return lower.base.heightOf(v) < -kBelowMm; }) ||
      std::find(upper.solid.tag.begin(), upper.solid.tag.end(), kOnPrinted) !=
          upper.solid.tag.end())
    return std::nullopt;
  std::map<Place, int> joined; // points of the section on the side of `lower`
  Piece out;
  out.base = lower.base;
  out.baseTag = lower.baseTag;
  out.solid.mesh.vertices = lower.solid.mesh.vertices;
  std::size_t below = 0;
  for (std::size_t t = 0; t < lower.solid.tag.size(); ++t) {
    if (lower.solid.tag[t] != tag) {
      out.solid.mesh.triangles.push_back(lower.solid.mesh.triangles[t]);
      out.solid.tag.push_back(lower.solid.tag[t]);
      continue;
    }
    ++below;
    for (int k = 0; k < 3; ++k)
      joined.emplace(placeOf(lower.solid.mesh.corner(t, k)),
                     lower.solid.mesh.triangles[t][static_cast<std::size_t>(k)]);
  }
  std::vector<int> index(upper.solid.mesh.vertices.size(), -1);
  std::size_t above = 0;
  for (std::size_t t = 0; t < upper.solid.tag.size(); ++t) {
    if (upper.solid.tag[t] != tag)
      continue;
    ++above;
    for (int k = 0; k < 3; ++k) {
      const auto at = joined.find(placeOf(upper.solid.mesh.corner(t, k)));
      if (at == joined.end())
        return std::nullopt;
      index[static_cast<std::size_t>(upper.solid.mesh.triangles[t][static_cast<std::size_t>(k)])] =
          at->second;
    }
  }
  if (above != below || above == 0)
    return std::nullopt;
  for (std::size_t t = 0; t < upper.solid.tag.size(); ++t) {
    if (upper.solid.tag[t] == tag)
      continue;
    std::array<int, 3> corners = upper.solid.mesh.triangles[t];
    for (int& v : corners) {
      int& known = index[static_cast<std::size_t>(v)];
      if (known < 0) {
        known = static_cast<int>(out.solid.mesh.vertices.size());
        out.solid.mesh.vertices.push_back(upper.solid.mesh.vertices[static_cast<std::size_t>(v)]);
      }
      v = known;
    }
    out.solid.mesh.triangles.push_back(corners);
    out.solid.tag.push_back(upper.solid.tag[t]);
  }
  return isClosed(out.solid.mesh) ? std::optional(std::move(out)) : std::nullopt;
}

} // namespace voluta::planar
