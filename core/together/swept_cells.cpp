#include "together/swept_cells.h"

#include "collision/growing_part.h"
#include "collision/shape_distance.h"
#include "plan/trajectory.h"
#include "robot/body.h"
#include "robot/cell.h"
#include "together/poses.h"

#include <algorithm>
#include <cmath>

namespace voluta::together {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {
AlignedBox3d boxAround(const MovedShape& moved, const Isometry3d& shared_T_frame) {
  if (const auto* capsule = std::get_if<robot::Capsule>(&moved.shape)) {
    AlignedBox3d box(Vector3d(shared_T_frame * capsule->p0));
    box.extend(Vector3d(shared_T_frame * capsule->p1));
    const Vector3d r = Vector3d::Constant(capsule->radius);
    return {Vector3d(box.min() - r), Vector3d(box.max() + r)};
  }
  const Vector3d centre = shared_T_frame * moved.ball.centre,
                 r = Vector3d::Constant(moved.ball.radius);
  return {Vector3d(centre - r), Vector3d(centre + r)};
}

MovedShape movedShape(int frame, const robot::Shape& shape) {
  return {frame, shape, collision::boundingBall(collision::place(shape, Isometry3d::Identity()))};
}
} // namespace

std::optional<std::size_t> commonCell(const SweptCells& a, const SweptCells& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (i->first < j->first)
      ++i;
    else if (j->first < i->first)
      ++j;
    else if (const std::uint64_t both = i->second & j->second; both != 0)
      return std::size_t{64} * i->first + static_cast<std::size_t>(__builtin_ctzll(both));
    else
      ++i, ++j;
  }
  return std::nullopt;
}

std::vector<MovedShape> movedShapes(const PlacedMotion& machine) {
  std::vector<MovedShape> moved;
  for (const robot::Body& body : machine.cell->bodies())
    if (isMoved(*machine.cell, body))
      for (const robot::Shape& shape : body.shapes)
        moved.push_back(movedShape(body.frame, shape));
  const AlignedBox3d part = machine.part->bounds();
  if (isPartMoved(*machine.cell) && !part.isEmpty()) {
    Isometry3d work_T_box = Isometry3d::Identity();
    work_T_box.translation() = part.center();
    moved.push_back(movedShape(machine.cell->workFrame(),
                               robot::Box{work_T_box, Vector3d(0.5 * part.sizes())}));
  }
  return moved;
}

AlignedBox3d boxOf(const PlacedMotion& machine, const std::vector<MovedShape>& shapes) {
  constexpr double kStepMm = 10.0;
  AlignedBox3d all;
  visitPoses(machine, 0, machine.trajectory->pointCount() - 1, kStepMm, [&](const Frames& frames) {
    for (const MovedShape& moved : shapes)
      all.extend(boxAround(moved, frames[static_cast<std::size_t>(moved.frame)]));
  });
  const Vector3d between = Vector3d::Constant(0.5 * kStepMm);
  return {Vector3d(all.min() - between), Vector3d(all.max() + between)};
}

Sweeper::Sweeper(const PlacedMotion& machine, const std::vector<MovedShape>& shapes,
                 const voxel::VoxelGrid& grid, double clearanceMm)
    : machine_(machine), shapes_(shapes), grid_(grid),
      reachMm_(0.5 * clearanceMm + kSweepStepMm + 0.5 * std::sqrt(3.0) * grid.pitch),
      words_((grid.cellCount() + 63) / 64, 0) {}

SweptCells Sweeper::sweep(std::size_t first, std::size_t last) {
  std::vector<std::optional<Isometry3d>> marked(shapes_.size()); // pose of each when last marked
  visitPoses(machine_, first, last, kSweepStepMm, [&](const Frames& frames) {
    for (std::size_t s = 0; s < shapes_.size(); ++s) {
      const MovedShape& moved = shapes_[s];
      const Isometry3d& pose = frames[static_cast<std::size_t>(moved.frame)];
      if (marked[s] && displacementOf(moved.ball, *marked[s], pose) <= kSweepStepMm)
        continue;
      marked[s] = pose;
      mark(collision::place(moved.shape, pose), boxAround(moved, pose));
    }
  });
  std::ranges::sort(used_);
  SweptCells cells;
  cells.reserve(used_.size());
  for (const std::uint32_t word : used_)
    cells.emplace_back(word, std::exchange(words_[word], 0));
  used_.clear();
  return cells;
}

void Sweeper::mark(const collision::PlacedShape& shape, const AlignedBox3d& box) {
  const Vector3d reach = Vector3d::Constant(reachMm_);
  const Vector3i low = grid_.cellOf(box.min() - reach).cwiseMax(0);
  const Vector3i high = grid_.cellOf(box.max() + reach).cwiseMin(grid_.size - Vector3i::Ones());
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j)
      for (int i = low.x(); i <= high.x();) {
        const double beyond = collision::signedDistance(shape, grid_.centre(i, j, k)) - reachMm_;
        if (beyond > 0.0) { // the next cells along x cannot be nearer than this
          i += std::max(1, static_cast<int>(beyond / grid_.pitch));
          continue;
        }
        const std::size_t cell = grid_.index(i, j, k);
        std::uint64_t& word = words_[cell / 64];
        if (word == 0)
          used_.push_back(static_cast<std::uint32_t>(cell / 64));
        word |= std::uint64_t{1} << (cell % 64);
        ++i;
      }
}

} // namespace voluta::together
