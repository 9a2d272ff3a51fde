// A cell's file from numbers: the kinds of cells that are laid out for an arm, one nozzle, one
// plate and no external axes.
#pragma once

#include "robot/cell.h"

#include <string>
#include <vector>

namespace voluta::robot {

struct UncheckedPair {
  std::string first, second; // names of bodies
  std::string why;
};

// mm. Poses and shapes as in the file (robot/cell/cell_reader.cpp).
struct CellDescription {
  std::string id, label, note, robot; // robot: its id
  Mount nozzleMount = Mount::Flange;  // the plate's is the other
  Eigen::Isometry3d nozzlePose = Eigen::Isometry3d::Identity();
  std::vector<Shape> holder;
  Eigen::Isometry3d platePose = Eigen::Isometry3d::Identity();
  double plateThicknessMm = 10.0;
  std::vector<std::string> plates; // as platforms are written
  std::vector<Shape> stem;
  std::vector<Body> obstacles;
  JointVector home; // of the robot's joints
  std::vector<UncheckedPair> neverMeet;
};

// `kinds`: of the robot's joints. Read back, the cell is the same but for rounding in the last
// places.
std::string cellFileJson(const CellDescription& cell, const std::vector<JointKind>& kinds);

} // namespace voluta::robot
