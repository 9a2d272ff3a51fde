#include "regions/closed_contour.h"

#include "base/error.h"
#include "base/parallel.h"
#include "curved/cell_contour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace voluta::regions {

namespace {
using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr int kBlock = 8; // cells per side of a block, which is tested as one first
// Vertices keep this share of an edge from its ends, so that no triangle is without area.
constexpr double kFromEnd = 0.01;

// The values at the points of a grid, block by block. Blocks that are positive throughout have
// none.
class Values {
public:
  Values(const BoundedFunction& function, const Eigen::AlignedBox3d& box, double gridMm,
         const base::RunContext& ctx)
      : low_(box.min()), gridMm_(gridMm) {
    for (int k = 0; k < 3; ++k)
      blocks_[k] = std::max(1, static_cast<int>(std::ceil(box.sizes()[k] / (kBlock * gridMm))));
    of_.resize(static_cast<std::size_t>(blocks_.x()) * static_cast<std::size_t>(blocks_.y()) *
               static_cast<std::size_t>(blocks_.z()));
    base::parallelChunks(ctx, of_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        const Vector3i first = firstCell(b);
        const double reach = 0.5 * std::sqrt(3.0) * kBlock * gridMm;
        if (function.bound(place(first) + Vector3d::Constant(0.5 * kBlock * gridMm)) > reach)
          continue;
        for (int z = 0; z < kPoints; ++z)
          for (int y = 0; y < kPoints; ++y)
            for (int x = 0; x < kPoints; ++x)
              of_[b].push_back(function.value(place(first + Vector3i(x, y, z))));
      }
    });
  }

  std::size_t blocks() const { return of_.size(); }
  bool isEmpty(std::size_t block) const { return of_[block].empty(); }
  Vector3i firstCell(std::size_t block) const {
    const auto nx = static_cast<std::size_t>(blocks_.x()),
               ny = static_cast<std::size_t>(blocks_.y());
    return kBlock * Vector3i(static_cast<int>(block % nx), static_cast<int>(block / nx % ny),
                             static_cast<int>(block / (nx * ny)));
  }
  Vector3d place(const Vector3i& at) const { return low_ + gridMm_ * at.cast<double>(); }
  // Returns the number of a point of the grid.
  std::uint64_t number(const Vector3i& at) const {
    const Vector3i points = kBlock * blocks_ + Vector3i::Ones();
    return (static_cast<std::uint64_t>(at.z()) * static_cast<std::uint64_t>(points.y()) +
            static_cast<std::uint64_t>(at.y())) *
               static_cast<std::uint64_t>(points.x()) +
           static_cast<std::uint64_t>(at.x());
  }
  // Returns the value at a point of a block that has values; `in`: from its first cell.
  double at(std::size_t block, const Vector3i& in) const {
    return of_[block][static_cast<std::size_t>((in.z() * kPoints + in.y()) * kPoints + in.x())];
  }

private:
  static constexpr int kPoints = kBlock + 1; // per side of a block
  Vector3d low_;
  double gridMm_;
  Vector3i blocks_ = Vector3i::Zero();
  std::vector<std::vector<double>> of_;
};

Vector3i cornerOf(const Vector3i& cell, int c) {
  return cell + Vector3i(c & 1, c >> 1 & 1, c >> 2);
}

class Contour {
public:
  explicit Contour(const Values& values) : values_(values) {}

  void addBlock(std::size_t block) {
    for (int z = 0; z < kBlock; ++z)
      for (int y = 0; y < kBlock; ++y)
        for (int x = 0; x < kBlock; ++x)
          add(block, {x, y, z});
  }

  geometry::TriangleMesh take() { return std::move(mesh_); }

private:
  // `cell`: from the first one of the block.
  void add(std::size_t block, const Vector3i& cell) {
    std::uint8_t below = 0;
    for (int c = 0; c < 8; ++c)
      if (values_.at(block, cornerOf(cell, c)) < 0.0)
        below = static_cast<std::uint8_t>(below | (1u << c));
    for (const std::vector<int>& loop : curved::cubeLoops(below)) {
      std::vector<int> ring;
      for (const int edge : loop)
        ring.push_back(vertexOn(block, cell, edge));
      if (ring.size() == 3) {
        mesh_.triangles.push_back({ring[0], ring[1], ring[2]});
        continue;
      }
      // Around the middle: a diagonal could coincide with one of the neighbouring cube.
      const int middle = middleOf(ring);
      for (std::size_t i = 0; i < ring.size(); ++i)
        mesh_.triangles.push_back({middle, ring[i], ring[(i + 1) % ring.size()]});
    }
  }

  int vertexOn(std::size_t block, const Vector3i& cell, int edge) {
    const curved::CubeEdge ends = curved::cubeEdges()[static_cast<std::size_t>(edge)];
    const Vector3i a = cornerOf(cell, ends.from), b = cornerOf(cell, ends.to);
    const Vector3i first = values_.firstCell(block);
    // An edge begins at its point of the lower number, along one of three axes.
    int axis = 0;
    (a - b).cwiseAbs().maxCoeff(&axis);
    const std::uint64_t key = 3 * std::min(values_.number(first + a), values_.number(first + b)) +
                              static_cast<std::uint64_t>(axis);
    const auto [known, isNew] = vertexOf_.try_emplace(key, static_cast<int>(mesh_.vertices.size()));
    if (isNew) {
      const double from = values_.at(block, a), to = values_.at(block, b);
      const double t = std::clamp(from / (from - to), kFromEnd, 1.0 - kFromEnd);
      mesh_.vertices.emplace_back((1.0 - t) * values_.place(first + a) +
                                  t * values_.place(first + b));
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
  std::unordered_map<std::uint64_t, int> vertexOf_; // by edge
};
} // namespace

geometry::TriangleMesh closedContour(const BoundedFunction& function,
                                     const Eigen::AlignedBox3d& box, double gridMm,
                                     const base::RunContext& ctx) {
  base::require(gridMm > 0.0 && !box.isEmpty(), "a grid in a box");
  const Values values(function, box, gridMm, ctx);
  Contour contour(values);
  for (std::size_t block = 0; block < values.blocks(); ++block)
    if (!values.isEmpty(block)) {
      ctx.checkpoint();
      contour.addBlock(block);
    }
  return contour.take();
}

} // namespace voluta::regions
