#include "regions/closed_contour.h"

#include "base/error.h"
#include "base/parallel.h"
#include "curved/cell_contour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace voluta::regions {

namespace {
using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr int kBlock = 8; // cells per side of a block, which is tested as one first
// Vertices keep this share of an edge from its ends, so that no triangle is without area.
constexpr double kFromEnd = 0.01;

// The values at the points of a grid. Points of a block that is positive throughout are positive.
class Values {
public:
  Values(const std::function<double(const Vector3d&)>& value, const Eigen::AlignedBox3d& box,
         double gridMm, const base::RunContext& ctx)
      : low_(box.min()), gridMm_(gridMm) {
    for (int k = 0; k < 3; ++k)
      size_[k] = kBlock * static_cast<int>(std::ceil(box.sizes()[k] / (kBlock * gridMm)));
    points_ = size_ + Vector3i::Ones();
    at_.assign(static_cast<std::size_t>(points_.x()) * static_cast<std::size_t>(points_.y()) *
                   static_cast<std::size_t>(points_.z()),
               1.0);
    const Vector3i blocks = size_ / kBlock;
    const auto count = static_cast<std::size_t>(blocks.prod());
    // A block sets the points of its low sides only; the last ones are outside.
    base::parallelChunks(ctx, count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        const int i = static_cast<int>(b);
        const Vector3i first = kBlock * Vector3i(i % blocks.x(), i / blocks.x() % blocks.y(),
                                                 i / (blocks.x() * blocks.y()));
        const double reach = 0.5 * std::sqrt(3.0) * kBlock * gridMm;
        if (value(place(first) + Vector3d::Constant(0.5 * kBlock * gridMm)) > reach)
          continue;
        for (int z = 0; z < kBlock; ++z)
          for (int y = 0; y < kBlock; ++y)
            for (int x = 0; x < kBlock; ++x) {
              const Vector3i at = first + Vector3i(x, y, z);
              at_[index(at)] = value(place(at));
            }
      }
    });
  }

  const Vector3i& size() const { return size_; } // in cells
  Vector3d place(const Vector3i& at) const { return low_ + gridMm_ * at.cast<double>(); }
  std::size_t index(const Vector3i& at) const {
    return (static_cast<std::size_t>(at.z()) * static_cast<std::size_t>(points_.y()) +
            static_cast<std::size_t>(at.y())) *
               static_cast<std::size_t>(points_.x()) +
           static_cast<std::size_t>(at.x());
  }
  double operator()(const Vector3i& at) const { return at_[index(at)]; }

private:
  Vector3d low_;
  double gridMm_;
  Vector3i size_ = Vector3i::Zero(), points_ = Vector3i::Zero();
  std::vector<double> at_;
};

Vector3i cornerOf(const Vector3i& cell, int c) {
  return cell + Vector3i(c & 1, c >> 1 & 1, c >> 2);
}

class Contour {
public:
  explicit Contour(const Values& values) : values_(values) {}

  void add(const Vector3i& cell) {
    std::uint8_t below = 0;
    for (int c = 0; c < 8; ++c)
      if (values_(cornerOf(cell, c)) < 0.0)
        below = static_cast<std::uint8_t>(below | (1u << c));
    for (const std::vector<int>& loop : curved::cubeLoops(below)) {
      std::vector<int> ring;
      for (const int edge : loop)
        ring.push_back(vertexOn(cell, edge));
      // Around the middle: a diagonal could coincide with one of the neighbouring cube.
      const int middle = ring.size() == 3 ? -1 : middleOf(ring);
      if (middle < 0)
        mesh_.triangles.push_back({ring[0], ring[1], ring[2]});
      for (std::size_t i = 0; middle >= 0 && i < ring.size(); ++i)
        mesh_.triangles.push_back({middle, ring[i], ring[(i + 1) % ring.size()]});
    }
  }

  geometry::TriangleMesh take() { return std::move(mesh_); }

private:
  int vertexOn(const Vector3i& cell, int edge) {
    const curved::CubeEdge ends = curved::cubeEdges()[static_cast<std::size_t>(edge)];
    const Vector3i a = cornerOf(cell, ends.from), b = cornerOf(cell, ends.to);
    const auto key = std::minmax({values_.index(a), values_.index(b)});
    const auto [known, isNew] =
        vertexOf_.try_emplace({key.first, key.second}, static_cast<int>(mesh_.vertices.size()));
    if (isNew) {
      const double from = values_(a), to = values_(b);
      const double t = std::clamp(from / (from - to), kFromEnd, 1.0 - kFromEnd);
      mesh_.vertices.emplace_back((1.0 - t) * values_.place(a) + t * values_.place(b));
    }
    return known->second;
  }

  int middleOf(const std::vector<int>& ring) {
    Vector3d sum = Vector3d::Zero();
    for (const int v : ring)
      sum += mesh_.vertices[static_cast<std::size_t>(v)];
    mesh_.vertices.emplace_back(sum / static_cast<double>(ring.size()));
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }

  const Values& values_;
  geometry::TriangleMesh mesh_;
  std::map<std::pair<std::size_t, std::size_t>, int> vertexOf_;
};
} // namespace

geometry::TriangleMesh closedContour(const std::function<double(const Vector3d&)>& value,
                                     const Eigen::AlignedBox3d& box, double gridMm,
                                     const base::RunContext& ctx) {
  base::require(gridMm > 0.0 && !box.isEmpty(), "a grid in a box");
  const Values values(value, box, gridMm, ctx);
  Contour contour(values);
  const Vector3i n = values.size();
  for (int z = 0; z < n.z(); ++z)
    for (int y = 0; y < n.y(); ++y)
      for (int x = 0; x < n.x(); ++x)
        contour.add({x, y, z});
  return contour.take();
}

} // namespace voluta::regions
