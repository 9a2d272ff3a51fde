// The block that a cutter takes material from.
#pragma once

#include "milling/cutting_data.h"
#include "milling/height_map.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::milling {

// A column of material over each cell, from `low` to `high`; empty if low >= high. The cutter comes
// from above.
class Stock {
public:
  Stock(const Eigen::AlignedBox3d& block, double pitchMm);

  const CellGrid& grid() const { return grid_; }
  double highAt(std::size_t cell) const { return high_[cell]; }
  double lowAt(std::size_t cell) const { return low_[cell]; }
  double volumeMm3() const;

  // Removes the material that the cutter sweeps on a straight line between two positions of its
  // tip. Returns the removed volume [mm3].
  double cut(const Cutter& cutter, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

  // Returns the block turned upside down about the x axis.
  Stock turned() const;

private:
  CellGrid grid_;
  std::vector<double> low_, high_;
  double top_; // no material is higher
};

} // namespace voluta::milling
