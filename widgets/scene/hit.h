// Results of ray queries on the drawings of a scene.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace voluta::scene {

struct Hit {
  enum class What { Part, OtherPart, Platform, Voxel, Layer, Path, Piece, Cell };
  What what = What::Part;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // in the work frame [mm]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // unit, of the facet; zero for paths and cell
  int layer = -1;                     // Voxel (not while growth is replayed), Layer, Path
  std::size_t path = 0, waypoint = 0; // Path: indices in the ToolPlan
  std::size_t patch = 0;              // Layer: index in the LayerStack
  std::size_t voxel = 0;              // Voxel: cell of the grid
  std::size_t item = 0;               // OtherPart: its index in the job
  std::size_t piece = 0;              // Piece: its place in print order; `point` is on the part
  std::size_t body = 0;               // Cell: index in Cell::bodies()
};

// Visible objects hit by a straight line from a place to the eye.
struct Between {
  bool printed = false;  // part, voxels, pieces, layers or paths, unless transparent
  bool platform = false; // its drawing
  std::array<bool, robot::kBodyRoleCount> roles{}; // of the cell's bodies
  bool machine() const;                            // the platform, or a body
};

} // namespace voluta::scene
