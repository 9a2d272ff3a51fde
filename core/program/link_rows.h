// Motions as lines of nine numbers, for a MELFA controller that takes them by data link:
//
//   x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,mm_per_s,flow,blend_mm
//   tool,0,0,100,0,0,0               the TCP on the flange: not sent, the program that takes the
//   nozzle,-800,-250,0,180,0,0       lines has it; the nozzle in the robot's base, where it stands
//   -10.5,20,300,12,-3,90,20,4113,0.05   straight, at 20 mm/s, flow 4113, blend of 0.05 mm
//   0,0,90,0,90,0,8,0,-1             by joints, degrees, at 8 per cent
//   400,0,300,180,0,180,8,0,-2       by joints to a pose, at 8 per cent
//   400,0,300,180,0,180,-0.2,4113,-2 the arm stands for 0.2 s where the line before led it
//   400,0,300,180,0,180,0,0,-2       the end, there
//
// Poses are the TCP's in the robot's base, R = Rz(c) Ry(b) Rx(a). The flow is a whole number, that
// of the outputs (program/melfa.h); the extruder is on while it is not 0, and off in motions by
// joints. Blend 0: the arm stands behind that motion. Remarks begin with '#', in lines of their own
// or behind a line.
#pragma once

#include "base/run_context.h"
#include "program/program_builder.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr std::string_view kLinkHeader =
    "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,mm_per_s,flow,blend_mm";
inline constexpr double kLinkByJoints = -1.0, kLinkByJointsToPose = -2.0; // blends

struct LinkRow {
  std::array<double, 6> target = {}; // mm, degrees
  double speed = 0.0;                // mm/s, or per cent by joints; below 0: seconds; 0: the end
  double flow = 0.0;                 // 0 to kMelfaFullFlow, whole
  double blend = 0.0;                // mm, or kLinkByJoints...

  bool moves() const { return speed > 0.0; }
  bool byJoints() const { return blend < 0.0; }
};
// With a line end.
void appendLinkRow(std::string& out, const LinkRow& row);
// A line without its remark; false: no row.
bool parseLinkRow(std::string_view line, LinkRow& row);

// A frame, mm and degrees.
using LinkFrame = std::array<double, 6>;
inline constexpr std::string_view kLinkTool = "tool", kLinkNozzle = "nozzle";
void appendLinkFrame(std::string& out, std::string_view name, const LinkFrame& frame);

struct LinkRead {
  bool complete = false; // the end was found
  std::optional<LinkFrame> tool, nozzle;
  std::optional<LinkRow> start; // the first
};
// Reads one file of lines into `out`, whose file is set. What is no line, waits elsewhere than it
// stands, switches the extruder where the arm does not stand, or comes behind the end is a defect.
// Throws Cancelled.
LinkRead readLinkRows(std::string_view text, ProgramBuilder& out, const base::RunContext& ctx);

// Does a text's first line head such lines?
bool looksLikeLinkRows(std::string_view text);

} // namespace voluta::program
