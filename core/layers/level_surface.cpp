#include "layers/level_surface.h"

namespace voluta::layers {

namespace {

Eigen::Vector3d unitOr(const Eigen::Vector3d& v, const Eigen::Vector3d& otherwise) {
  const double n = v.norm();
  return n > 1e-9 ? Eigen::Vector3d(v / n) : otherwise;
}

} // namespace

int appendBlend(LevelSurface& s, int a, int b, double t) {
  const auto ia = static_cast<std::size_t>(a), ib = static_cast<std::size_t>(b);
  const auto mix = [&](const auto& from) -> Eigen::Vector3d {
    return (1.0 - t) * from[ia] + t * from[ib];
  };
  const Eigen::Vector3d p = mix(s.surface.vertices);
  const Eigen::Vector3d d = unitOr(mix(s.direction), s.direction[ia]);
  const Eigen::Vector3d c = unitOr(mix(s.clearDirection), s.clearDirection[ia]);
  s.surface.vertices.push_back(p);
  s.thicknessMm.push_back((1.0 - t) * s.thicknessMm[ia] + t * s.thicknessMm[ib]);
  s.direction.push_back(d);
  s.clearDirection.push_back(c);
  return static_cast<int>(s.surface.vertices.size()) - 1;
}

int appendBlend(LevelSurface& s, const std::array<int, 3>& corners, const Eigen::Vector3d& weights,
                const Eigen::Vector3d& position) {
  double thickness = 0.0;
  Eigen::Vector3d d = Eigen::Vector3d::Zero(), c = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(corners[static_cast<std::size_t>(k)]);
    thickness += weights[k] * s.thicknessMm[i];
    d += weights[k] * s.direction[i];
    c += weights[k] * s.clearDirection[i];
  }
  const auto first = static_cast<std::size_t>(corners[0]);
  d = unitOr(d, s.direction[first]);
  c = unitOr(c, s.clearDirection[first]);
  s.surface.vertices.push_back(position);
  s.thicknessMm.push_back(thickness);
  s.direction.push_back(d);
  s.clearDirection.push_back(c);
  return static_cast<int>(s.surface.vertices.size()) - 1;
}

void dropUnusedVertices(LevelSurface& s) {
  const std::size_t n = s.surface.vertices.size();
  std::vector<int> index(n, -1);
  for (const auto& t : s.surface.triangles)
    for (int v : t)
      index[static_cast<std::size_t>(v)] = 0;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < n; ++v) {
    if (index[v] < 0)
      continue;
    index[v] = static_cast<int>(kept);
    s.surface.vertices[kept] = s.surface.vertices[v];
    s.thicknessMm[kept] = s.thicknessMm[v];
    s.direction[kept] = s.direction[v];
    s.clearDirection[kept] = s.clearDirection[v];
    ++kept;
  }
  s.surface.vertices.resize(kept);
  s.thicknessMm.resize(kept);
  s.direction.resize(kept);
  s.clearDirection.resize(kept);
  for (auto& t : s.surface.triangles)
    for (int& v : t)
      v = index[static_cast<std::size_t>(v)];
}

} // namespace voluta::layers
