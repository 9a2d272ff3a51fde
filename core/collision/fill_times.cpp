#include "collision/fill_times.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace voluta::collision {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {
constexpr std::size_t kRowsAChunk = 256;
} // namespace

FillTimes::FillTimes(const voxel::VoxelGrid& grid, ReversedTimes leads, const base::RunContext& ctx)
    : grid_(grid), leads_(std::move(leads)) {
  base::require(leads_.size() == grid_.cellCount(), "a time for each cell");
  if (leads_.empty())
    return;
  const auto rows = static_cast<std::size_t>(grid_.size.z());
  fromUp_.resize(rows);
  base::parallelChunks(ctx, rows, 1, [&](std::size_t b, std::size_t e) {
    const std::size_t cells = leads_.size() / rows;
    for (std::size_t z = b; z < e; ++z)
      fromUp_[z] =
          kNever - *std::max_element(leads_.begin() + z * cells, leads_.begin() + (z + 1) * cells);
  });
  for (std::size_t z = rows - 1; z-- > 0;)
    fromUp_[z] = std::min(fromUp_[z], fromUp_[z + 1]);
  const ReversedTimes* below = &leads_;
  Vector3i belowSize = grid_.size;
  while (belowSize.maxCoeff() > 1) {
    Level level;
    level.size = (belowSize.array() + 1) / 2;
    level.maximum = ReversedTimes(static_cast<std::size_t>(level.size.x()) *
                                  static_cast<std::size_t>(level.size.y()) *
                                  static_cast<std::size_t>(level.size.z()));
    const auto nx = static_cast<std::size_t>(level.size.x());
    const auto ny = static_cast<std::size_t>(level.size.y());
    const auto mx = static_cast<std::size_t>(belowSize.x());
    const auto my = static_cast<std::size_t>(belowSize.y());
    const auto mz = static_cast<std::size_t>(belowSize.z());
    base::parallelChunks(ctx, ny * static_cast<std::size_t>(level.size.z()), kRowsAChunk,
                         [&](std::size_t b, std::size_t e) {
                           for (std::size_t row = b; row < e; ++row) {
                             const std::size_t j = row % ny, k = row / ny;
                             std::uint32_t* out = level.maximum.begin() + row * nx;
                             for (std::size_t z = 2 * k; z < std::min(mz, 2 * k + 2); ++z)
                               for (std::size_t y = 2 * j; y < std::min(my, 2 * j + 2); ++y) {
                                 const std::uint32_t* in = below->begin() + mx * (y + my * z);
                                 for (std::size_t x = 0; x < mx; ++x)
                                   if (in[x] > out[x / 2])
                                     out[x / 2] = in[x];
                               }
                           }
                         });
    pyramid_.push_back(std::move(level));
    below = &pyramid_.back().maximum;
    belowSize = pyramid_.back().size;
  }
}

namespace {

// Traverses the octree of blocks that contain cells filled in time, nearest first. `signedDistance`
// is that of a solid; the cell centres of a block are within `radius` of its middle.
template <typename EarliestAt, typename Distance> class Descent {
public:
  Descent(const voxel::VoxelGrid& grid, const EarliestAt& earliestAt,
          const Distance& signedDistance, std::uint32_t before)
      : grid_(grid), earliestAt_(earliestAt), signedDistance_(signedDistance), before_(before) {}

  // Returns whether the centre of a filled cell has a signed distance <= margin.
  bool touches(int level, const Vector3i& block, double margin) const {
    const double d = signedDistance_(middle(level, block));
    const double radius = radiusOf(level);
    if (d - radius > margin)
      return false;
    if (level == 0 || d + radius <= margin)
      return true;
    for (int c = 0; c < 8; ++c) {
      const Vector3i child = 2 * block + Vector3i(c & 1, c >> 1 & 1, c >> 2);
      if (earliestAt_(level - 1, child) < before_ && touches(level - 1, child, margin))
        return true;
    }
    return false;
  }

  // Lowers `best` to the smallest signed distance of a filled cell's centre in the block.
  void nearest(int level, const Vector3i& block, double d, double& best) const {
    if (level == 0) {
      best = std::min(best, d);
      return;
    }
    struct Child {
      double distance;
      Vector3i block;
    };
    std::array<Child, 8> children;
    std::size_t count = 0;
    const double radius = radiusOf(level - 1);
    for (int c = 0; c < 8; ++c) {
      const Vector3i child = 2 * block + Vector3i(c & 1, c >> 1 & 1, c >> 2);
      if (earliestAt_(level - 1, child) >= before_)
        continue;
      const double distance = signedDistance_(middle(level - 1, child));
      if (distance - radius >= best)
        continue;
      std::size_t place = count++;
      for (; place > 0 && children[place - 1].distance > distance; --place)
        children[place] = children[place - 1];
      children[place] = {distance, child};
    }
    for (std::size_t c = 0; c < count; ++c)
      if (children[c].distance - radius < best && best > 0.0)
        nearest(level - 1, children[c].block, children[c].distance, best);
  }

  Vector3d middle(int level, const Vector3i& block) const {
    const double cells = static_cast<double>(1 << level);
    return grid_.origin + grid_.pitch * cells * (block.cast<double>() + Vector3d::Constant(0.5));
  }

private:
  double radiusOf(int level) const {
    constexpr double halfDiagonal = 0.8660254037844387; // sqrt(3) / 2
    return level == 0 ? 0.0 : halfDiagonal * grid_.pitch * static_cast<double>((1 << level) - 1);
  }

  const voxel::VoxelGrid& grid_;
  const EarliestAt& earliestAt_;
  const Distance& signedDistance_;
  std::uint32_t before_;
};

} // namespace

