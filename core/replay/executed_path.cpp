#include "replay/executed_path.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/units.h"
#include "geometry/polyline.h"
#include "replay/arm_speeds.h"
#include "replay/motion_target.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

constexpr double kTravelSampleMm = 1.0, kArmStepMm = 2.0, kArmStepRad = base::degreesToRadians(2.0),
                 kArmStepJointRad = 0.03, kArmStepExternalRad = 0.1;
constexpr double kNextRad = 0.2;         // a larger step between samples is a change of branch
constexpr double kMaxArmSteps = 20000.0; // bounds the run time for absurd numbers in a program
constexpr double kRangeSlackRad = 1e-4;  // rounding of joints in a program's text
constexpr std::size_t kGrain = 1024;

using Target = MotionTarget;

class Runner {
public:
  Runner(const plan::ReadProgram& program, const robot::Cell* cell, const base::RunContext& ctx,
         double printSampleMm)
      : program_(program), motions_(program.motions), cell_(cell), ctx_(ctx),
        printSampleMm_(printSampleMm), tcp_T_flange_(program.flange_T_tcp.inverse()) {}

  ExecutedPath run() {
    const std::size_t n = motions_.size();
    path_.arm = cell_ != nullptr && n > 0;
    for (const plan::ProgramMotion& m : motions_)
      path_.arm = path_.arm && m.target != plan::TargetKind::ToolPoint;
    externals_ = path_.arm ? cell_->dof() - cell_->armDof() : 0;
    inWork_ = path_.arm && (externals_ > 0 || anyIs(plan::TargetKind::WorkPose) ||
                            !anyIs(plan::TargetKind::FlangePose));
    path_.dof = cell_ != nullptr ? cell_->dof() : 0;
    path_.armDof = path_.dof - externals_;
    if (cell_ != nullptr)
      path_.kinds = robot::kindsOf(cell_->limits());
    path_.targetTip.resize(n);
    path_.targetDirection.resize(n);
    path_.commandedMm.assign(n, 0.0);
    path_.angleRad.assign(n, 0.0);
    path_.cornerRad.assign(n, 0.0);
    path_.durationS.assign(n, 0.0);
    path_.startS.assign(n, 0.0);
    findExternals();
    findTargets();
    findWays();
    findLengths();
    if (path_.arm)
      solveJoints();
    findDurations();
    if (path_.arm)
      for (const LimitViolation& v : speedViolations(path_, *cell_))
        path_.violations.push_back(v);
    sampleNozzle();
    std::stable_sort(
        path_.violations.begin(), path_.violations.end(),
        [](const LimitViolation& a, const LimitViolation& b) { return a.motion < b.motion; });
    return std::move(path_);
  }

private:
  bool anyIs(plan::TargetKind kind) const {
    return std::any_of(motions_.begin(), motions_.end(),
                       [&](const plan::ProgramMotion& m) { return m.target == kind; });
  }
  bool isToolPoint(std::size_t m) const {
    return motions_[m].target == plan::TargetKind::ToolPoint;
  }
  // Whether the target is given in the frame of the part, which external axes or the flange move.
  static bool isInWork(const plan::ProgramMotion& motion) {
    return motion.target == plan::TargetKind::WorkPose ||
           motion.target == plan::TargetKind::UnitPose;
  }
  bool isStraight(std::size_t m) const { return !motions_[m].jointInterpolated || !path_.arm; }
  JointVector jointsOf(std::size_t m) const {
    return Eigen::Map<const Eigen::VectorXd>(path_.jointsAt(m), path_.dof);
  }

