// The cells of one layer: beads, walls, and the regions between them.
#pragma once

#include "geometry/nearest_share.h"
#include "plan/tool_plan.h"
#include "process/bead_model.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::sliced {

struct LayerMask {
  enum Bit : std::uint8_t {
    kBead = 1,
    kOfWall = 2,
    kOfInfill = 4,
    kReached = 8,
    kFilled = 16,
    kOfSparse = 32
  };
  static constexpr std::uint8_t kWall = kBead | kOfWall, kInfill = kBead | kOfInfill,
                                kSparse = kInfill | kOfSparse;

  struct Field {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    double pitch = 1.0;
    int width = 1, depth = 1; // Cells along x and y
  };

  explicit LayerMask(const Field& f)
      : field(f), bits(static_cast<std::size_t>(f.width) * static_cast<std::size_t>(f.depth)) {}

  // Returns the cell of a point within the field.
  std::size_t cellOf(const Eigen::Vector2d& point) const;
  // Marks the cells whose centres are within half a hatch of the segment that ends at a waypoint.
  void mark(const plan::ToolPlan& plan, std::size_t end, std::uint8_t with);
  // Calls take(cell, distance from the outline [mm], share of the segment) for the cells whose
  // centres are within half a hatch and `marginMm` of the segment that ends at waypoint `end`.
  // Distances are negative within the bead.
  template <typename Take>
  static void eachNear(const Field& field, const plan::ToolPlan& plan, std::size_t end,
                       double marginMm, const Take& take);
  // Returns whether a cell is of no wall and of no region found so far.
  bool isOpen(std::size_t c) const { return (bits[c] & (kReached | kOfWall)) == 0; }
  bool isSolid(std::size_t c) const { return (bits[c] & (kBead | kFilled)) != 0; }

  // Cells within walls that are joined by their sides.
  struct Region {
    std::vector<std::size_t> cells;
    std::size_t beads = 0, infill = 0, sparse = 0; // Numbers of cells
    bool isOutside = false;                        // It reaches the field's border
  };
  // Finds the region of an open cell.
  Region regionFrom(std::size_t seed);
  // Returns whether each cell is in a row or column of at most `cells` cells between walls.
  bool isThin(const Region& region, int cells) const;

  Field field;
  std::vector<std::uint8_t> bits; // Per cell, x fastest

private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(field.width) * static_cast<std::size_t>(j);
  }
  int runThrough(std::size_t c, int di, int dj, int limit) const;
};

template <typename Take>
void LayerMask::eachNear(const Field& field, const plan::ToolPlan& plan, std::size_t end,
                         double marginMm, const Take& take) {
  const Eigen::Vector2d a = plan.position[end - 1].head<2>(), b = plan.position[end].head<2>();
  const double width = 0.5 * (plan.widthMm[end - 1] + plan.widthMm[end]);
  const double height = 0.5 * (plan.heightMm[end - 1] + plan.heightMm[end]);
  const double half = 0.5 * process::hatchOf(width, height), reach = half + marginMm;
  const Eigen::Vector2d along = b - a;
  const auto at = [&](double mm, int axis, int limit) {
    return static_cast<int>(
        std::clamp(std::floor((mm - field.origin[axis]) / field.pitch), 0.0, limit - 1.0));
  };
  const int left = at(std::min(a.x(), b.x()) - reach, 0, field.width);
  const int right = at(std::max(a.x(), b.x()) + reach, 0, field.width);
  const int low = at(std::min(a.y(), b.y()) - reach, 1, field.depth);
  const int high = at(std::max(a.y(), b.y()) + reach, 1, field.depth);
  for (int j = low; j <= high; ++j)
    for (int i = left; i <= right; ++i) {
      const Eigen::Vector2d centre = field.origin + field.pitch * Eigen::Vector2d(i + 0.5, j + 0.5);
      const double t = geometry::nearestShare<2>(centre, a, b);
      const double distance2 = (centre - a - t * along).squaredNorm();
      if (distance2 <= reach * reach)
        take(static_cast<std::size_t>(i) +
                 static_cast<std::size_t>(field.width) * static_cast<std::size_t>(j),
             std::sqrt(distance2) - half, t);
    }
}

} // namespace voluta::sliced
