#include "together/conflicts.h"

#include "base/parallel.h"
#include "together/swept_cells.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace voluta::together {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

namespace {
constexpr double kMaxCells = 1 << 27;

// Swept cells of all segments and all rests of a machine.
struct Sweeps {
  std::vector<SweptCells> segment, rest;
};

Sweeps sweepsOf(const PlacedMotion& machine, const std::vector<MovedShape>& shapes,
                const Rests& rests, const voxel::VoxelGrid& grid, double clearanceMm,
                const base::RunContext& ctx) {
  Sweeps sweeps{std::vector<SweptCells>(rests.segments()),
                std::vector<SweptCells>(rests.point.size())};
  if (grid.cellCount() == 0)
    return sweeps;
  constexpr std::size_t kGrain = 8;
  base::parallelChunks(ctx, rests.point.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Sweeper sweeper(machine, shapes, grid, clearanceMm);
    for (std::size_t i = begin; i < end; ++i) {
      ctx.checkpoint();
      sweeps.rest[i] = sweeper.sweep(rests.point[i], rests.point[i]);
      if (i < rests.segments())
        sweeps.segment[i] = sweeper.sweep(rests.point[i], rests.point[i + 1]);
    }
  });
  return sweeps;
}

// A grid over the space that both can reach; without cells if there is none.
voxel::VoxelGrid commonGrid(const AlignedBox3d& a, const AlignedBox3d& b, double clearanceMm) {
  voxel::VoxelGrid grid;
  grid.pitch = kSweptCellMm;
  const Vector3d reach = Vector3d::Constant(clearanceMm);
  const AlignedBox3d box =
      AlignedBox3d(Vector3d(a.min() - reach), Vector3d(a.max() + reach))
          .intersection({Vector3d(b.min() - reach), Vector3d(b.max() + reach)});
  if (box.isEmpty())
    return grid;
  grid.pitch = std::max(grid.pitch, std::cbrt(box.volume() / kMaxCells));
  grid.origin = box.min();
  grid.size = (box.sizes() / grid.pitch).array().ceil().max(1.0).matrix().cast<int>();
  return grid;
}
} // namespace

FoundConflicts conflictsOf(const PlacedMotion& a, const Rests& aRests, const PlacedMotion& b,
                           const Rests& bRests, const Distances& distances,
                           const base::RunContext& ctx) {
  const std::vector<MovedShape> aShapes = movedShapes(a), bShapes = movedShapes(b);
  const voxel::VoxelGrid grid =
      commonGrid(boxOf(a, aShapes), boxOf(b, bShapes), distances.clearanceMm);
  const double mm = distances.clearanceMm;
  const auto aSwept =
      std::make_shared<const Sweeps>(sweepsOf(a, aShapes, aRests, grid, mm, ctx.sub(0.0, 0.3)));
  const auto bSwept =
      std::make_shared<const Sweeps>(sweepsOf(b, bShapes, bRests, grid, mm, ctx.sub(0.3, 0.6)));
  FoundConflicts found;
  found.ofA = staticConflicts(a, aRests, b, distances.still, ctx.sub(0.6, 0.75));
  found.ofB = staticConflicts(b, bRests, a, distances.still, ctx.sub(0.75, 0.9));
  const std::size_t m = aRests.segments(), n = bRests.segments();
  Conflicts& table = found.table;
  table = {m, n, Flags(m, n), Flags(m + 1, n), Flags(m, n + 1)};
  const auto &aFilled = aRests.filledFrom, &bFilled = bRests.filledFrom;
  base::parallelChunks(ctx, m + 1, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = 0; j <= n; ++j) {
        if (j < n &&
            (found.ofA.restMeets[i] <= bFilled[j + 1] || found.ofB.segmentMeets[j] <= aFilled[i] ||
             commonCell(aSwept->rest[i], bSwept->segment[j])))
          table.aRests.set(i, j);
        if (i < m &&
            (found.ofA.segmentMeets[i] <= bFilled[j] || found.ofB.restMeets[j] <= aFilled[i + 1] ||
             commonCell(aSwept->segment[i], bSwept->rest[j])))
          table.bRests.set(i, j);
        if (i < m && j < n &&
            (found.ofA.segmentMeets[i] <= bFilled[j + 1] ||
             found.ofB.segmentMeets[j] <= aFilled[i + 1] ||
             commonCell(aSwept->segment[i], bSwept->segment[j])))
          table.moving.set(i, j);
      }
  });
  const auto middleOf = [grid](std::optional<std::size_t> cell) -> std::optional<Vector3d> {
    if (!cell)
      return std::nullopt;
    const Eigen::Vector3i at = grid.cell(*cell);
    return grid.centre(at.x(), at.y(), at.z());
  };
  found.atStart = middleOf(commonCell(aSwept->rest.front(), bSwept->rest.front()));
  found.place = [aSwept, bSwept, middleOf](std::size_t i, std::size_t j) {
    return middleOf(commonCell(aSwept->segment[i], bSwept->segment[j]));
  };
  return found;
}

} // namespace voluta::together
