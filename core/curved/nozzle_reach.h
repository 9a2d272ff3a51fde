// A nozzle-shaped front: finds voxels that the actual head reaches although a flat front does not.
#pragma once

#include "curved/voxel_graph.h"
#include "process/process.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::curved {

// Checks whether the head, with its tip at the centre of a voxel, is clear of a set of voxels. As
// with the flat front, voxels are represented by their centres: the head is clear if no centre is
// strictly inside it and all of it is above the plate's plane z = 0. A flat front corresponds to a
// head that fills a half space.
class NozzleReach {
public:
  // `head`: sections in mm as process::HeadShape; may be empty only if no query is made. Keeps a
  // reference to the graph. The set is empty at first.
  NozzleReach(const VoxelGraph& graph, const process::HeadShape& head);

  void insert(std::size_t v) { count(v, 1); }
  void remove(std::size_t v) { count(v, -1); }

  // Returns the unit direction, from the tip into the head, that is nearest to `wish` and in which
  // the head is clear of the set (excluding v), out of 74 directions on the sphere. nullopt if it
  // collides in all of them.
  std::optional<Eigen::Vector3d> direction(std::size_t v, const Eigen::Vector3d& wish) const;

  // Returns whether the head in this unit direction is clear of the set.
  bool clear(std::size_t v, const Eigen::Vector3d& direction) const;

private:
  void count(std::size_t v, int by);
  // Returns the maximum radius of the head between two heights above the tip [cells]; negative if
  // no part of the head is there.
  double radiusBetween(double low, double high) const;
  double radiusAt(double z) const;

  struct Level {
    voxel::VoxelGrid blocks;         // block count along each axis
    std::vector<std::uint16_t> some; // number of children, or voxels, that are not empty
  };
  const VoxelGraph& graph_;
  std::vector<process::HeadSection> sections_; // cells
  std::vector<Level> levels_;                  // level l: blocks of 2^l cells per side
};

} // namespace voluta::curved
