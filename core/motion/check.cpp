#include "motion/check.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "collision/way_clearance.h"
#include "motion/motion_options.h"
#include "motion/motion_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace voluta::motion {

using robot::JointVector;

namespace {

constexpr std::size_t kChunk = 256;
constexpr double kStraightStep = 0.02;                     // [rad], for straight moves
constexpr double kJointStep = base::degreesToRadians(0.5); // [rad], for joint moves
constexpr double kNearRad = 0.3; // Maximum step of a joint within a straight move

// The states between the ends of one motion. In a straight motion the nozzle moves straight, which
// near a singular wrist is far from joint interpolation. Above a rod the arm hardly moves.
class Between {
public:
  Between(const robot::Cell& cell, const JointVector& from, const JointVector& to, bool straight)
      : cell_(cell), from_(from), to_(to), last_(from), straight_(straight && !cell.rod()) {
    if (straight_) {
      start_ = cell.work_T_tool(from);
      end_ = cell.work_T_tool(to);
    }
  }

  // Call with increasing t, from 0 to 1.
  const JointVector& at(double t) {
    JointVector q = from_ + t * (to_ - from_);
    if (straight_) {
      const Eigen::Vector3d tip =
          start_.translation() + t * (end_.translation() - start_.translation());
      const Eigen::Quaterniond tool =
          Eigen::Quaterniond(start_.linear()).slerp(t, Eigen::Quaterniond(end_.linear()));
      JointVector solved;
      const Eigen::Index axes = q.size() - cell_.armDof();
      last_.tail(axes) = q.tail(axes);
      if (solveNear(cell_, tip, tool, last_, kNearRad, scratch_, solved))
        q = solved;
    }
    last_ = q;
    return last_;
  }

private:
  const robot::Cell& cell_;
  JointVector from_, to_, last_;
  bool straight_;
  Eigen::Isometry3d start_, end_;
  std::vector<JointVector> scratch_;
};

bool isStraight(plan::MoveKind move) {
  return move == plan::MoveKind::Linear || move == plan::MoveKind::Wipe;
}

// Returns `minMm`, or the clearance along one motion if that is smaller. In a straight move of
// the nozzle the joints move nearly linearly only from step to step.
double clearanceOnMotion(const MotionScene& scene, const collision::MotionClearance& ways,
                         plan::MoveKind move, const JointVector& from, const JointVector& to,
                         std::size_t before, double minMm) {
  constexpr double kDetour = 1.05;
  if (!isStraight(move))
    return ways.along(from, to, before, minMm);
  const int pieces = std::max(1, static_cast<int>(std::ceil(scene.span(from, to) / kStraightStep)));
  Between between(scene.cell, from, to, true);
  JointVector last = from;
  for (int k = 1; k <= pieces; ++k) {
    const JointVector next = k == pieces ? to : between.at(static_cast<double>(k) / pieces);
    minMm = ways.along(last, next, before, minMm, kDetour);
    last = next;
  }
  return minMm;
}

// The waypoint of each point, or the waypoint it leads to; after the last one the whole part is
// present.
std::vector<std::size_t> nextWaypoints(const plan::Trajectory& trajectory) {
  const std::size_t n = trajectory.pointCount();
  std::vector<std::size_t> next(n, 0);
  for (std::size_t last : trajectory.waypoint)
    if (last != plan::kNoWaypoint)
      next.back() = std::max(next.back(), last + 1);
  for (std::size_t i = n; i-- > 0;)
    if (trajectory.waypoint[i] != plan::kNoWaypoint)
      next[i] = trajectory.waypoint[i];
    else if (i + 1 < n)
      next[i] = next[i + 1];
  return next;
}

class Checker {
public:
  Checker(const plan::Trajectory& trajectory, const MotionScene& scene,
          const std::vector<std::size_t>& headBefore, double capMm, const base::RunContext& ctx)
      : trajectory_(trajectory), scene_(scene), headBefore_(headBefore), ctx_(ctx),
        margins_(scene.options.printing), next_(nextWaypoints(trajectory)),
        chunks_((trajectory.pointCount() + kChunk - 1) / kChunk) {
    for (Chunk& chunk : chunks_)
      chunk.minMm = capMm;
    check_.minClearanceMm = capMm;
  }

  TrajectoryCheck run() {
    inChunks([this](Chunk& chunk, std::size_t b, std::size_t e) { points(chunk, b, e); });
    for (const Chunk& chunk : chunks_)
      check_.collisions.insert(check_.collisions.end(), chunk.found.begin(), chunk.found.end());
    takeMinimum();
    inChunks([this](Chunk& chunk, std::size_t b, std::size_t e) { ways(chunk, b, e); });
    takeMinimum();
    return std::move(check_);
  }

private:
  using Frames = collision::CellCollision::Frames;

  struct Chunk {
    std::vector<TrajectoryCollision> found;
    double minMm = 0.0;      // clearance
    std::size_t closest = 0; // point that has it
  };

  template <typename Visit> void inChunks(const Visit& visit) {
    base::parallelChunks(ctx_, trajectory_.pointCount(), kChunk,
                         [&](std::size_t b, std::size_t e) { visit(chunks_[b / kChunk], b, e); });
    ctx_.checkpoint();
  }
  void takeMinimum() {
    for (const Chunk& chunk : chunks_)
      if (chunk.minMm < check_.minClearanceMm) {
        check_.minClearanceMm = chunk.minMm;
        check_.closestPoint = chunk.closest;
      }
  }

