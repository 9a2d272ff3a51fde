// Writes a cell's file for cells generated around an arm: one nozzle, one plate, no external axes.
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
  Mount nozzleMount = Mount::Flange;  // the plate has the other mount
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

// `kinds`: of the robot's joints. The cell read back is the same up to rounding in the last digits.
std::string cellFileJson(const CellDescription& cell, const std::vector<JointKind>& kinds);

} // namespace voluta::robot
