#include "replay/shared_run.h"

#include "base/error.h"
#include "base/run_context.h"
#include "replay/any_start.h"
#include "replay/controller_time.h"
#include "replay/distances.h"
#include "replay/executed_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace voluta::replay {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::BodyRole;

constexpr std::size_t kMaxMeetings = 20;
constexpr double kGridMm = 10.0;

bool isStill(const robot::Cell& cell, const robot::Body& body) {
  const bool movesNozzle = cell.nozzleMount() == robot::Mount::Flange;
  return body.frame == cell.worldFrame() || (body.frame == 0 && cell.axesUnderRobot() == 0) ||
         (body.frame == cell.workFrame() && movesNozzle && !cell.axesMovePlatform()) ||
         (body.frame == cell.toolFrame() && !movesNozzle);
}

struct Solid {
  int body = 0, frame = 0;
  robot::Shape shape;
  Ball ball; // in the frame
  bool isEroded = false, isStill = false;
};

// Points on the centrelines of beads, by place; work frame.
class DepositedPoints {
public:
  void add(const Vector3d& point, double whenS) {
    cells_[keyOf(cellOf(point))].push_back({point, whenS});
    bounds_.extend(point);
  }
  // Returns a point laid before `nowS` for which isInside(point) holds, within a ball.
  template <typename Inside>
  std::optional<Vector3d> find(const Vector3d& centre, double radius, double nowS,
                               const Inside& isInside) const {
    if (bounds_.isEmpty() || bounds_.exteriorDistance(centre) > radius)
      return std::nullopt;
    const Vector3d reach = Vector3d::Constant(radius);
    const Eigen::Vector3i low = cellOf((centre - reach).cwiseMax(bounds_.min())),
                          high = cellOf((centre + reach).cwiseMin(bounds_.max()));
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x)
          if (const auto cell = cells_.find(keyOf({x, y, z})); cell != cells_.end())
            for (const Deposited& deposited : cell->second)
              if (deposited.whenS < nowS && isInside(deposited.point))
                return deposited.point;
    return std::nullopt;
  }

private:
  struct Deposited {
    Vector3d point;
    double whenS;
  };
  static Eigen::Vector3i cellOf(const Vector3d& point) {
    return (point / kGridMm).array().floor().matrix().cast<int>();
  }
  static std::uint64_t keyOf(const Eigen::Vector3i& cell) {
    constexpr int kOffset = 1 << 20;
    const auto part = [](int i) { return static_cast<std::uint64_t>(i + kOffset) & 0x1fffff; };
    return part(cell.x()) << 42 | part(cell.y()) << 21 | part(cell.z());
  }
  std::unordered_map<std::uint64_t, std::vector<Deposited>> cells_;
  Eigen::AlignedBox3d bounds_;
};

// A machine along the common clock.
class Follower {
public:
  Follower(const PlacedProgram& machine, const ExecutedPath& path, const MachineClock& clock)
      : machine_(machine), path_(path), clock_(clock) {
    base::require(path.arm, "runTogether: the program states the arm");
    addSolids();
    layBeads();
  }

  // Moves on to a time, not before the last one.
  void moveTo(double nowS) {
    while (motion_ + 1 < clock_.beginS.size() && clock_.beginS[motion_ + 1] <= nowS)
      ++motion_;
    const robot::JointVector q = jointsAt(nowS);
    machine_.cell.framePoses(q, frames_);
    const Isometry3d shared_T_base =
        machine_.shared_T_world * machine_.cell.base_T_world(q).inverse(Eigen::Isometry);
    for (Isometry3d& frame : frames_)
      frame = shared_T_base * frame;
    centres_.clear();
    for (const Solid& s : solids_)
      centres_.push_back(poseOf(s) * s.ball.centre);
  }

  const std::vector<Solid>& solids() const { return solids_; }
  const Vector3d& centreOf(std::size_t solid) const { return centres_[solid]; }
  const Isometry3d& poseOf(const Solid& s) const {
    return frames_[static_cast<std::size_t>(s.frame)];
  }
  const robot::Body& bodyOf(const Solid& s) const {
    return machine_.cell.bodies()[static_cast<std::size_t>(s.body)];
  }
  Isometry3d shared_T_work() const {
    return frames_[static_cast<std::size_t>(machine_.cell.workFrame())];
  }
  const DepositedPoints& deposited() const { return deposited_; }
  double beadRadiusMm() const { return 0.5 * machine_.process.beadWidthMm; }