std::uint32_t FillTimes::earliestAt(int level, const Vector3i& block) const {
  const auto at = [&](const Vector3i& size, const ReversedTimes& maximum) {
    if (block.x() >= size.x() || block.y() >= size.y() || block.z() >= size.z())
      return kNever;
    return kNever -
           maximum[static_cast<std::size_t>(block.x()) +
                   static_cast<std::size_t>(size.x()) *
                       (static_cast<std::size_t>(block.y()) +
                        static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(block.z()))];
  };
  if (level == 0)
    return at(grid_.size, leads_);
  const Level& l = pyramid_[static_cast<std::size_t>(level) - 1];
  return at(l.size, l.maximum);
}

bool FillTimes::holds(const Eigen::Vector3d& point, std::uint32_t before) const {
  const Eigen::Vector3i c = grid_.cellOf(point);
  return grid_.contains(c.x(), c.y(), c.z()) && filledAt(grid_.index(c.x(), c.y(), c.z())) < before;
}

double FillTimes::topBefore(std::uint32_t before) const {
  // The times increase with height.
  const auto end = std::ranges::partition_point(
      fromUp_, [before](std::uint32_t earliest) { return earliest < before; });
  return grid_.centre(0, 0, static_cast<int>(end - fromUp_.begin()) - 1).z();
}

template <typename Distance>
bool FillTimes::touches(const Distance& signedDistance, double lowestMm, double marginMm,
                        std::uint32_t before) const {
  const auto earliestFilled = [this](int level, const Vector3i& b) { return earliestAt(level, b); };
  const int top = static_cast<int>(pyramid_.size());
  if (earliestAt(top, Vector3i::Zero()) >= before)
    return false;
  // Cells below the lowest point of the grown solid cannot be inside it.
  constexpr double kRounding = 1e-6;
  if (topBefore(before) < lowestMm - marginMm - kRounding)
    return false;
  return Descent(grid_, earliestFilled, signedDistance, before)
      .touches(top, Vector3i::Zero(), marginMm);
}

bool FillTimes::touches(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape,
                        double marginMm, std::uint32_t before) const {
  if (leads_.empty())
    return false;
  const double lowest = work_T_shape.translation().z() -
                        support(shape, work_T_shape.linear().transpose() * -Vector3d::UnitZ());
  const PlacedShape placed = place(shape, work_T_shape);
  return std::visit(
      [&](const auto& s) {
        return touches([&s](const Vector3d& p) { return s.signedDistance(p); }, lowest, marginMm,
                       before);
      },
      placed);
}

bool FillTimes::touches(const Revolved& solid, const Eigen::Isometry3d& work_T_solid,
                        double marginMm, std::uint32_t before) const {
  if (leads_.empty())
    return false;
  const Vector3d origin = work_T_solid.translation(), axis = work_T_solid.linear().col(2);
  return touches(
      [&](const Vector3d& p) {
        const Vector3d r = p - origin;
        const double z = r.dot(axis);
        return solid.signedDistance(std::sqrt(std::max(0.0, r.squaredNorm() - z * z)), z);
      },
      origin.z() + solid.lowest(axis), marginMm, before);
}

double FillTimes::distance(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape,
                           double capMm, std::uint32_t before) const {
  if (leads_.empty())
    return capMm;
  const auto earliestFilled = [this](int level, const Vector3i& b) { return earliestAt(level, b); };
  const int top = static_cast<int>(pyramid_.size());
  if (earliestAt(top, Vector3i::Zero()) >= before)
    return capMm;
  const PlacedShape placed = place(shape, work_T_shape);
  double best = capMm;
  std::visit(
      [&](const auto& s) {
        const auto signedDistanceTo = [&s](const Vector3d& p) { return s.signedDistance(p); };
        const Descent descent(grid_, earliestFilled, signedDistanceTo, before);
        descent.nearest(top, Vector3i::Zero(),
                        signedDistanceTo(descent.middle(top, Vector3i::Zero())), best);
      },
      placed);
  return std::max(0.0, best);
}

} // namespace voluta::collision
