// The lock of a tool changer before the arm moves: an output that an aborted run left off, or that
// no run has set yet, lets the tool fall.
#pragma once

#include "plan/program.h"
#include "plan/stated_facts.h"
#include "replay/comparison.h"
#include "robot/cell.h"

#include <cstddef>
#include <vector>

namespace voluta::replay {

// In a cell with a tool changer, in languages that can lock a tool: returns a finding for each file
// with motions that does not lock the tool before its first one; for a lock before the first motion
// of the program that comes before the operator's stop, or whose time (robot::kChangerS) does not
// pass before the motion.
std::vector<TextFinding> compareStartLock(const plan::ReadProgram& program,
                                          const robot::Cell& cell);

// Returns whether the statement locks the tool before the first motion of a file behind the first:
// it is locked already, unless the file was started alone.
bool locksAtFile(const plan::ReadProgram& program, const plan::StatedFact& fact);

// Returns the time that a lock at a file takes in that pause [s]; 0: none.
double fileLockS(const plan::ReadProgram& program, std::size_t pause);

} // namespace voluta::replay