  bool isAgainstObstacles(const Solid& s) const {
    const auto& bodies = machine_.cell.bodies();
    const auto isObstacle = [&](int b) {
      return bodies[static_cast<std::size_t>(b)].role == BodyRole::Obstacle;
    };
    bool has = false, checked = false;
    for (const robot::Body& body : bodies)
      has = has || body.role == BodyRole::Obstacle;
    for (const auto& [a, b] : machine_.cell.checkedPairs())
      checked = checked || (a == s.body && isObstacle(b)) || (b == s.body && isObstacle(a));
    return !has || checked;
  }

private:
  void addSolids() {
    const auto& bodies = machine_.cell.bodies();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const robot::Body& body = bodies[b];
      const bool still = isStill(machine_.cell, body);
      for (const robot::Shape& shape : body.shapes)
        if (body.role != BodyRole::Head)
          solids_.push_back(
              {static_cast<int>(b), body.frame, shape, ballRound(shape), false, still});
      if (body.role == BodyRole::Head)
        addHead(static_cast<int>(b), body.frame, still);
    }
  }
  // The eroded head is for plates and parts, to which it is meant to be close.
  void addHead(int body, int frame, bool still) {
    const process::Process& p = machine_.process;
    Isometry3d tool_T_head = Isometry3d::Identity();
    tool_T_head.linear() = Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix();
    const auto add = [&](const process::HeadShape& head, bool eroded) {
      const HeadSolid solid(head);
      for (const robot::Shape& shape : solid.frusta()) {
        robot::Frustum f = std::get<robot::Frustum>(shape);
        f.p0 = tool_T_head * f.p0;
        f.p1 = tool_T_head * f.p1;
        solids_.push_back({body, frame, f, ballRound(f), eroded, still});
      }
    };
    add(p.head, false);
    add(process::erodedHead(p.head, p.contactToleranceMm), true);
  }

  void layBeads() {
    const double below = 0.5 * machine_.process.layerHeightMm;
    for (const Vector3d& point : machine_.printedEarlier)
      deposited_.add(point, -std::numeric_limits<double>::infinity());
    for (std::size_t m = 0; m < clock_.beginS.size(); ++m) {
      if (!machine_.program.motions[m].extruding)
        continue;
      for (std::size_t s = path_.firstSample[m]; s < path_.firstSample[m + 1]; ++s)
        deposited_.add(path_.tip[s] - below * path_.direction[s], clock_.endS[m]);
    }
  }

  robot::JointVector jointsAt(double nowS) {
    const auto dof = static_cast<Eigen::Index>(path_.dof);
    const auto at = [&](std::size_t sample) {
      return Eigen::Map<const Eigen::VectorXd>(
          path_.armJoints.data() + sample * static_cast<std::size_t>(path_.dof), dof);
    };
    const double lasts = clock_.endS[motion_] - clock_.beginS[motion_];
    const double share =
        lasts > 0.0 ? std::clamp((nowS - clock_.beginS[motion_]) / lasts, 0.0, 1.0) : 1.0;
    const auto isAhead = [&](std::size_t sample) {
      return path_.armMotion[sample] < motion_ ||
             (path_.armMotion[sample] == motion_ &&
              static_cast<double>(path_.armFraction[sample]) < share);
    };
    while (sample_ + 1 < path_.armMotion.size() && isAhead(sample_))
      ++sample_;
    if (sample_ == 0 || isAhead(sample_))
      return at(sample_);
    const auto placeOf = [&](std::size_t s) {
      return path_.armMotion[s] < motion_ ? 0.0 : static_cast<double>(path_.armFraction[s]);
    };
    const double from = placeOf(sample_ - 1), to = placeOf(sample_);
    const double t = to > from ? std::clamp((share - from) / (to - from), 0.0, 1.0) : 1.0;
    return at(sample_ - 1) + t * (at(sample_) - at(sample_ - 1));
  }

  const PlacedProgram& machine_;
  const ExecutedPath& path_;
  const MachineClock& clock_;
  std::vector<Solid> solids_;
  DepositedPoints deposited_;
  std::size_t motion_ = 0, sample_ = 0;
  std::vector<Isometry3d> frames_;
  std::vector<Vector3d> centres_; // of the solids' balls
};

constexpr int kPartBody = -1;

// Looks at two of the machines.
class Watch {
public:
  Watch(std::size_t first, std::size_t second, const std::vector<Follower>& followers,
        SharedRun& out)
      : machines_{first, second}, a_(followers[first]), b_(followers[second]), out_(out) {}

  void look(double nowS) {
    now_ = nowS;
    for (std::size_t i = 0; i < a_.solids().size(); ++i)
      for (std::size_t j = 0; j < b_.solids().size(); ++j)
        pair(i, j);
    parts(a_, b_, true);
    parts(b_, a_, false);
    std::swap(before_, touching_);
    touching_.clear();
  }

private:
  void pair(std::size_t i, std::size_t j) {
    const Solid &s = a_.solids()[i], &t = b_.solids()[j];
    if (s.isStill && t.isStill)
      return;
    const double balls = (a_.centreOf(i) - b_.centreOf(j)).norm() - s.ball.radius - t.ball.radius;
    const bool bothMove = !s.isStill && !t.isStill;
    if (balls > (bothMove ? out_.minDistanceMm : 0.0) || !isChecked(s, t))
      return;
    const double mm = distanceBetween(s.shape, a_.poseOf(s), t.shape, b_.poseOf(t));
    if (bothMove && mm < out_.minDistanceMm) {
      out_.minDistanceMm = mm;
      out_.minDistanceAtS = now_;
    }
    if (mm <= 0.0)
      meet(s.body, t.body, 0.5 * (a_.centreOf(i) + b_.centreOf(j)), robot::nameOf(a_.bodyOf(s)),
           robot::nameOf(b_.bodyOf(t)));
  }

