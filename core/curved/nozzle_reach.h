// A nozzle-shaped front: where the head as it is reaches what a flat one does not.
#pragma once

#include "curved/voxel_graph.h"
#include "process/process.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::curved {

// Tells of a set of voxels whether the head clears it with its tip at the centre of a voxel. As
// with the flat front, centres stand for voxels: the head is clear when no centre lies strictly
// inside it and all of it stays above the plate's plane z = 0. A flat front is a head that fills a
// half space.
class NozzleReach {
public:
  // `head`: sections in mm as process::HeadShape; may be empty only where nothing is asked.
  // Keeps a reference to the graph. The set is empty at first.
  NozzleReach(const VoxelGraph& graph, const process::HeadShape& head);

  void insert(std::size_t v) { count(v, 1); }
  void remove(std::size_t v) { count(v, -1); }

  // A unit direction, from the tip into the head, in which the head clears the set (v itself
  // apart); of those tried (74 about the sphere) the one nearest to `wish`; none: it meets
  // something in each.
  std::optional<Eigen::Vector3d> direction(std::size_t v, const Eigen::Vector3d& wish) const;

  // Whether the head clears the set in this unit direction.
  bool clear(std::size_t v, const Eigen::Vector3d& direction) const;

private:
  void count(std::size_t v, int by);
  // Largest radius of the head between two heights above the tip, cells; negative: no head there.
  double radiusBetween(double low, double high) const;
  double radiusAt(double z) const;

  struct Level {
    voxel::VoxelGrid blocks;         // their number along each axis
    std::vector<std::uint16_t> some; // children, or voxels, that are not empty
  };
  const VoxelGraph& graph_;
  std::vector<process::HeadSection> sections_; // cells
  std::vector<Level> levels_;                  // level l: blocks of 2^l cells each way
};

} // namespace voluta::curved
