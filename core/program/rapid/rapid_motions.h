// Interprets the data of a RAPID motion: target, external axes, speed and zone.
#pragma once

#include "base/text.h"
#include "plan/program.h"
#include "program/program_builder.h"
#include "program/rapid/rapid_data.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// The mechanical unit of an extruder that is an external axis (program/gcode/extruder_axis.h):
// while it is active, the last axis given in a target is the extruder's.
inline constexpr std::string_view kRapidExtruderUnit = "extruder";

struct RapidMotionData {
  bool absolute = false;        // MoveAbsJ: joint target
  bool timed = false;           // The motion already has its \T
  std::optional<RapidData> via; // MoveC: the circle point
  RapidData target, speed, zone, tool, object;
  std::size_t toolLine = 0; // Line of the tool's declaration; 0: unknown
};

class RapidMotions {
public:
  explicit RapidMotions(ProgramBuilder& out) : out_(out) {}

  void unit(const std::string& name, bool active);
  bool hasExtruder() const;

  // Fills in `motion` from the data; its interpolation and time are already set. Passes tool and
  // load to the builder. Returns false, with `reason`, if the data form no valid motion.
  bool fill(const RapidMotionData& data, plan::ProgramMotion& motion, base::Message& reason);
  // Returns the extruder's axis in the last motion filled [mm]; nullopt without such an axis.
  std::optional<double> extruderMm() const { return extruderMm_; }
  // Returns the extruder's axis in a target of MoveExtJ that moves nothing else.
  std::optional<double> extruderAlone(const std::vector<double>& jointtarget) const;

  // Returns the length of the TCP's path; nullopt if its start is unknown.
  std::optional<double> tcpLengthMm(const plan::ProgramMotion& motion) const;
  // Records the motion as the start of the next one.
  void done(const plan::ProgramMotion& motion);

private:
  bool mayMoveRobot() const;
  bool externalOf(const RapidMotionData& data, plan::ProgramMotion& motion);
  bool targetOf(const RapidMotionData& data, plan::ProgramMotion& motion);
  bool arcOf(const RapidMotionData& data, plan::ProgramMotion& motion);
  bool zoneOf(const std::vector<double>& zone, plan::ProgramMotion& motion);
  bool speedOf(const std::vector<double>& speed, bool timed, plan::ProgramMotion& motion);
  bool fail(base::Message reason);

  ProgramBuilder& out_;
  base::Message reason_;
  std::set<std::string, std::less<>> activeUnits_;
  std::optional<double> extruderMm_;
  std::size_t extruderAt_ = 0; // Index in a target's external axes, where it was given
  // Of the last motion, if its pose is known.
  std::optional<Eigen::Isometry3d> last_; // frame_T_tcp
  plan::TargetKind lastKind_ = plan::TargetKind::FlangePose;
  std::vector<double> lastExternal_;
};

} // namespace voluta::program
