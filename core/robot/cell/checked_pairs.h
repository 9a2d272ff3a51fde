// Which bodies of a cell can meet, by the frames that they are fixed to.
#pragma once

#include "robot/body.h"

#include <utility>
#include <vector>

namespace voluta::robot {

// Groups of frames (robot/cell.h) that never move relative to each other.
struct RigidGroups {
  int armDof = 0, axes = 0; // joints of the arm, external axes
  bool plateMoves = false;  // on the flange; else the nozzle is

  // The number of a frame's group. Links of neighbouring numbers share a joint.
  int of(int frame) const;
};

// Returns the pairs of `bodies` to be checked, the lower index first: all but those of one group,
// links that share a joint, and `neverMeet`.
std::vector<std::pair<int, int>> checkedPairs(const std::vector<Body>& bodies,
                                              const RigidGroups& groups,
                                              const std::vector<std::pair<int, int>>& neverMeet);

// Returns the indices of the bodies that move relative to `frame`.
std::vector<int> bodiesMovingAgainst(int frame, const std::vector<Body>& bodies,
                                     const RigidGroups& groups);

} // namespace voluta::robot
