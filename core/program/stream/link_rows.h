// Motions as lines of numbers, for controllers that receive them one after the other over TCP. The
// meaning of the numbers depends on the controller (LinkForm); for MELFA's:
//
//   x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,mm_per_s,flow,blend_mm
//   tool,0,0,100,0,0,0               the TCP on the flange: not sent, the receiving program
//   contains it
//   nozzle,-800,-250,0,180,0,0       the nozzle in the robot's base, if it is fixed
//   -10.5,20,300,12,-3,90,20,4113,0.05   straight, at 20 mm/s, flow 4113, blend of 0.05 mm
//   0,0,90,0,90,0,8,0,-1             joint motion, degrees, at 8 percent
//   400,0,300,180,0,180,8,0,-2       joint motion to a pose, at 8 percent
//   400,0,300,180,0,180,-0.2,4113,-2 the arm waits for 0.2 s at the target of the previous line
//   400,0,300,180,0,180,0,0,-2       the end, at the same target
//
// A form that `turns` has a column deg_per_s after mm_per_s: the slower of both applies. A form
// whose poses are in a frame set by the program (`inFrame`) has `base` if the nozzle is not fixed,
// and the `load` in kg with its centre of mass. The extruder is on while the flow is not 0, and off
// in joint motions. Blend 0: the arm stops after that motion. Remarks begin with '#', on their own
// line or after a line.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "program/program_builder.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr double kLinkByJoints = -1.0, kLinkByJointsToPose = -2.0; // blends

struct LinkForm {
  std::string_view header;
  bool turns = false;
  // false: poses are the TCP's in the robot's base. true: the TCP's in `base`; with a fixed nozzle,
  // the nozzle's in the frame `tool` on the flange.
  bool inFrame = false;
  double fullFlow = 1.0;
  bool wholeFlow = false;    // the flow is an integer
  double jointRadPerS = 0.0; // at 100 percent
  int mmDecimals = 4, degDecimals = 5, frameDecimals = 6, blendDecimals = 3;
  // Converts mm and degrees to a pose; nullopt if it is not within a robot's reach.
  std::optional<Eigen::Isometry3d> (*pose)(const Eigen::Vector3d& mm,
                                           const Eigen::Vector3d& degrees) = nullptr;
};

struct LinkRow {
  std::array<double, 6> target = {}; // mm, degrees
  double speed = 0.0;    // mm/s, or percent for joint motions; negative: seconds; 0: the end
  double rotation = 0.0; // degrees/s, of straight motions
  double flow = 0.0;     // 0 to the form's full flow
  double blend = 0.0;    // mm, or kLinkByJoints...

  bool moves() const { return speed > 0.0; }
  bool byJoints() const { return blend < 0.0; }
};
// With a line end.
void appendLinkRow(std::string& out, const LinkRow& row, const LinkForm& form);
// Parses a line without its remark. Returns false if it is no row.
bool parseLinkRow(std::string_view line, const LinkForm& form, LinkRow& row);

// A frame, mm and degrees; rounded as written.
using LinkFrame = std::array<double, 6>;
inline constexpr std::string_view kLinkTool = "tool", kLinkNozzle = "nozzle", kLinkBase = "base",
                                  kLinkLoad = "load";
LinkFrame linkFrame(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees,
                    const LinkForm& form);
void appendLinkFrame(std::string& out, std::string_view name, const LinkFrame& frame,
                     const LinkForm& form);

// Data of the lines that the receiving program needs.
struct Link {
  LinkFrame tool;
  std::optional<LinkFrame> nozzle, base, load;
  LinkRow start;
};
struct LinkRead {
  bool complete = false;    // the end was found
  std::optional<Link> link; // if its tool and its start were found
};
// Reads one file of lines into `out`, whose file is set. Defects: lines that cannot be parsed,
// waits at another target than the previous one, switching the extruder while the arm moves, lines
// after the end. Throws Cancelled.
LinkRead readLinkRows(std::string_view text, const LinkForm& form, ProgramBuilder& out,
                      const base::RunContext& ctx);

// Returns whether a text begins with the header of such lines.
bool looksLikeLinkRows(std::string_view text, const LinkForm& form);
// Returns whether the arm waits in line i while the extruder runs (the prime):
// Dialect::mayBeMissing.
bool isStandingLinkRow(const std::vector<std::string>& lines, std::size_t i, const LinkForm& form);

} // namespace voluta::program