  // Of a head and a plate the eroded head counts, else the whole one.
  bool isChecked(const Solid& s, const Solid& t) const {
    const BodyRole one = a_.bodyOf(s).role, other = b_.bodyOf(t).role;
    const bool isAtPlate = (one == BodyRole::Head && other == BodyRole::Platform) ||
                           (one == BodyRole::Platform && other == BodyRole::Head);
    if (s.isEroded != (isAtPlate && one == BodyRole::Head) ||
        t.isEroded != (isAtPlate && other == BodyRole::Head))
      return false;
    return (other != BodyRole::Obstacle || a_.isAgainstObstacles(s)) &&
           (one != BodyRole::Obstacle || b_.isAgainstObstacles(t));
  }

  // Bodies of the one against the material of the other.
  void parts(const Follower& one, const Follower& other, bool isFirst) {
    const Isometry3d work_T_shared = other.shared_T_work().inverse(Eigen::Isometry);
    for (std::size_t i = 0; i < one.solids().size(); ++i) {
      const Solid& s = one.solids()[i];
      const bool isHead = one.bodyOf(s).role == BodyRole::Head;
      if (s.isEroded != isHead || (s.isStill && one.bodyOf(s).role != BodyRole::Head))
        continue;
      const Isometry3d shape_T_work = (work_T_shared * one.poseOf(s)).inverse(Eigen::Isometry);
      // The eroded head may graze a bead's side, but not reach its centreline.
      const double reach = isHead ? 0.0 : other.beadRadiusMm();
      const auto where = other.deposited().find(
          work_T_shared * one.centreOf(i), s.ball.radius + reach, now_,
          [&](const Vector3d& p) { return distanceToPoint(s.shape, shape_T_work * p) <= reach; });
      if (!where)
        continue;
      const base::Value body = robot::nameOf(one.bodyOf(s)), part = "printed part"_text;
      const Vector3d place = other.shared_T_work() * *where;
      if (isFirst)
        meet(s.body, kPartBody, place, body, part);
      else
        meet(kPartBody, s.body, place, part, body);
    }
  }

  void meet(int first, int second, const Vector3d& where, base::Value one, base::Value other) {
    const std::pair pair(first, second);
    if (std::ranges::find(touching_, pair) != touching_.end())
      return;
    touching_.push_back(pair);
    if (std::ranges::find(before_, pair) != before_.end())
      return;
    ++out_.collisions;
    if (out_.meetings.size() < kMaxMeetings)
      out_.meetings.push_back({now_, where, machines_, {std::move(one), std::move(other)}});
  }

  std::array<std::size_t, 2> machines_;
  const Follower &a_, &b_;
  SharedRun& out_;
  double now_ = 0.0;
  std::vector<std::pair<int, int>> before_, touching_; // at the last sample, at this one
};

} // namespace

SharedRun runTogether(std::span<const PlacedProgram> machines, const base::RunContext& ctx) {
  SharedRun out;
  std::vector<ExecutedPath> paths;
  std::vector<const plan::ReadProgram*> programs;
  std::vector<std::vector<double>> times;
  for (const PlacedProgram& machine : machines) {
    programs.push_back(&machine.program);
    paths.push_back(executeProgram(machine.program, machine.cell, ctx));
    times.push_back(controllerTimes(machine.program, paths.back(), RotationLaw::Text));
  }
  out.unsafeStart = unsafeStart(programs, times);
  out.clock = commonClock(programs, times, out.unsafeStart ? out.unsafeStart->start : Start{});
  for (const MachineClock& clock : out.clock.machines)
    out.makespanS = std::max(out.makespanS, clock.totalS);
  std::vector<Follower> followers;
  for (std::size_t k = 0; k < machines.size(); ++k) {
    if (out.clock.machines[k].beginS.empty())
      return out;
    followers.emplace_back(machines[k], paths[k], out.clock.machines[k]);
  }
  std::vector<Watch> watches;
  for (std::size_t j = 1; j < followers.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      watches.emplace_back(i, j, followers, out);
  const auto steps = static_cast<std::size_t>(std::ceil(out.makespanS / kTogetherStepS));
  for (std::size_t k = 0; k <= steps; ++k) {
    const double nowS = std::min(out.makespanS, static_cast<double>(k) * kTogetherStepS);
    if (k % 512 == 0)
      ctx.report(static_cast<double>(k) / static_cast<double>(steps + 1),
                 "running all programs in one time"_text);
    for (Follower& follower : followers)
      follower.moveTo(nowS);
    for (Watch& watch : watches)
      watch.look(nowS);
  }
  return out;
}

} // namespace voluta::replay
