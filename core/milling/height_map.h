// A part seen from above: the heights of its top on a grid.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace voluta::milling {

// Square cells; heights are those at their middles.
struct CellGrid {
  Eigen::Vector2d low = Eigen::Vector2d::Zero(); // corner [mm]
  double pitchMm = 0.1;
  int countX = 0, countY = 0;

  std::size_t size() const {
    return static_cast<std::size_t>(countX) * static_cast<std::size_t>(countY);
  }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(countX) +
           static_cast<std::size_t>(i);
  }
  Eigen::Vector2d middle(int i, int j) const {
    return low + pitchMm * Eigen::Vector2d(i + 0.5, j + 0.5);
  }
};

// Returns a grid over a box.
CellGrid gridOver(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double pitchMm);

struct HeightMap {
  static constexpr double kNone = -std::numeric_limits<double>::infinity();
  CellGrid grid;
  std::vector<double> top; // per cell [mm]; kNone: beside the part
  // Height of the part's material over the cell [mm]: less than from its bottom to its top where
  // it has undercuts
  std::vector<double> solidMm;
  std::vector<double> solidMomentMm2; // of that material: the integral of z over its height

  bool isPart(std::size_t cell) const { return top[cell] > kNone; }
};

// Returns the map of a closed part. Throws Cancelled.
HeightMap heightMap(const geometry::TriangleMesh& part, const CellGrid& grid,
                    const base::RunContext& ctx);

// Calls visit(cell, squared) for all cells whose middle is within `radiusMm` of a point, with the
// square of its distance.
template <typename Visit>
void visitAround(const CellGrid& grid, const Eigen::Vector2d& at, double radiusMm,
                 const Visit& visit) {
  const auto bound = [&](double value, int count) {
    return static_cast<int>(std::min(std::max(value, 0.0), static_cast<double>(count)));
  };
  const Eigen::Vector2d from = (at - grid.low).array() - radiusMm,
                        to = (at - grid.low).array() + radiusMm;
  const int i0 = bound(from.x() / grid.pitchMm, grid.countX),
            i1 = bound(to.x() / grid.pitchMm + 1.0, grid.countX),
            j0 = bound(from.y() / grid.pitchMm, grid.countY),
            j1 = bound(to.y() / grid.pitchMm + 1.0, grid.countY);
  for (int j = j0; j < j1; ++j)
    for (int i = i0; i < i1; ++i) {
      const Eigen::Vector2d off = grid.middle(i, j) - at;
      if (const double squared = off.squaredNorm(); squared <= radiusMm * radiusMm)
        visit(grid.index(i, j), squared);
    }
}

// Calls visit(cell, offset) for all cells whose middle is within `radiusMm` of the line between two
// points, and for some others around its ends; `offset`: of the middle from `from`.
template <typename Visit>
void visitAlong(const CellGrid& grid, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                double radiusMm, const Visit& visit) {
  constexpr double kAlongX = 1e-9;
  const auto bound = [&](double value, int count) {
    return static_cast<int>(std::clamp(value / grid.pitchMm, 0.0, static_cast<double>(count)));
  };
  const Eigen::Vector2d low = (from.cwiseMin(to) - grid.low).array() - radiusMm,
                        high = (from.cwiseMax(to) - grid.low).array() + radiusMm, step = to - from;
  const double length = step.norm();
  const int j0 = bound(low.y(), grid.countY), j1 = bound(high.y() + grid.pitchMm, grid.countY);
  for (int j = j0; j < j1; ++j) {
    double left = low.x(), right = high.x();
    if (std::abs(step.y()) > kAlongX * length) {
      // The strip of that half width about the endless line.
      const double aboveMm = grid.middle(0, j).y() - from.y(),
                   middle = from.x() - grid.low.x() + aboveMm * step.x() / step.y(),
                   half = radiusMm * length / std::abs(step.y());
      left = std::max(left, middle - half);
      right = std::min(right, middle + half);
    }
    const int i0 = bound(left, grid.countX), i1 = bound(right + grid.pitchMm, grid.countX);
    for (int i = i0; i < i1; ++i)
      visit(grid.index(i, j), grid.middle(i, j) - from);
  }
}

} // namespace voluta::milling
