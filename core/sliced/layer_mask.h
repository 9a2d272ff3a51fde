// The cells of one layer: beads, walls, and the regions between them.
#pragma once

#include "plan/tool_plan.h"

#include <Eigen/Core>
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
  int runThrough(std::size_t c, int di, int dj, int most) const;
};

} // namespace voluta::sliced
