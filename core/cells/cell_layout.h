// A cell for an arm: where plate, nozzle and table stand, found by trying places and counting what
// can be printed there (cells/cell_score.h).
#pragma once

#include "base/run_context.h"
#include "cells/arm_facts.h"
#include "cells/cell_score.h"
#include "cells/rest_pose.h"
#include "process/process.h"
#include "robot/cell/cell_file_writer.h"
#include "robot/robot_model.h"

#include <string>
#include <utility>
#include <vector>

namespace voluta::cells {

struct CellLayout {
  robot::CellDescription cell;
  RestPose rest;
  PosePattern pattern; // what `score` counts
  CellScore score;
  // Pairs of links (indices into RobotModel::links) that meet at every rest there is: solids too
  // fat for the arm. They are left out of the robot's neverMeet that the search went by, and belong
  // into it.
  std::vector<std::pair<int, int>> meetAtRest;
  std::vector<std::string> notes; // what the arm is taken for, a sentence each
};

// `robot`'s neverMeet holds what neverNear finds. `nozzle`: Flange for a nozzle
// on the arm over a plate on the table, straight or bent by 45 degrees (an arm that is solved
// numerically: straight), World for a plate on the arm below a nozzle that stands.
// Of the places on a grid of shares of the reach the best by CellScore::meanOfTilts, of nearly
// equal ones the nearest to the middle of the grid.
// The cell's id is the robot's with -moving or -fixed.
//
// Throws Error{UnusableInput}: at no place does the arm reach above the plate, clear.
CellLayout layOut(const robot::RobotModel& robot, robot::Mount nozzle,
                  const process::Process& process, const base::RunContext& ctx);

// The cell of a description for searches: the plate smallPlate().
robot::Cell cellOf(const robot::CellDescription& description, const robot::RobotModel& robot,
                   const process::Process& process);

// Links, not neighbours, that are nearer than kClearMm at most poses within limits; of a link and
// the next but one at a seventh of them.
std::vector<std::pair<int, int>> neverNear(const robot::RobotModel& robot);

} // namespace voluta::cells
