#include "program/rapid/rapid_motions.h"

#include "base/units.h"
#include "program/common/arc_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace voluta::program {

namespace {
constexpr double kUnused = 9e9; // Marks an unused axis
constexpr double kMaxMm = kMaxRapidMm, kMaxDegrees = 6000.0, kMaxSeconds = 1e5;
constexpr double kMaxExternalDegrees = 1e7;
constexpr std::size_t kExternals = 6;
} // namespace

void RapidMotions::unit(const std::string& name, bool active) {
  if (active)
    activeUnits_.insert(name);
  else
    activeUnits_.erase(name);
}

// An active unit moves something: if the work object is stationary, the robot.
bool RapidMotions::mayMoveRobot() const {
  return activeUnits_.size() > (hasExtruder() ? 1u : 0u);
}

bool RapidMotions::hasExtruder() const {
  return activeUnits_.contains(kRapidExtruderUnit);
}

bool RapidMotions::fail(base::Message reason) {
  reason_ = std::move(reason);
  return false;
}

bool RapidMotions::fill(const RapidMotionData& data, plan::ProgramMotion& motion,
                        base::Message& reason) {
  const bool filled = externalOf(data, motion) && targetOf(data, motion) && arcOf(data, motion) &&
                      zoneOf(data.zone.numbers, motion) &&
                      speedOf(data.speed.numbers, data.timed, motion);
  if (!filled)
    reason = std::move(reason_);
  return filled;
}

std::optional<double> RapidMotions::extruderAlone(const std::vector<double>& target) const {
  const auto given =
      std::find_if(target.begin(), target.end(), [](double value) { return value != kUnused; });
  const auto own = static_cast<std::ptrdiff_t>(target.size() - kExternals + extruderAt_);
  const bool alone =
      hasExtruder() && extruderMm_ && given == target.begin() + own &&
      std::all_of(given + 1, target.end(), [](double value) { return value == kUnused; });
  return alone ? std::optional(*given) : std::nullopt;
}

std::optional<double> RapidMotions::tcpLengthMm(const plan::ProgramMotion& motion) const {
  if (!last_ || lastKind_ != motion.target || motion.jointInterpolated)
    return std::nullopt;
  return lengthMm(last_->translation(), motion);
}

void RapidMotions::done(const plan::ProgramMotion& motion) {
  last_ =
      motion.target == plan::TargetKind::Joints ? std::nullopt : std::optional(motion.frame_T_tcp);
  lastKind_ = motion.target;
  lastExternal_ = motion.externals;
}

// eax_a and on, if they move the motion's work object or the robot, followed by the extruder's
// axis.
bool RapidMotions::externalOf(const RapidMotionData& data, plan::ProgramMotion& m) {
  const RapidData& object = data.object;
  const std::vector<double>& target = data.target.numbers;
  if (holdsObject(object) && isMoved(object))
    return fail("a work object moved by both robot and external axis is not supported"_text);
  const auto first = target.end() - kExternals;
  auto unused = std::find(first, target.end(), kUnused);
  if (std::any_of(unused, target.end(), [](double external) { return external != kUnused; }))
    return fail("an external axis after an unused one is not supported"_text);
  if (std::any_of(first, unused,
                  [](double degrees) { return !(std::abs(degrees) <= kMaxExternalDegrees); }))
    return fail("an external axis far outside any limit"_text);
  extruderMm_.reset();
  if (hasExtruder()) {
    if (unused == first)
      return fail("the extruder's axis is missing"_text);
    extruderMm_ = *--unused;
    extruderAt_ = static_cast<std::size_t>(unused - first);
  }
  if (isMoved(object) && unused == first)
    return fail("eax_a is missing: an external axis moves the work object"_text);
  if (!isMoved(object) && unused != first && (holdsObject(object) || !mayMoveRobot()))
    return fail("an external axis that moves no work object is not supported"_text);
  if (isMoved(object) && !activeUnits_.contains(object.text))
    out_.defect(base::message("mechanical unit '{text}' is not active: ActUnit"_text, object.text));
  for (auto degrees = first; degrees != unused; ++degrees)
    m.externals.push_back(base::degreesToRadians(*degrees));
  return true;
}