  // Returns whether the first `count` values are given and all further ones are zero: controllers
  // may report more axes, which are at rest.
  static bool holds(const std::vector<double>& values, int count) {
    return static_cast<int>(values.size()) >= count &&
           std::all_of(values.begin() + count, values.end(), [](double v) { return v == 0.0; });
  }
  // A target with another number of values than the cell has axes is for another cell. Home is then
  // used in its place and the motion reported as out of reach.
  bool isOfThisCell(const plan::ProgramMotion& motion) const {
    if (motion.target == plan::TargetKind::Joints)
      return motion.externals.empty() ? static_cast<int>(motion.joints.size()) == cell_->dof()
                                      : holds(motion.joints, cell_->dof());
    if (motion.target == plan::TargetKind::UnitPose)
      return externals_ > 0 && holds(motion.externals, externals_);
    if (motion.target == plan::TargetKind::FlangePose)
      return motion.externals.empty() ||
             (externals_ > 0 && !cell_->axesMovePlatform() && holds(motion.externals, externals_));
    return !isInWork(motion) || static_cast<int>(motion.externals.size()) == externals_;
  }
  JointVector jointTarget(const plan::ProgramMotion& motion) const {
    if (!isOfThisCell(motion))
      return cell_->home();
    JointVector q = Eigen::Map<const Eigen::VectorXd>(motion.joints.data(), cell_->dof());
    if (!motion.externals.empty())
      for (int k = 0; k < externals_; ++k)
        q[cell_->armDof() + k] = externalOf(k, q[cell_->armDof() + k]);
    return q;
  }
  // Texts give one unit for all axes: degrees for turning axes, mm for sliding ones.
  double externalOf(int axis, double stated) const {
    const bool slides = cell_->externalAxes()[static_cast<std::size_t>(axis)].limits.kind ==
                        robot::JointKind::Sliding;
    return slides ? base::radiansToDegrees(stated) : stated;
  }

  std::vector<double> externalsOf(const JointVector& q) const {
    return {q.data() + cell_->armDof(), q.data() + cell_->dof()};
  }

  void findExternals() {
    if (externals_ == 0)
      return;
    const auto count = static_cast<std::size_t>(externals_);
    std::vector<double> now(count, 0.0);
    externalsAt_.reserve(motions_.size() * count);
    for (const plan::ProgramMotion& motion : motions_) {
      if (!isOfThisCell(motion))
        std::fill(now.begin(), now.end(), 0.0);
      else if (motion.target == plan::TargetKind::Joints)
        now = externalsOf(jointTarget(motion));
      else if (isInWork(motion) || !motion.externals.empty())
        for (int k = 0; k < externals_; ++k)
          now[static_cast<std::size_t>(k)] =
              externalOf(k, motion.externals[static_cast<std::size_t>(k)]);
      externalsAt_.insert(externalsAt_.end(), now.begin(), now.end());
    }
  }
  Eigen::Map<const Eigen::VectorXd> externalsAt(std::size_t m) const {
    return {externalsAt_.data() + m * static_cast<std::size_t>(externals_), externals_};
  }
  // Returns q with the external axes as they are at fraction s of motion m; the arm's joints are
  // unchanged.
  JointVector withExternals(std::size_t m, double s, JointVector q) const {
    if (externals_ > 0)
      q.tail(externals_) =
          m == 0 ? JointVector(externalsAt(0))
                 : JointVector(externalsAt(m - 1) + s * (externalsAt(m) - externalsAt(m - 1)));
    return q;
  }

  static Isometry3d poseOf(const Target& t) {
    Isometry3d pose = Isometry3d::Identity();
    pose.linear() = t.rotation.toRotationMatrix();
    pose.translation() = t.position;
    return pose;
  }
  void nozzleOf(const Target& t, bool toolPoint, Vector3d& tip, Vector3d& direction) const {
    if (toolPoint) {
      tip = t.position;
      direction = t.direction;
      return;
    }
    const Isometry3d work_T_tool =
        inWork_ ? poseOf(t) : cell_->work_T_toolOfFlange(poseOf(t) * tcp_T_flange_, cell_->home());
    tip = work_T_tool.translation();
    direction = -work_T_tool.linear().col(2);
  }
  // `q`: provides the external axes.
  Isometry3d flangeOf(const Target& t, const JointVector& q) const {
    return inWork_ ? cell_->base_T_flange(poseOf(t), q) : poseOf(t) * tcp_T_flange_;
  }

