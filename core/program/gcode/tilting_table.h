// Kinematics of a table that tilts (B, about y) and, on the tilting part, turns (C, about its own
// z) below an upright nozzle that moves along X Y Z. The part's frame is the plate's: with B and C
// at 0 it is the machine's.
//
// For a direction n on the part B = -acos(nz), C = -atan2(ny, nx), or (-B, C + 180 degrees); for a
// point P, with the tilt axis through the plate's centre, X = cB cC Px - cB sC Py + sB Pz,
//   Y = sC Px + cC Py, Z = -sB cC Px + sB sC Py + cB Pz. Angles are in radians, lengths in mm.
#pragma once

#include "base/units.h"
#include "plan/program.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace voluta::program {

// The plate's centre relative to the tilt axis; the turning axis passes through it.
struct TableFrame {
  double xMm = 0.0, zMm = 0.0;
};

struct TableAngles {
  double tilt = 0.0, rotation = 0.0; // B, C; the turn is continuous beyond 360 degrees
};

// The positions of all five axes.
struct TablePose {
  Eigen::Vector3d axesMm = Eigen::Vector3d::Zero(); // X Y Z
  TableAngles angles;
};

// Closer to the plate's normal than this the table is flat and its turn is free.
inline constexpr double kFlatRad = 0.002;

// Returns the axes that bring the nozzle to that point of the part.
TablePose tablePose(const TableFrame& frame, const Eigen::Vector3d& tip, TableAngles angles);
plan::NozzlePoint nozzleAt(const TableFrame& frame, const TablePose& pose);

// A point of a program, in sequence.
struct TableStation {
  Eigen::Vector3d direction; // unit
  double seconds = 0.0;      // of the motion to it
  bool prints = false;       // whether that motion deposits material
};
// Returns angles for each station: its direction up to rounding, or flat within kFlatRad of the
// normal. Of the two solutions takes the one with the smallest total rotation over the path,
// weighted towards printing motions. Where the turn is free it stays constant and moves to the next
// required angle in the last travel before it, else evenly over the whole free stretch. The turn is
// continuous, without jumps by whole turns.
std::vector<TableAngles> tableAngles(std::span<const TableStation> stations);

// Returns the distance by which the nozzle leaves the straight line on the part if all axes move
// linearly from one pose to the other.
double sagMm(const TableFrame& frame, const TablePose& from, const TablePose& to);
// Returns the number of pieces, equal in time and with their ends on the straight line on the part,
// for which the deviation is at most `maxMm`.
int tablePieces(const TableFrame& frame, const TablePose& from, const TablePose& to, double maxMm);
// Returns the pose on that line at `share` of the motion; angles change linearly.
TablePose tablePiece(const TableFrame& frame, const TablePose& from, const TablePose& to,
                     double share);

// Returns the nozzle's path on the part while all axes move linearly, as plan::ProgramMotion::way,
// to 0.005 mm and 0.002 rad. Empty if the table does not move.
std::vector<plan::NozzlePoint> pathOnPart(const TableFrame& frame, const TablePose& from,
                                          const TablePose& to);

} // namespace voluta::program