bool RapidMotions::targetOf(const RapidMotionData& data, plan::ProgramMotion& m) {
  const RapidData& object = data.object;
  const std::vector<double>&target = data.target.numbers, &tool = data.tool.numbers;
  Eigen::Isometry3d tcp, user, frame, pose;
  if (!rapidPose(tool, 1, tcp, reason_) || !rapidPose(object.numbers, 3, user, reason_) ||
      !rapidPose(object.numbers, 10, frame, reason_))
    return false;
  const bool held = holdsObject(object);
  if (held == (tool[0] == 1.0))
    return fail("the robot must hold either the tool or the work object"_text);
  if (data.absolute) {
    m.target = plan::TargetKind::Joints;
    for (std::size_t k = 0; k < 6; ++k) {
      if (!(std::abs(target[k]) <= kMaxDegrees))
        return fail("a joint value far outside any limit"_text);
      m.joints.push_back(base::degreesToRadians(target[k]));
    }
    m.joints.insert(m.joints.end(), m.externals.begin(), m.externals.end());
  } else {
    if (!rapidPose(target, 0, pose, reason_))
      return false;
    for (std::size_t k = 7; k < 11; ++k)
      if (!(std::abs(target[k]) <= 100.0 && target[k] == std::floor(target[k])))
        return fail("a configuration that is not in whole quarter turns"_text);
    // The user frame of a moved work object is the mechanical unit's; that of one held by the
    // flange is the flange's.
    m.target = held              ? plan::TargetKind::WorkPose
               : isMoved(object) ? plan::TargetKind::UnitPose
                                 : plan::TargetKind::FlangePose;
    m.frame_T_tcp = held              ? pose
                    : isMoved(object) ? Eigen::Isometry3d(frame * pose)
                                      : Eigen::Isometry3d(user * frame * pose);
  }
  const std::optional<Eigen::Isometry3d> nozzle = held ? std::optional(tcp) : std::nullopt;
  const Eigen::Isometry3d carried = held ? Eigen::Isometry3d(user * frame) : tcp;
  const bool first = !out_.toolSet();
  if (!out_.tool(carried, nozzle))
    return fail("a second, different tool"_text);
  constexpr std::size_t kMass = 8; // tool0 has no load
  if (first && tool.size() > kMass) {
    const std::size_t here =
        std::exchange(out_.line, data.toolLine > 0 ? data.toolLine : out_.line);
    out_.load("tooldata", tool[kMass],
              tool.size() > kMass + 3 ? std::optional(Eigen::Vector3d(tool.data() + kMass + 1))
                                      : std::nullopt);
    out_.line = here;
  }
  return true;
}

bool RapidMotions::arcOf(const RapidMotionData& data, plan::ProgramMotion& m) {
  if (!data.via)
    return true;
  Eigen::Isometry3d user, frame, pose;
  const std::vector<double>& object = data.object.numbers;
  if (!rapidPose(object, 3, user, reason_) || !rapidPose(object, 10, frame, reason_) ||
      !rapidPose(data.via->numbers, 0, pose, reason_))
    return false;
  if (!last_ || lastKind_ != m.target)
    return fail("an arc from a position that is not known"_text);
  if (m.target == plan::TargetKind::UnitPose)
    pose = frame * pose;
  else if (m.target == plan::TargetKind::FlangePose)
    pose = user * frame * pose;
  auto wrong = setArc(last_->translation(), pose.translation(), m);
  return !wrong || fail(std::move(*wrong));
}

bool RapidMotions::zoneOf(const std::vector<double>& zone, plan::ProgramMotion& m) {
  for (std::size_t k = 1; k < 7; ++k)
    if (!(zone[k] >= 0.0 && zone[k] <= kMaxMm))
      return fail("an invalid zone"_text);
  if (zone[0] == 1.0)
    return true;
  if (zone[2] < zone[1] || zone[3] < zone[1])
    return fail("a zone for orientation or external axes smaller than the TCP's"_text);
  m.blendMm = zone[1];
  return true;
}

bool RapidMotions::speedOf(const std::vector<double>& speed, bool timed, plan::ProgramMotion& m) {
  for (const double v : speed)
    if (!(v > 0.0 && v <= kMaxMm))
      return fail("an invalid speed"_text);
  if (timed)
    return (m.durationS > 0.0 && m.durationS <= kMaxSeconds) || fail("an invalid time"_text);
  m.speedMmPerS = speed[0];
  const std::optional<double> distance = tcpLengthMm(m);
  if (!distance)
    return true;
  const double angle =
      base::radiansToDegrees(Eigen::Quaterniond(m.frame_T_tcp.linear())
                                 .angularDistance(Eigen::Quaterniond(last_->linear())));
  double waits = angle / speed[1];
  for (std::size_t k = 0; k < std::min(m.externals.size(), lastExternal_.size()); ++k)
    waits = std::max(waits, base::radiansToDegrees(std::abs(m.externals[k] - lastExternal_[k])) /
                                speed[3]);
  if (waits > *distance / speed[0] + 1e-9) {
    m.durationS = waits;
    m.speedMmPerS = 0.0;
  }
  return true;
}

} // namespace voluta::program
