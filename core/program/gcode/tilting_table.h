// A table that tilts (B, about y) and, on the tilting part, turns (C, about its own z) beneath a
// nozzle that stands upright and goes along X Y Z. The part's frame is the plate's: with B and C at
// 0 it is the machine's.
//
// Of a direction n on the part B = -acos(nz), C = -atan2(ny, nx), or (-B, C + 180 degrees); of a
// point P, with the tilt axis through the plate's centre, X = cB cC Px - cB sC Py + sB Pz,
// Y = sC Px + cC Py, Z = -sB cC Px + sB sC Py + cB Pz. Angles here are radians, lengths mm.
#pragma once

#include "base/units.h"
#include "plan/program.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace voluta::program {

// The plate's centre as seen from the tilt axis; the turning axis goes through it.
struct TableFrame {
  double xMm = 0.0, zMm = 0.0;
};

struct TableAngles {
  double tilt = 0.0, turn = 0.0; // B, C; the turn counts on
};

// Where all five axes are.
struct TablePose {
  Eigen::Vector3d axesMm = Eigen::Vector3d::Zero(); // X Y Z
  TableAngles angles;
};

// Closer to the plate's normal than this the table lies flat and its turn is free.
inline constexpr double kFlatRad = 0.002;

// The axes that bring the nozzle to that point of the part.
TablePose tablePose(const TableFrame& frame, const Eigen::Vector3d& tip, TableAngles angles);
plan::NozzlePoint nozzleAt(const TableFrame& frame, const TablePose& pose);

// One after the other along a program.
struct TableStation {
  Eigen::Vector3d direction; // unit
  double seconds = 0.0;      // of the motion to it
  bool prints = false;       // does that motion lay material
};
// Angles for each station: its direction to rounding, or flat within kFlatRad of the normal. Of the
// two ways to stand that one is taken which turns least over the whole path, first of all while it
// prints; where the turn is free it stands still, and goes to where it is needed next in the last
// travel there, else evenly over all of that stretch. Jumps by whole turns are none: the turn
// counts on.
std::vector<TableAngles> tableAngles(std::span<const TableStation> stations);

// How far the nozzle leaves the straight line on the part where all axes go straight from one pose
// to the other.
double sagMm(const TableFrame& frame, const TablePose& from, const TablePose& to);
// In how many pieces, equal in time and with their ends on the straight line on the part, it leaves
// it by no more than `mostMm`.
int tablePieces(const TableFrame& frame, const TablePose& from, const TablePose& to, double mostMm);
// The pose on that line at `share` of the motion; angles go evenly.
TablePose tablePiece(const TableFrame& frame, const TablePose& from, const TablePose& to,
                     double share);

// The nozzle's way on the part where all axes go straight, as plan::ProgramMotion::way: to 0.005 mm
// and 0.002 rad. Empty where the table stands still.
std::vector<plan::NozzlePoint> wayOnPart(const TableFrame& frame, const TablePose& from,
                                         const TablePose& to);

} // namespace voluta::program
