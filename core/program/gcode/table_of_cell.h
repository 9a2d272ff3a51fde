// The tilting and turning table of a cell, as G-code with B and C states it.
#pragma once

#include "program/gcode/tilting_table.h"
#include "robot/cell.h"

#include <optional>

namespace voluta::program {

// A cell's own table: where its plate is, and the angles of its axes.
struct CellTable {
  TableFrame frame;
  double tiltSign = 1.0, rotationSign = 1.0; // -1: the axis counts the opposite way
  // Returns B and C of a joint vector of the cell.
  TableAngles angles(const robot::JointVector& q, int armDof) const {
    return {tiltSign * q[armDof], rotationSign * q[armDof + 1]};
  }
};

// Returns nullopt unless the cell's external axes are a table that tilts about the machine's y and
// turns about its own z through the plate's centre, below a nozzle that stays upright and with the
// plate's x and y along the machine's.
std::optional<CellTable> tableOf(const robot::Cell& cell);

} // namespace voluta::program
