// What the data of a RAPID motion make of it: target, external axes, speed and zone.
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
// while it is active the last of the axes that a target gives is the extruder's.
inline constexpr std::string_view kRapidExtruderUnit = "extruder";

struct RapidMotionData {
  bool absolute = false; // MoveAbsJ: the target is joints
  bool timed = false;    // \T, which the motion has already
  RapidData target, speed, zone, tool, object;
  std::size_t toolLine = 0; // where the tool was declared; 0: it is not known
};

class RapidMotions {
public:
  explicit RapidMotions(ProgramBuilder& out) : out_(out) {}

  void unit(const std::string& name, bool active);
  bool hasExtruder() const;

  // Fills in what the data say of `motion`, which knows whether joints lead it, and its time. Tells
  // the builder tool and load. false: no motion is made of them, for `reason`.
  bool fill(const RapidMotionData& data, plan::ProgramMotion& motion, base::Message& reason);
  // Of the last one that was filled: where the extruder's axis goes, mm; nothing without one.
  std::optional<double> extruderMm() const { return extruderMm_; }
  // The extruder's axis of a target of MoveExtJ that moves nothing else.
  std::optional<double> extruderAlone(const std::vector<double>& jointtarget) const;

  // How far the TCP goes straight; nothing where it is not known from where.
  std::optional<double> wayMm(const plan::ProgramMotion& motion) const;
  // The next one goes on from there.
  void done(const plan::ProgramMotion& motion);

private:
  bool mayMoveRobot() const;
  bool externalOf(const RapidMotionData& data, plan::ProgramMotion& motion);
  bool targetOf(const RapidMotionData& data, plan::ProgramMotion& motion);
  bool zoneOf(const std::vector<double>& zone, plan::ProgramMotion& motion);
  bool speedOf(const std::vector<double>& speed, bool timed, plan::ProgramMotion& motion);
  bool fail(base::Message reason);

  ProgramBuilder& out_;
  base::Message reason_;
  std::set<std::string, std::less<>> activeUnits_;
  std::optional<double> extruderMm_;
  std::size_t extruderAt_ = 0; // among a target's external axes, where it was given
  // Of the last motion, where its pose is known.
  std::optional<Eigen::Isometry3d> last_; // frame_T_tcp
  plan::TargetKind lastKind_ = plan::TargetKind::FlangePose;
  std::vector<double> lastExternal_;
};

} // namespace voluta::program
