// Times, speeds and blends of a trajectory's motions for controllers that move the TCP in straight
// lines (URScript, RAPID, MELFA-BASIC, TMscript).
#pragma once

#include "base/units.h"
#include "program/common/extruder_outputs.h"
#include "program/common/motion_targets.h"
#include "program/program_input.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace voluta::program {

// How far from its corner on the part the nozzle may pass, mm: what arms repeat to. A corner that
// turns back on itself is not rounded at all: the plan all but stops there, and slender struts,
// whose beads turn on the spot, would lose some of their cover.
inline constexpr double kBlendToleranceMm = 0.02;
inline constexpr double kTurnsBackRad = 2.0 / 3.0 * base::kPi;

// The flow of an analogue output is held while the wanted one is within this share of it; the
// motions' times then give each its volume.
inline constexpr double kFlowBand = 0.02;

// What the moved tool is assumed to weigh: a plate with the whole part, or a head. kg.
double assumedLoadKg(const ProgramInput& input);
// Of what, for a program's remark.
std::string_view assumedLoadText(const ProgramInput& input);

// `targets`: one a point, their tcpMm as the program writes them, so that rounding doesn't become
// speed; in the frame in which the program moves it straight. The caller keeps both alive. Points
// are indices >= 0; motion i ends at point i.
class TcpMotions {
public:
  // `written`: a share of the full flow as the program's outputs say it; another extruder's words
  // (extruderOf) say it their own way.
  TcpMotions(const ProgramInput& input, const std::vector<MotionTarget>& targets,
             double (*written)(double share) = writtenShare);

  // The plan's time, of beads within kFlowBand of it, or what the extruder needs at its full flow.
  // 0 at point 0.
  double seconds(std::size_t i) const { return seconds_[i]; }
  // What the extruder gives in that time. 0 where there is none.
  double flowMm3PerS(std::size_t i) const { return flow_[i]; }
  // Length of the TCP's line. Precondition: i > 0.
  double tcpMm(std::size_t i) const;
  // 0 where it has no meaning.
  double speedMmPerS(std::size_t i) const;
  // Does the TCP move too little (a plate that turns about its own origin) for a speed to say how
  // long the motion takes? Precondition: i > 0.
  bool needsTime(std::size_t i) const;
  // Radius of the blend at the end of a straight motion, rounded down to 0.001 mm:
  // program/common/blend.h, only between two Print motions or two straight travels. 0: none.
  // Precondition: i > 0.
  double blendMm(std::size_t i) const;
  // What the TCP is accelerated by in that blend, at the speeds on both sides: through 2 r its
  // velocity turns. 0 without a blend.
  double blendMmPerS2(std::size_t i) const;

private:
  double tipMm(std::size_t i) const;

  const ProgramInput& in_;
  const std::vector<MotionTarget>& targets_;
  std::vector<double> seconds_, flow_;
};

} // namespace voluta::program
