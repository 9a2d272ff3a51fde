// Places in a process's statements that depend on the cell: the direction in which its arm presses
// the nozzle onto the surface (Castelli 7.1.4).
#pragma once

#include "process/process.h"
#include "robot/cell.h"

namespace voluta::program {

// Replaces these words in the process's statements (process::BeadWords):
//   {pressFrame}   URScript: a pose whose z is the direction of the force. That of a nozzle on the
//                  arm is the tool's pose when the statement runs; before a fixed nozzle the arm
//                  presses against it, in the base frame.
//   {pressSpace}   MELFA: the coordinate system of force control, 0 (tool) or 1 (base)
//   {press 5}      MELFA: six components, of which that along the force is 5 or -5
//   {pressAxis 20} MELFA: six components, of which that of the force's axis is 20
// Throws Error{Usage} if a statement for MELFA has one of its words and the nozzle is fixed along
// none of the base's axes, and for a word whose number cannot be read.
void fillPressWords(process::Process& process, const robot::Cell& cell);

} // namespace voluta::program