  // `frame_T_tcp`: of the motion, or on its way.
  Isometry3d poseOfTarget(std::size_t m, const Isometry3d& frame_T_tcp) const {
    const plan::ProgramMotion& motion = motions_[m];
    if (motion.target == plan::TargetKind::Joints) {
      const JointVector q = jointTarget(motion);
      return inWork_ ? cell_->work_T_tool(q)
                     : cell_->robot().kinematics->flange(q) * program_.flange_T_tcp;
    }
    if (!isOfThisCell(motion))
      return cell_->work_T_tool(cell_->home());
    // The program's own base and tool frames may differ from the cell's.
    if (motion.target == plan::TargetKind::WorkPose && program_.base_T_nozzle)
      return cell_->flange_T_moved().inverse() * program_.flange_T_tcp * frame_T_tcp *
             program_.base_T_nozzle->inverse() * cell_->base_T_fixed();
    if (isInWork(motion)) {
      const Isometry3d work_T_moved = frame_T_tcp * tcp_T_flange_ * cell_->flange_T_moved();
      return motion.target == plan::TargetKind::UnitPose ? cell_->work_T_unit() * work_T_moved
                                                         : work_T_moved;
    }
    if (!inWork_)
      return frame_T_tcp;
    const JointVector q = withExternals(m, 1.0, cell_->home());
    return cell_->work_T_toolOfFlange(cell_->base_T_world(q) * frame_T_tcp * tcp_T_flange_, q);
  }

