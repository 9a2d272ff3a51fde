#include "replay/shot_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <unordered_set>
#include <vector>

namespace voluta::replay {

namespace {
using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr float kPassable = 0.5f;     // fill below which material flows through a cell
constexpr double kLateralShare = 1.5; // of the cube root of the volume
const std::array<Vector3i, 6> kNeighbours{Vector3i{1, 0, 0}, Vector3i{-1, 0, 0},
                                          Vector3i{0, 1, 0}, Vector3i{0, -1, 0},
                                          Vector3i{0, 0, 1}, Vector3i{0, 0, -1}};

// A cell that the shot reaches.
struct Reached {
  double depthMm, lateralMm; // of its centre, from the tip
  std::size_t cell;
};

class Pool {
public:
  Pool(const BeadGrid& grid, const BeadPiece& shot)
      : grid_(grid), tip_(shot.from), up_(shot.fromDirection), deepMm_(shot.fromHeightMm),
        wideMm_(kLateralShare * std::cbrt(static_cast<double>(shot.volumeMm3))) {}

  std::vector<Reached> reached() {
    visit(grid_.grid.cellOf(tip_ - 0.5 * grid_.grid.pitch * up_));
    for (std::size_t next = 0; next < open_.size(); ++next) {
      const Vector3i at = open_[next];
      for (const Vector3i& step : kNeighbours)
        visit(at + step);
    }
    std::ranges::sort(reached_, [](const Reached& a, const Reached& b) {
      return std::tuple(-a.depthMm, a.lateralMm, a.cell) <
             std::tuple(-b.depthMm, b.lateralMm, b.cell);
    });
    return std::move(reached_);
  }

private:
  void visit(const Vector3i& at) {
    const voxel::VoxelGrid& grid = grid_.grid;
    if (!grid.contains(at.x(), at.y(), at.z()))
      return;
    const std::size_t cell = grid.index(at.x(), at.y(), at.z());
    const Vector3d offset = tip_ - grid.centre(at.x(), at.y(), at.z());
    const double depth = offset.dot(up_), lateral = (offset - depth * up_).norm();
    if (depth < 0.0 || depth > deepMm_ + grid.pitch || lateral > wideMm_ ||
        !seen_.insert(cell).second)
      return;
    reached_.push_back({depth, lateral, cell});
    if (grid_.fill[cell] < kPassable)
      open_.push_back(at);
  }

  const BeadGrid& grid_;
  Vector3d tip_, up_;
  double deepMm_, wideMm_;
  std::unordered_set<std::size_t> seen_;
  std::vector<Vector3i> open_;
  std::vector<Reached> reached_;
};

} // namespace

double fillFromTip(BeadGrid& grid, const BeadPiece& shot, std::uint32_t piece) {
  double left = static_cast<double>(shot.volumeMm3) / std::pow(grid.grid.pitch, 3);
  for (const Reached& reached : Pool(grid, shot).reached()) {
    if (left <= 0.0)
      break;
    float& fill = grid.fill[reached.cell];
    const float before = fill;
    fill = static_cast<float>(std::min(1.0, static_cast<double>(before) + left));
    left -= static_cast<double>(fill) - static_cast<double>(before);
    grid.rectangle[reached.cell] = 255;
    if (fill > 0.5f && grid.filler[reached.cell] == 0)
      grid.filler[reached.cell] = piece + 1;
  }
  return std::max(0.0, left);
}

} // namespace voluta::replay
