// Times, speeds and blends of a trajectory's motions for controllers that move the TCP along
// straight lines (URScript, RAPID, MELFA-BASIC, TMscript).
#pragma once

#include "base/units.h"
#include "program/common/arc.h"
#include "program/common/extruder_outputs.h"
#include "program/common/motion_targets.h"
#include "program/program_input.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace voluta::program {

// Maximum distance at which the nozzle passes its corner on the part [mm]: the repeatability of
// arms. Corners that turn back are not blended: the plan almost stops there, and slender struts,
// whose beads reverse on the spot, would lose coverage.
inline constexpr double kBlendToleranceMm = 0.02;
inline constexpr double kTurnsBackRad = 2.0 / 3.0 * base::kPi;

// The flow of an analogue output is kept while the wanted flow is within this share of it; the
// times of the motions are adjusted so that each gets its volume.
inline constexpr double kFlowBand = 0.02;

// Returns the assumed mass of the moved tool [kg]: a plate with the whole part, or a head.
double assumedLoadKg(const ProgramInput& input);
// Describes that load, for a remark in the program.
std::string_view assumedLoadText(const ProgramInput& input);

// The frame of the targets' tcpMm and tcpRotation (MotionTarget, placeInWorkFrame).
enum class TcpFrame { Base, Work };

// Returns the orientation and position of the TCP at the point of an arc that its motion passes, in
// the frame of `targets`.
struct ViaTarget {
  Eigen::Quaterniond rotation;
  Eigen::Vector3d mm;
};
ViaTarget viaTarget(const ProgramInput& input, const std::vector<MotionTarget>& targets,
                    TcpFrame frame, const ArcVia& arc);

// `targets`: one per point, with tcpMm as the program writes them, so that rounding does not become
// speed; in the frame in which the program moves along straight lines. Both arguments must outlive
// the object. Points are indices >= 0; motion i ends at point i.
class TcpMotions {
public:
  // `written`: converts a share of the full flow to the value that the program's outputs represent;
  // other extruders (extruderOf) have their own conversion. `frame`: of the targets as they are
  // when the other functions are called.
  TcpMotions(const ProgramInput& input, const std::vector<MotionTarget>& targets,
             double (*written)(double share) = writtenShare, TcpFrame frame = TcpFrame::Base);

  // Returns the planned time; for beads adjusted by up to kFlowBand, or the time that the extruder
  // needs at its full flow. 0 at point 0.
  double seconds(std::size_t i) const { return seconds_[i]; }
  // Returns the extruder's flow during that time; 0 if there is none.
  double flowMm3PerS(std::size_t i) const { return flow_[i]; }
  // Returns the point that motion i passes if it is an arc; nullptr: it is straight.
  const ArcVia* arc(std::size_t i) const;
  // Length of the TCP's line or arc. Precondition: i > 0.
  double tcpMm(std::size_t i) const;
  // 0 if undefined.
  double speedMmPerS(std::size_t i) const;
  // Returns whether the TCP moves too little (e.g. a plate that turns about its own origin) for a
  // speed to define the motion's time. Precondition: i > 0.
  bool needsTime(std::size_t i) const;
  // Returns the radius of the blend at the end of a straight motion, rounded down to 0.001 mm
  // (program/common/blend.h); only between two Print motions or two straight travels. 0: none.
  // Precondition: i > 0.
  double blendMm(std::size_t i) const;
  // Returns the acceleration of the TCP in that blend, at the speeds on both sides: its velocity
  // changes direction over 2 r. 0 without a blend.
  double blendMmPerS2(std::size_t i) const;

private:
  enum class End { Start, Stop };
  double tipMm(std::size_t i) const;
  std::optional<Arc> tipArc(std::size_t i) const;
  std::optional<Arc> tcpArc(std::size_t i) const;
  // Return the length of motion i in its direction at one of its ends.
  Eigen::Vector3d tipAlong(std::size_t i, End end) const;
  Eigen::Vector3d tcpAlong(std::size_t i, End end) const;

  const ProgramInput& in_;
  const std::vector<MotionTarget>& targets_;
  TcpFrame frame_;
  std::vector<double> seconds_, flow_;
};

} // namespace voluta::program