  void findTargets() {
    targets_.resize(motions_.size());
    base::parallelChunks(ctx_, motions_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t m = begin; m < end; ++m) {
        const plan::ProgramMotion& motion = motions_[m];
        Target& t = targets_[m];
        if (motion.target == plan::TargetKind::ToolPoint) {
          t.position = motion.position;
          t.direction = motion.direction;
        } else {
          base::require(cell_ != nullptr, "replay: a program for an arm needs a cell");
          const Isometry3d pose = poseOfTarget(m, motion.frame_T_tcp);
          t.position = pose.translation();
          t.rotation = Quaterniond(pose.linear());
        }
        nozzleOf(t, isToolPoint(m), path_.targetTip[m], path_.targetDirection[m]);
      }
    });
  }

  void findWays() {
    viaPoints_.resize(motions_.size());
    for (std::size_t m = 1; m < motions_.size(); ++m) {
      Isometry3d pose = motions_[m].frame_T_tcp;
      for (const plan::NozzlePoint& point : motions_[m].viaPoints) {
        pose.translation() = point.position;
        viaPoints_[m].push_back(isToolPoint(m) ? point.position
                                               : poseOfTarget(m, pose).translation());
      }
    }
  }
  // Point 0 of the path of motion m is its start, viaPoints_[m].size() + 1 its end.
  const Vector3d& pathPoint(std::size_t m, std::size_t k) const {
    return k == 0                      ? targets_[m - 1].position
           : k <= viaPoints_[m].size() ? viaPoints_[m][k - 1]
                                       : targets_[m].position;
  }
  Vector3d chord(std::size_t m, std::size_t k) const {
    return pathPoint(m, k + 1) - pathPoint(m, k);
  }
  double lengthOf(std::size_t m) const {
    return geometry::polylineLength(viaPoints_[m].size() + 2,
                                    [&](std::size_t k) { return pathPoint(m, k); });
  }

  void findLengths() {
    for (std::size_t m = 1; m < motions_.size(); ++m) {
      const Vector3d leaving = chord(m, 0);
      path_.commandedMm[m] = lengthOf(m);
      path_.angleRad[m] = targets_[m].rotation.angularDistance(targets_[m - 1].rotation);
      if (m > 1) {
        const Vector3d before = chord(m - 1, viaPoints_[m - 1].size());
        path_.cornerRad[m - 1] = std::atan2(before.cross(leaving).norm(), before.dot(leaving));
      }
      const double blends = motions_[m].blendMm + motions_[m - 1].blendMm;
      if (blends > path_.commandedMm[m] + 1e-6 && isStraight(m) && motions_[m].blendMm > 0.0 &&
          motions_[m - 1].blendMm > 0.0)
        path_.violations.push_back({LimitKind::BlendOverlap, m, -1, blends, path_.commandedMm[m]});
    }
  }

  // Returns the usable half of the blend at the end of motion m: at most half of a motion.
  double blendAt(std::size_t m) const {
    if (m + 1 >= motions_.size() || m == 0 || !isStraight(m) || !isStraight(m + 1))
      return 0.0;
    return std::min(
        {motions_[m].blendMm, 0.5 * path_.commandedMm[m], 0.5 * path_.commandedMm[m + 1]});
  }

  // Returns the target at s in [0,1] of the time of straight motion m >= 1, without rounded
  // corners.
  Target onPath(std::size_t m, double s) const {
    const Target &from = targets_[m - 1], &to = targets_[m];
    if (viaPoints_[m].empty())
      return between(from, to, s);
    const double at = s * static_cast<double>(viaPoints_[m].size() + 1);
    const std::size_t piece = std::min(static_cast<std::size_t>(at), viaPoints_[m].size());
    const auto point = [&](std::size_t k) {
      Target t = k == 0 ? from : to;
      t.position = pathPoint(m, k);
      if (k > 0 && k <= viaPoints_[m].size())
        t.direction = motions_[m].viaPoints[k - 1].direction;
      return t;
    };
    Target t = between(point(piece), point(piece + 1), at - static_cast<double>(piece));
    t.rotation = from.rotation.slerp(s, to.rotation);
    return t;
  }

  // Returns the target at s in [0,1] of straight motion m >= 1, with rounded corners.
  Target along(std::size_t m, double s) const {
    const Target &a = targets_[m - 1], &b = targets_[m];
    const double length = path_.commandedMm[m];
    const double before = blendAt(m - 1), after = blendAt(m);
    const auto rounded = [](const Target& in, const Target& corner, const Target& out, double v) {
      return between(between(in, corner, v), between(corner, out, v), v);
    };
    if (before > 0.0 && s * length < before) {
      const Target in = onPath(m - 1, 1.0 - before / path_.commandedMm[m - 1]);
      return rounded(in, a, onPath(m, before / length), 0.5 + 0.5 * s * length / before);
    }
    if (after > 0.0 && (1.0 - s) * length < after) {
      const Target out = onPath(m + 1, after / path_.commandedMm[m + 1]);
      return rounded(onPath(m, 1.0 - after / length), b, out,
                     0.5 - 0.5 * (1.0 - s) * length / after);
    }
    return onPath(m, s);
  }

  // The arm's configurations along consecutive motions.
  struct ArmWalk {
    std::size_t begin = 0, end = 0; // motions
    // this and the following as in ExecutedPath: armJoints, armMotion, ...
    std::vector<double> joints;
    std::vector<std::uint32_t> motion;
    std::vector<float> fraction;
    std::vector<LimitViolation> violations;
    std::vector<JointVector> solutions; // scratch

    void push(std::size_t m, double at, const JointVector& q) {
      joints.insert(joints.end(), q.data(), q.data() + q.size());
      motion.push_back(static_cast<std::uint32_t>(m));
      fraction.push_back(static_cast<float>(at));
    }
  };

  // A walk may begin after any motion with a joint target, because its joints do not depend on the
  // motions before.
  std::vector<ArmWalk> walks() const {
    constexpr std::size_t kMin = 500; // motions
    std::vector<ArmWalk> walks(1);
    for (std::size_t m = 1; m < motions_.size(); ++m)
      if (motions_[m - 1].target == plan::TargetKind::Joints && m - walks.back().begin >= kMin) {
        walks.back().end = m;
        walks.emplace_back().begin = m;
      }
    walks.back().end = motions_.size();
    return walks;
  }

  void solveJoints() {
    path_.joints.assign(motions_.size() * static_cast<std::size_t>(path_.dof), 0.0);
    std::vector<ArmWalk> parts = walks();
    base::parallelChunks(ctx_, parts.size(), 1, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e && !ctx_.cancelled(); ++i)
        solveJoints(parts[i]);
    });
    ctx_.checkpoint();
    std::size_t states = 0;
    for (const ArmWalk& walk : parts)
      states += walk.motion.size();
    path_.armJoints.reserve(states * static_cast<std::size_t>(path_.dof));
    path_.armMotion.reserve(states);
    path_.armFraction.reserve(states);
    const auto append = [](auto& to, auto& from) {
      to.insert(to.end(), from.begin(), from.end());
      base::freeStorage(from);
    };
    for (ArmWalk& walk : parts) {
      append(path_.armJoints, walk.joints);
      append(path_.armMotion, walk.motion);
      append(path_.armFraction, walk.fraction);
      append(path_.violations, walk.violations);
    }
  }

  void solveJoints(ArmWalk& walk) {
    JointVector q = walk.begin == 0 ? cell_->home() : jointTarget(motions_[walk.begin - 1]);
    for (std::size_t m = walk.begin; m < walk.end; ++m) {
      const plan::ProgramMotion& motion = motions_[m];
      bool reached = true;
      JointVector target = q;
      if (motion.target == plan::TargetKind::Joints)
        target = jointTarget(motion);
      if (!isOfThisCell(motion))
        walk.violations.push_back({LimitKind::OutOfReach, m, -1, 0.0, 0.0});
      if (m == 0 || motion.jointInterpolated) {
        if (motion.target != plan::TargetKind::Joints)
          reached = follow(m, 1.0, target, walk.solutions);
        if (m == 0) {
          walk.push(m, 1.0, target);
        } else {
          const double rotation = robot::largestRotation(target - q, cell_->limits());
          const int steps = stepsOf(rotation / kArmStepJointRad);
          for (int k = 1; k <= steps; ++k) {
            const double u = static_cast<double>(k) / steps;
            walk.push(m, u, q + u * (target - q));
          }
        }
        q = target;
      } else {
        const int steps = armSteps(m);
        for (int k = 1; k <= steps; ++k) {
          const double u = static_cast<double>(k) / steps;
          if (k == steps && motion.target == plan::TargetKind::Joints)
            q = jointTarget(motion);
          else
            reached = follow(m, u, q, walk.solutions) && reached;
          walk.push(m, u, q);
        }
      }
      if (!reached)
        walk.violations.push_back({LimitKind::OutOfReach, m, -1, 0.0, 0.0});
      checkRange(m, q, walk.violations);
      std::copy(q.data(), q.data() + q.size(),
                path_.joints.data() + m * static_cast<std::size_t>(path_.dof));
    }
  }

  static int stepsOf(double count) {
    return static_cast<int>(std::clamp(std::ceil(count), 1.0, kMaxArmSteps));
  }
  int armSteps(std::size_t m) const {
    const Target &a = targets_[m - 1], &b = targets_[m];
    double rotation = a.rotation.angularDistance(b.rotation), external = 0.0;
    if (externals_ > 0) {
      const JointVector from = withExternals(m, 0.0, cell_->home()),
                        to = withExternals(m, 1.0, cell_->home());
      external = robot::largestRotation(to - from, cell_->limits());
      rotation = Quaterniond(flangeOf(a, from).linear())
                     .angularDistance(Quaterniond(flangeOf(b, to).linear()));
    }
    return stepsOf(std::max({path_.commandedMm[m] / kArmStepMm, rotation / kArmStepRad,
                             external / kArmStepExternalRad}));
  }

  // Sets q to the joints nearest to it that reach motion m at s; leaves the arm's joints unchanged
  // and returns false if there are none.
  bool follow(std::size_t m, double s, JointVector& q, std::vector<JointVector>& scratch) const {
    const Target t =
        m == 0 || motions_[m].jointInterpolated || s >= 1.0 ? targets_[m] : onPath(m, s);
    q = withExternals(m, s, q);
    const int arm = cell_->armDof();
    if (const auto next = robot::nextBranch(cell_->robot(), flangeOf(t, q), q, kNextRad)) {
      q.head(arm) = *next;
      return true;
    }
    robot::inverseNear(cell_->robot(), flangeOf(t, q), q, scratch);
    // A straight motion cannot change the elbow side on its way: a target on the other side is a
    // jump at its end.
    if (const int elbow = s >= 1.0 && !cell_->robot().kinematics->tilts() ? motions_[m].elbow : 0)
      std::erase_if(scratch, [&](const JointVector& candidate) {
        return elbow * candidate[1] < -kRangeSlackRad;
      });
    if (scratch.empty())
      return false;
    const auto away = [&](const JointVector& candidate) {
      return robot::asAngles(candidate - q.head(arm), cell_->limits()).squaredNorm();
    };
    q.head(arm) = *std::min_element(
        scratch.begin(), scratch.end(),
        [&](const JointVector& a, const JointVector& b) { return away(a) < away(b); });
    return true;
  }

  void checkRange(std::size_t m, const JointVector& q,
                  std::vector<LimitViolation>& violations) const {
    for (int k = 0; k < path_.dof; ++k) {
      const robot::JointLimits& limits = cell_->limits()[static_cast<std::size_t>(k)];
      const double slack = robot::fromAngle(limits.kind, kRangeSlackRad);
      if (q[k] < limits.min - slack || q[k] > limits.max + slack)
        violations.push_back(
            {LimitKind::JointRange, m, k, q[k], q[k] < limits.min ? limits.min : limits.max});
    }
  }

  void findDurations() {
    double t = 0.0;
    for (std::size_t m = 0; m < motions_.size(); ++m) {
      const plan::ProgramMotion& motion = motions_[m];
      double duration = 0.0;
      if (motion.durationS > 0.0) {
        duration = motion.durationS;
      } else if (m > 0 && path_.arm && motion.jointInterpolated && motion.jointSpeedRadPerS > 0.0) {
        duration = robot::largestRotation(jointsOf(m) - jointsOf(m - 1), cell_->limits()) /
                   motion.jointSpeedRadPerS;
      } else if (m > 0 && motion.speedMmPerS > 0.0) {
        duration = path_.commandedMm[m] / motion.speedMmPerS;
        // A pure rotation has no length; the controller then rotates as fast as the joints allow.
        if (path_.arm && path_.commandedMm[m] < 0.05)
          duration = std::max(duration, fastest(m));
      }
      path_.durationS[m] = duration;
      path_.startS[m] = t;
      t += duration;
    }
  }
  double fastest(std::size_t m) const {
    const JointVector step = jointsOf(m) - jointsOf(m - 1);
    double time = 0.0;
    for (int k = 0; k < path_.dof; ++k)
      time =
          std::max(time, std::abs(step[k]) / cell_->limits()[static_cast<std::size_t>(k)].velocity);
    return time;
  }

  void sampleNozzle() {
    const std::size_t n = motions_.size();
    path_.firstSample.assign(n + 1, 0);
    std::vector<std::uint32_t> counts(n, 1);
    base::parallelChunks(ctx_, n, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t m = std::max<std::size_t>(begin, 1); m < end; ++m)
        counts[m] = sampleCount(m);
    });
    for (std::size_t m = 0; m < n; ++m)
      path_.firstSample[m + 1] = path_.firstSample[m] + counts[m];
    path_.tip.resize(path_.firstSample[n]);
    path_.direction.resize(path_.firstSample[n]);
    base::parallelChunks(ctx_, n, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t m = begin; m < end; ++m)
        for (std::size_t k = 0; k < counts[m]; ++k) {
          const std::size_t s = path_.firstSample[m] + k;
          nozzleAt(m, static_cast<double>(k + 1) / counts[m], path_.tip[s], path_.direction[s]);
        }
    });
  }

  void nozzleAt(std::size_t m, double u, Vector3d& tip, Vector3d& direction) const {
    if (m == 0) {
      tip = path_.targetTip[0];
      direction = path_.targetDirection[0];
    } else if (isStraight(m)) {
      nozzleOf(along(m, u), isToolPoint(m), tip, direction);
    } else {
      const JointVector a = jointsOf(m - 1), q = a + u * (jointsOf(m) - a);
      const Isometry3d work_T_tool = cell_->work_T_tool(q);
      tip = work_T_tool.translation();
      direction = -work_T_tool.linear().col(2);
    }
  }

  // Estimated from eight chords, because tip and TCP may move very differently.
  std::uint32_t sampleCount(std::size_t m) const {
    const double step = motions_[m].extruding ? printSampleMm_ : kTravelSampleMm;
    Vector3d last = path_.targetTip[m - 1], direction;
    double longest = 0.0;
    constexpr int kChords = 8;
    const bool straight = viaPoints_[m].empty();
    const bool plain =
        straight && (isToolPoint(m) || (isStraight(m) && externals_ > 0) ||
                     (isStraight(m) && path_.commandedMm[m] < 2.0 &&
                      targets_[m - 1].rotation.angularDistance(targets_[m].rotation) < 0.02));
    if (!straight && isToolPoint(m)) {
      const std::size_t pieces = viaPoints_[m].size() + 1;
      for (std::size_t k = 0; k < pieces; ++k)
        longest = std::max(longest, static_cast<double>(pieces) / kChords * chord(m, k).norm());
    } else if (plain) {
      longest = (path_.targetTip[m] - last).norm() / kChords;
    } else {
      for (int k = 1; k <= kChords; ++k) {
        Vector3d tip;
        nozzleAt(m, static_cast<double>(k) / kChords, tip, direction);
        longest = std::max(longest, (tip - last).norm());
        last = tip;
      }
    }
    if (!straight)
      longest = std::max(longest, step / kChords *
                                      chordsOfArc(path_.commandedMm[m], chord(m, 0),
                                                  chord(m, viaPoints_[m].size())));
    // Chords are shorter than the curve.
    const double count = std::ceil(longest * kChords / (plain ? step : 0.98 * step) - 1e-3);
    return static_cast<std::uint32_t>(std::clamp(count, 1.0, 20000.0));
  }

  const plan::ReadProgram& program_;
  const std::vector<plan::ProgramMotion>& motions_;
  const robot::Cell* cell_;
  const base::RunContext& ctx_;
  double printSampleMm_;
  Isometry3d tcp_T_flange_;
  bool inWork_ = false; // targets are poses of the nozzle in the work frame, not of the TCP in Base
  int externals_ = 0;   // number of axes
  std::vector<double> externalsAt_; // at each motion's end
  std::vector<Target> targets_;
  std::vector<std::vector<Vector3d>> viaPoints_; // per motion: points that it passes, as its target
  ExecutedPath path_;
};

} // namespace

ExecutedPath executeProgram(const plan::ReadProgram& program, const robot::Cell& cell,
                            const base::RunContext& ctx, double printSampleMm) {
  return Runner(program, &cell, ctx, printSampleMm).run();
}

ExecutedPath executeToolPoints(const plan::ReadProgram& program, const base::RunContext& ctx) {
  return Runner(program, nullptr, ctx, kPrintSampleMm).run();
}

} // namespace voluta::replay