  JointVector jointsAt(std::size_t i) const {
    return Eigen::Map<const Eigen::VectorXd>(trajectory_.at(i), trajectory_.dof);
  }
  bool isAtWaypoint(std::size_t i) const { return trajectory_.waypoint[i] != plan::kNoWaypoint; }
  bool isPrinting(std::size_t i) const { return trajectory_.move[i] == plan::MoveKind::Print; }
  Eigen::Isometry3d toolOf(const Frames& frames) const {
    const auto frame = [&](int f) { return frames[static_cast<std::size_t>(f)]; };
    return frame(scene_.cell.workFrame()).inverse() * frame(scene_.cell.toolFrame());
  }

  std::optional<collision::Contact> headInPart(const Frames& frames, std::size_t i,
                                               bool atWork) const {
    const std::size_t before = atWork ? headBefore_[next_[i]] : next_[i];
    if (scene_.collision.headTouchesPart(toolOf(frames), scene_.part, before, margins_.headMm,
                                         next_[i]))
      for (const int b : scene_.cell.bodiesAgainstPart())
        if (scene_.cell.bodies()[static_cast<std::size_t>(b)].role == robot::BodyRole::Head)
          return collision::Contact{b, collision::kPrintedPart};
    return std::nullopt;
  }
  std::optional<collision::Contact> bodiesOf(const Frames& frames, std::size_t i) const {
    if (const auto contact = scene_.collision.bodies(frames, margins_))
      return contact;
    return scene_.collision.bodiesAndPart(frames, scene_.part, next_[i], margins_);
  }

  // Points [b, e) and the states between each and the point before it.
  void points(Chunk& chunk, std::size_t b, std::size_t e) const {
    Frames frames;
    std::size_t nearest = 0;
    for (std::size_t i = b; i < e && !ctx_.cancelled(); ++i) {
      scene_.cell.framePoses(jointsAt(i), frames);
      // The head was checked at the waypoints already. It is round, so the arm's pose does not
      // matter, unless directions may tilt.
      std::optional<collision::Contact> contact;
      if (!isAtWaypoint(i) || scene_.options.leans() > 0.0)
        contact = headInPart(frames, i, isPrinting(i) || isAtWaypoint(i));
      const double bodies = scene_.collision.clearance(frames, chunk.minMm, &nearest);
      const double all = scene_.collision.clearanceToPart(frames, scene_.part, next_[i], bodies);
      const bool roomy = bodies > margins_.bodiesMm && all > margins_.partMm &&
                         !scene_.collision.headTouchesPlatform(toolOf(frames), margins_.headMm);
      if (!contact && !roomy)
        contact = bodiesOf(frames, i);
      if (!contact) {
        if (all < chunk.minMm)
          chunk.closest = i;
        chunk.minMm = all;
        contact = contactBefore(i, frames);
      }
      if (contact)
        chunk.found.push_back({i, *contact});
    }
  }

  // The first contact on the way from the point before i; `frames` is memory for the call.
  std::optional<collision::Contact> contactBefore(std::size_t i, Frames& frames) const {
    if (i == 0)
      return std::nullopt;
    const bool straight = isStraight(trajectory_.move[i]);
    const auto contact = contactBetween(i, straight, frames);
    // Beads are straight too. Between their points the joints hardly differ from linear, except
    // where the nozzle rotates far over a short way, as over a ridge: there the tip would sag.
    return contact && isPrinting(i) ? contactBetween(i, true, frames) : contact;
  }

  std::optional<collision::Contact> contactBetween(std::size_t i, bool straight,
                                                   Frames& frames) const {
    const JointVector last = jointsAt(i - 1), q = jointsAt(i);
    const double step = trajectory_.move[i] == plan::MoveKind::Joint ? kJointStep : kStraightStep;
    const int pieces = static_cast<int>(std::ceil(scene_.span(last, q) / step));
    // The head also counts as printing where printing stops or starts, until it has departed.
    const bool atWork = isPrinting(i) || isAtWaypoint(i) || isPrinting(i - 1);
    Between between(scene_.cell, last, q, straight);
    for (int k = 1; k < pieces; ++k) {
      scene_.cell.framePoses(between.at(static_cast<double>(k) / pieces), frames);
      std::optional<collision::Contact> contact =
          headInPart(frames, i, atWork && next_[i] < headBefore_.size());
      if (!contact)
        contact = bodiesOf(frames, i);
      if (contact)
        return contact;
    }
    return std::nullopt;
  }

  // The clearance on the ways to points [b, e), but for those on which a collision was found.
  void ways(Chunk& chunk, std::size_t b, std::size_t e) const {
    chunk.minMm = check_.minClearanceMm;
    auto met = chunk.found.begin();
    for (std::size_t i = std::max<std::size_t>(b, 1); i < e && !ctx_.cancelled(); ++i) {
      while (met != chunk.found.end() && met->point < i)
        ++met;
      if (met != chunk.found.end() && met->point == i)
        continue;
      const double all = clearanceOnMotion(scene_, ways_, trajectory_.move[i], jointsAt(i - 1),
                                           jointsAt(i), next_[i], chunk.minMm);
      if (all < chunk.minMm)
        chunk.closest = i;
      chunk.minMm = all;
    }
  }

  const plan::Trajectory& trajectory_;
  const MotionScene& scene_;
  const std::vector<std::size_t>& headBefore_;
  const base::RunContext& ctx_;
  const collision::Margins& margins_;
  const collision::MotionClearance ways_{scene_.collision, scene_.part};
  const std::vector<std::size_t> next_;
  std::vector<Chunk> chunks_;
  TrajectoryCheck check_;
};

} // namespace

TrajectoryCheck checkTrajectory(const plan::Trajectory& trajectory, const MotionScene& scene,
                                const std::vector<std::size_t>& headBefore, double capMm,
                                const base::RunContext& ctx) {
  return Checker(trajectory, scene, headBefore, capMm, ctx).run();
}

} // namespace voluta::motion
