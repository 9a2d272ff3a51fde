#include "planar/slicing/section.h"

#include "base/error.h"
#include "base/index.h"
#include "geometry/measures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr double kOnPlane = 1e-9; // of the mesh's size

} // namespace

double areaOf(const Section& section) {
  if (section.empty())
    return 0.0;
  const Vector3d& middle = section.points.front();
  double twice = 0.0;
  for (const auto& e : section.edges)
    twice += section.plane.normal.dot(
        (section.points[base::at(e[0])] - middle).cross(section.points[base::at(e[1])] - middle));
  return 0.5 * twice;
}

Sections::Sections(const geometry::TriangleMesh& closed, const Vector3d& normal)
    : mesh_(closed), normal_(normal) {
  base::require(!closed.empty(), "Sections: a mesh with triangles");
  height_.reserve(closed.vertices.size());
  for (const Vector3d& v : closed.vertices)
    height_.push_back(normal.dot(v));
  lowest_ = highest_ = height_[base::at(closed.triangles.front()[0])];
  for (const auto& t : closed.triangles)
    for (const int v : t) {
      lowest_ = std::min(lowest_, height_[base::at(v)]);
      highest_ = std::max(highest_, height_[base::at(v)]);
    }
  onPlane_ = kOnPlane * geometry::bounds(closed).diagonal().norm();

  const auto count = std::clamp<std::size_t>(closed.triangles.size() / 16, 1, 1000);
  slab_ = std::max((highest_ - lowest_) / static_cast<double>(count), 1e-9);
  slabs_.resize(count);
  const auto slabOf = [&](double h) {
    return std::clamp(static_cast<int>((h - lowest_) / slab_), 0, static_cast<int>(count) - 1);
  };
  for (std::size_t i = 0; i < closed.triangles.size(); ++i) {
    const auto& t = closed.triangles[i];
    const auto [low, high] =
        std::minmax({height_[base::at(t[0])], height_[base::at(t[1])], height_[base::at(t[2])]});
    for (int s = slabOf(low - onPlane_); s <= slabOf(high + onPlane_); ++s)
      slabs_[base::at(s)].push_back(static_cast<int>(i));
  }
}

Section Sections::at(double offsetMm) const {
  Section out;
  out.plane = {normal_, offsetMm};
  if (offsetMm < lowest_ - onPlane_ || offsetMm > highest_ + onPlane_)
    return out;
  const auto heightOf = [&](int v) {
    const double h = height_[base::at(v)] - offsetMm;
    return std::abs(h) <= onPlane_ ? 0.0 : h;
  };
  std::unordered_map<std::uint64_t, int> known; // points by their edge, or by twice the vertex
  const auto pointOf = [&](int a, int b) {
    if (a > b)
      std::swap(a, b);
    const double ha = heightOf(a), hb = heightOf(b);
    if (ha == 0.0)
      b = a;
    else if (hb == 0.0)
      a = b;
    const std::uint64_t key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32U |
                              static_cast<std::uint32_t>(b);
    const auto [found, fresh] = known.try_emplace(key, static_cast<int>(out.points.size()));
    if (fresh) {
      const Vector3d &p = mesh_.vertices[base::at(a)], &q = mesh_.vertices[base::at(b)];
      out.points.push_back(a == b ? p : Vector3d(p + ha / (ha - hb) * (q - p)));
    }
    return found->second;
  };
  const int slab = std::clamp(static_cast<int>((offsetMm - lowest_) / slab_), 0,
                              static_cast<int>(slabs_.size()) - 1);
  for (const int i : slabs_[base::at(slab)]) {
    const auto& t = mesh_.triangles[base::at(i)];
    int first = -1, last = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const bool from = heightOf(a) >= 0.0, to = heightOf(b) >= 0.0;
      if (from && !to)
        first = pointOf(a, b);
      else if (!from && to)
        last = pointOf(a, b);
    }
    if (first >= 0 && first != last)
      out.edges.push_back({first, last});
  }
  return out;
}

} // namespace voluta::planar
