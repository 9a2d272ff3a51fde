// The field of a Decomposition in a form for cutting and marching: values at voxel centres,
// extended by one ring beyond the printed voxels.
#pragma once

#include "base/run_context.h"
#include "curved/decomposition.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::curved {

// Values are stored on nodes: a printed voxel is one node (its centre). An empty voxel beside
// printed ones is one node for each connected group of printed voxels among its 26 neighbours, so
// that limbs separated by a gap of one voxel don't share values. A dual cell is the cube between
// eight voxel centres. The cells with at least one printed corner cover the printed voxels
// completely, and because two corners of a cell are always 26-neighbours, the nodes of such a cell
// are unique.
class LevelField {
public:
  // Where the Decomposition has no field, the level is (rank - 1/2) * pitch, lightly smoothed.
  // Preconditions: array sizes fit the grid.
  LevelField(const Decomposition& decomposition, const base::RunContext& ctx);

  // A dual cell, identified by its lowest corner voxel (i,j,k), each from -1 to size - 1. Corner c
  // is the voxel (i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)).
  struct Cell {
    std::array<int, 8> nodes;
  };
  // Returns nullopt if no corner of the cell is printed.
  std::optional<Cell> cell(int i, int j, int k) const;

  const voxel::VoxelGrid& grid() const { return grid_; }
  // Returns the node of a voxel of the grid; if there are several, the first.
  int voxelNode(int i, int j, int k) const { return dense(i, j, k); }
  double value(int node) const { return value_[static_cast<std::size_t>(node)]; } // [mm]
  // Returns the least-squares gradient over the printed neighbours; for an outer node, the mean of
  // its group.
  Eigen::Vector3d gradient(int node) const {
    return gradient_[static_cast<std::size_t>(node)].cast<double>();
  }
  // Returns the front normal of a printed node, zero for others.
  Eigen::Vector3d frontNormal(int node) const;
  bool printed(int node) const {
    return node < denseCount_ && kind_[static_cast<std::size_t>(node)] == Kind::Printed;
  }

  // Trilinear sample in the cell that contains a point; nullopt if that cell has no printed corner.
  struct Sample {
    double value = 0.0;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero(); // Blended from the nodes: continuous
  };
  std::optional<Sample> sample(const Eigen::Vector3d& point) const;
  std::optional<double> valueAt(const Eigen::Vector3d& point) const;

  // Return the maximum and minimum over printed voxels; 0 if there are none.
  double maxPrinted() const { return maxPrinted_; }

private:
  enum class Kind : std::uint8_t { Far, Printed, Ring, SplitRing };
  // A further group of printed voxels around an empty voxel, chained by `next`.
  struct Group {
    std::uint32_t mask; // Bit (dx + 1) + 3 (dy + 1) + 9 (dz + 1)
    int node, next;
  };

  int dense(int i, int j, int k) const {
    return (i + 1) + (grid_.size.x() + 2) * ((j + 1) + (grid_.size.y() + 2) * (k + 1));
  }
  void fitGradients(const std::vector<int>& printed, const base::RunContext& ctx);
  void extrapolate(const std::vector<int>& printed, const base::RunContext& ctx);
  // Returns the cell that contains the point, and the point's trilinear coordinates in it.
  std::optional<Cell> locate(const Eigen::Vector3d& point, Eigen::Vector3d& local) const;

  voxel::VoxelGrid grid_;
  int denseCount_ = 0;                       // Number of nodes that are voxels of the padded grid
  std::array<int, 27> neighbour_{};          // Offsets in the padded grid
  std::vector<Kind> kind_;                   // Per padded voxel
  std::vector<double> value_;                // Per node
  std::vector<Eigen::Vector3f> gradient_;    // Per node
  std::vector<Eigen::Vector3f> frontNormal_; // Per padded voxel
  std::vector<int> firstGroup_;              // Per split voxel in order of splitVoxel_
  std::vector<int> splitVoxel_;              // Sorted
  std::vector<Group> groups_;
  double maxPrinted_ = 0.0;
};

} // namespace voluta::curved
