// Layout of a cell for an arm: positions of plate, nozzle and table, found by trying places and
// counting the printable poses (cells/cell_score.h).
#pragma once

#include "base/run_context.h"
#include "cells/arm_facts.h"
#include "cells/cell_score.h"
#include "cells/rest_pose.h"
#include "process/process.h"
#include "robot/cell/cell_file_writer.h"
#include "robot/robot_model.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voluta::cells {

struct CellLayout {
  robot::CellDescription cell;
  RestPose rest;
  PosePattern pattern; // the poses that `score` counts
  CellScore score;
  // Pairs of links (indices into RobotModel::links) that collide in every possible home pose
  // because their solids are too large. They were ignored in the search in addition to the robot's
  // neverMeet, and should be added to it.
  std::vector<std::pair<int, int>> meetAtRest;
  std::vector<std::string> notes; // assumptions about the arm, one sentence each
};

// `robot`: its neverMeet contains the result of neverNear. `nozzle`: Flange for a nozzle on the arm
// above a plate on the table, straight or bent by 45 degrees (straight for an arm that is solved
// numerically); World for a plate on the arm below a stationary nozzle. Returns the place with the
// best CellScore::meanOfTilts from a grid of shares of the reach; among nearly equal ones, the
// nearest to the middle of the grid. The cell's id is the robot's with -moving or -fixed.
//
// Throws Error{UnusableInput} if the arm reaches above the plate without collision at no place.
CellLayout layOut(const robot::RobotModel& robot, robot::Mount nozzle,
                  const process::Process& process, const base::RunContext& ctx);

// Other nozzles and poses than layOut() tries by itself.
struct LayoutSearch {
  std::vector<double> bendsRad;       // of a nozzle on the flange, 0: straight; not empty
  std::optional<PosePattern> pattern; // nullopt: by the arm's reach
  std::string part; // that it is laid out for, for the note; empty: none, at import
};
// As layOut(), with these nozzles and poses.
CellLayout layOut(const robot::RobotModel& robot, robot::Mount nozzle, const LayoutSearch& search,
                  const process::Process& process, const base::RunContext& ctx);

// Returns the cell of a description, for searches: with smallPlate() as its plate.
robot::Cell cellOf(const robot::CellDescription& description, const robot::RobotModel& robot,
                   const process::Process& process);

// Returns pairs of links that are closer than kClearMm at most poses within the limits, except
// neighbours; for a link and the next but one, at a seventh of the poses.
std::vector<std::pair<int, int>> neverNear(const robot::RobotModel& robot);

} // namespace voluta::cells
