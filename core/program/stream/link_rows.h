// Motions as lines of numbers, for controllers that take them one after the other over TCP. What
// the numbers are is a controller's own (LinkForm); of MELFA's:
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
// With a form that `turns` a column deg_per_s stands behind mm_per_s: the slower rules. One whose
// poses are in a frame that the program sets (`inFrame`) has `base` where no nozzle stands, and the
// `load` in kg with its centre of mass. The extruder is on while the flow is not 0, and off in
// motions by joints. Blend 0: the arm stands behind that motion. Remarks begin with '#', in lines
// of their own or behind a line.
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
  // Poses are the TCP's in the robot's base; or of the TCP in `base`, of the nozzle, where it
  // stands, in the frame on the flange that `tool` is.
  bool inFrame = false;
  double fullFlow = 1.0;
  bool wholeFlow = false;    // the flow is a whole number
  double jointRadPerS = 0.0; // of 100 per cent
  int mmDecimals = 4, degDecimals = 5, frameDecimals = 6, blendDecimals = 3;
  // mm and degrees. Nothing: no position in a robot's reach.
  std::optional<Eigen::Isometry3d> (*pose)(const Eigen::Vector3d& mm,
                                           const Eigen::Vector3d& degrees) = nullptr;
};

struct LinkRow {
  std::array<double, 6> target = {}; // mm, degrees
  double speed = 0.0;                // mm/s, or per cent by joints; below 0: seconds; 0: the end
  double turn = 0.0;                 // degrees/s, of straight motions
  double flow = 0.0;                 // 0 to the form's full one
  double blend = 0.0;                // mm, or kLinkByJoints...

  bool moves() const { return speed > 0.0; }
  bool byJoints() const { return blend < 0.0; }
};
// With a line end.
void appendLinkRow(std::string& out, const LinkRow& row, const LinkForm& form);
// A line without its remark; false: no row.
bool parseLinkRow(std::string_view line, const LinkForm& form, LinkRow& row);

// A frame, mm and degrees; rounded as it is written.
using LinkFrame = std::array<double, 6>;
inline constexpr std::string_view kLinkTool = "tool", kLinkNozzle = "nozzle", kLinkBase = "base",
                                  kLinkLoad = "load";
LinkFrame linkFrame(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees,
                    const LinkForm& form);
void appendLinkFrame(std::string& out, std::string_view name, const LinkFrame& frame,
                     const LinkForm& form);

// What of the lines the program that takes them has to know.
struct Link {
  LinkFrame tool;
  std::optional<LinkFrame> nozzle, base, load;
  LinkRow start;
};
struct LinkRead {
  bool complete = false;    // the end was found
  std::optional<Link> link; // its tool and its start were
};
// Reads one file of lines into `out`, whose file is set. What is no line, waits elsewhere than it
// stands, switches the extruder where the arm does not stand, or comes behind the end is a defect.
// Throws Cancelled.
LinkRead readLinkRows(std::string_view text, const LinkForm& form, ProgramBuilder& out,
                      const base::RunContext& ctx);

// Does a text's first line head such lines?
bool looksLikeLinkRows(std::string_view text, const LinkForm& form);
// Line i is one in which the arm stands and the extruder runs, the prime: Dialect::mayBeMissing.
bool isStandingLinkRow(const std::vector<std::string>& lines, std::size_t i, const LinkForm& form);

} // namespace voluta::program
