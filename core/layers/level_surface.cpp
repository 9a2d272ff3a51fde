#include "layers/level_surface.h"

#include "layers/layer_stack.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

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
  if (!s.innerRim.empty())
    s.innerRim.push_back(s.innerRim[ia] & s.innerRim[ib]);
  if (!s.chart.empty())
    s.chart.at.push_back(s.chart.blend(a, b, t));
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
  if (!s.innerRim.empty())
    s.innerRim.push_back(0);
  if (!s.chart.empty())
    s.chart.at.push_back(s.chart.blend(corners, weights));
  return static_cast<int>(s.surface.vertices.size()) - 1;
}

void keepPositive(LevelSurface& s, const std::vector<double>& values) {
  const auto keeps = [&](int v) { return values[static_cast<std::size_t>(v)] >= 0.0; };
  s.innerRim.resize(s.surface.vertices.size(), 0);
  std::unordered_map<std::uint64_t, int> cutOf;
  const auto cut = [&](int a, int b) {
    const auto low = static_cast<std::uint64_t>(std::min(a, b)),
               high = static_cast<std::uint64_t>(std::max(a, b));
    const auto [entry, isNew] = cutOf.try_emplace(low << 32 | high, -1);
    if (isNew) {
      const int from = std::min(a, b), to = std::max(a, b);
      const double u = values[static_cast<std::size_t>(from)],
                   v = values[static_cast<std::size_t>(to)];
      entry->second = appendBlend(s, from, to, u / (u - v));
      s.innerRim.back() = 1;
    }
    return entry->second;
  };
  std::vector<std::array<int, 3>> kept;
  const std::vector<std::array<int, 3>> triangles = std::move(s.surface.triangles);
  for (const auto& t : triangles) {
    const int count = keeps(t[0]) + keeps(t[1]) + keeps(t[2]);
    if (count == 3)
      kept.push_back(t);
    if (count == 0 || count == 3)
      continue;
    std::size_t k = 0; // the corner that differs from the others
    while (keeps(t[k]) != (count == 1))
      ++k;
    const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], ab = cut(a, b), ca = cut(c, a);
    if (count == 1) {
      kept.push_back({a, ab, ca});
    } else {
      kept.push_back({ab, b, c});
      kept.push_back({ab, c, ca});
    }
  }
  s.surface.triangles = std::move(kept);
  dropUnusedVertices(s);
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
    if (!s.innerRim.empty())
      s.innerRim[kept] = s.innerRim[v];
    if (!s.chart.empty())
      s.chart.at[kept] = s.chart.at[v];
    ++kept;
  }
  s.surface.vertices.resize(kept);
  s.thicknessMm.resize(kept);
  s.direction.resize(kept);
  s.clearDirection.resize(kept);
  if (!s.innerRim.empty())
    s.innerRim.resize(kept);
  if (!s.chart.empty())
    s.chart.at.resize(kept);
  for (auto& t : s.surface.triangles)
    for (int& v : t)
      v = index[static_cast<std::size_t>(v)];
}

LevelSurface surfaceOf(const Patch& patch) {
  LevelSurface level;
  level.surface = patch.surface;
  level.thicknessMm = patch.thicknessMm;
  level.direction = patch.direction;
  level.clearDirection = patch.clearDirection;
  level.innerRim = patch.innerRim;
  level.chart = patch.chart;
  level.level = patch.layer;
  return level;
}

void takePlace(Patch& patch, const Patch& of) {
  patch.layer = of.layer;
  patch.group = of.group;
  patch.item = of.item;
  patch.region = of.region;
  patch.tool = of.tool;
}

void setSurface(Patch& patch, LevelSurface surface) {
  patch.surface = std::move(surface.surface);
  patch.thicknessMm = std::move(surface.thicknessMm);
  patch.direction = std::move(surface.direction);
  patch.clearDirection = std::move(surface.clearDirection);
  patch.innerRim = std::move(surface.innerRim);
  patch.chart = std::move(surface.chart);
}

} // namespace voluta::layers
