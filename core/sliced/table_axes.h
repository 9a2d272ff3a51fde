// The axes B and C of a machine whose table tilts and turns below an upright nozzle, as
// program/gcode/gcode_bc.h describes them.
#pragma once

#include "plan/program.h"
#include "program/gcode/gcode_line.h"
#include "program/gcode/tilting_table.h"

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace voluta::sliced {

class TableAxes {
public:
  // Takes what a comment states: the plate's place over the tilt axis, and the sense of B and C.
  void note(std::string_view comment);
  // Takes the words B and C of a motion [degrees].
  void take(program::GcodeWords& words);
  // G92: the table's turn gets that count [degrees], without a motion.
  void setCount(double rotationDeg);

  // Returns whether a motion named B or C.
  bool isUsed() const { return isUsed_; }
  program::TablePose poseAt(const Eigen::Vector3d& axesMm) const { return {axesMm, angles_}; }
  // Return the nozzle on the part, and its path between two poses, without its ends; empty if the
  // table does not move.
  plan::NozzlePoint nozzleAt(const program::TablePose& pose) const;
  std::vector<plan::NozzlePoint> path(const program::TablePose& from,
                                      const program::TablePose& to) const;

private:
  program::TableFrame frame_;
  program::TableAngles angles_; // Of the part [rad]
  double sense_ = 1.0, countedDeg_ = 0.0;
  bool isUsed_ = false;
};

} // namespace voluta::sliced
