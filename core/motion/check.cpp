#include "motion/check.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "collision/way_clearance.h"
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

// Returns `leastMm`, or the clearance along one motion if that is smaller. In a straight move of
// the nozzle the joints move nearly linearly only from step to step.
double clearanceOnWay(const MotionScene& scene, const collision::WayClearance& ways,
                      plan::MoveKind move, const JointVector& from, const JointVector& to,
                      std::size_t before, double leastMm) {
  constexpr double kDetour = 1.05;
  if (!isStraight(move))
    return ways.along(from, to, before, leastMm);
  const int pieces = std::max(1, static_cast<int>(std::ceil(scene.span(from, to) / kStraightStep)));
  Between between(scene.cell, from, to, true);
  JointVector last = from;
  for (int k = 1; k <= pieces; ++k) {
    const JointVector next = k == pieces ? to : between.at(static_cast<double>(k) / pieces);
    leastMm = ways.along(last, next, before, leastMm, kDetour);
    last = next;
  }
  return leastMm;
}

} // namespace

TrajectoryCheck checkTrajectory(const plan::Trajectory& trajectory, const MotionScene& scene,
                                const std::vector<std::size_t>& headBefore, double capMm,
                                const base::RunContext& ctx) {
  const std::size_t n = trajectory.pointCount();
  // The waypoint of each point, or the waypoint it leads to; after the last one the whole part is
  // present.
  std::vector<std::size_t> next(n, 0);
  for (std::size_t last : trajectory.waypoint)
    if (last != plan::kNoWaypoint)
      next.back() = std::max(next.back(), last + 1);
  for (std::size_t i = n; i-- > 0;)
    if (trajectory.waypoint[i] != plan::kNoWaypoint)
      next[i] = trajectory.waypoint[i];
    else if (i + 1 < n)
      next[i] = next[i + 1];

  const auto jointsAt = [&](std::size_t i) {
    return JointVector(Eigen::Map<const Eigen::VectorXd>(trajectory.at(i), trajectory.dof));
  };
  const collision::Margins& margins = scene.options.printing;
  const auto toolOf = [&](const collision::CellCollision::Frames& frames) -> Eigen::Isometry3d {
    const auto frame = [&](int f) { return frames[static_cast<std::size_t>(f)]; };
    return frame(scene.cell.workFrame()).inverse() * frame(scene.cell.toolFrame());
  };
  const auto headInPart = [&](const collision::CellCollision::Frames& frames, std::size_t i,
                              bool atWork) -> std::optional<collision::Contact> {
    const std::size_t before = atWork ? headBefore[next[i]] : next[i];
    if (scene.collision.headTouchesPart(toolOf(frames), scene.part, before, margins.headMm,
                                        next[i]))
      for (const int b : scene.cell.bodiesAgainstPart())
        if (scene.cell.bodies()[static_cast<std::size_t>(b)].role == robot::BodyRole::Head)
          return collision::Contact{b, collision::kPrintedPart};
    return std::nullopt;
  };
  const auto bodiesOf = [&](const collision::CellCollision::Frames& frames,
                            std::size_t i) -> std::optional<collision::Contact> {
    if (const auto contact = scene.collision.bodies(frames, margins))
      return contact;
    return scene.collision.bodiesAndPart(frames, scene.part, next[i], margins);
  };

  std::vector<std::vector<TrajectoryCollision>> found((n + kChunk - 1) / kChunk);
  std::vector<double> least(found.size(), capMm);
  std::vector<std::size_t> closest(found.size(), 0);
  base::parallelChunks(ctx, n, kChunk, [&](std::size_t b, std::size_t e) {
    collision::CellCollision::Frames frames;
    double& clearance = least[b / kChunk];
    std::size_t nearest = 0;
    for (std::size_t i = b; i < e; ++i) {
      if (ctx.cancelled())
        return;
      const bool printing = trajectory.move[i] == plan::MoveKind::Print;
      const JointVector q = jointsAt(i);
      scene.cell.framePoses(q, frames);
      // The head was checked at the waypoints already. It is round, so the arm's pose does not
      // matter, unless directions may tilt.
      std::optional<collision::Contact> contact;
      const bool divides = trajectory.waypoint[i] == plan::kNoWaypoint;
      if (divides || scene.options.leans() > 0.0)
        contact = headInPart(frames, i, printing || !divides);
      const double bodies = scene.collision.clearance(frames, clearance, &nearest);
      const double all = scene.collision.clearanceToPart(frames, scene.part, next[i], bodies);
      const bool roomy = bodies > margins.bodiesMm && all > margins.partMm &&
                         !scene.collision.headTouchesPlatform(toolOf(frames), margins.headMm);
      if (!contact && !roomy)
        contact = bodiesOf(frames, i);
      if (!contact) {
        if (all < clearance)
          closest[b / kChunk] = i;
        clearance = all;
        if (i > 0) {
          const JointVector last = jointsAt(i - 1);
          const double step =
              trajectory.move[i] == plan::MoveKind::Joint ? kJointStep : kStraightStep;
          const int pieces = static_cast<int>(std::ceil(scene.span(last, q) / step));
          Between between(scene.cell, last, q, isStraight(trajectory.move[i]));
          for (int k = 1; k < pieces && !contact; ++k) {
            scene.cell.framePoses(between.at(static_cast<double>(k) / pieces), frames);
            // The head also counts as printing where printing stops or starts, until it has
            // departed.
            const bool atWork = printing || trajectory.waypoint[i] != plan::kNoWaypoint ||
                                trajectory.move[i - 1] == plan::MoveKind::Print;
            contact = headInPart(frames, i, atWork && next[i] < headBefore.size());
            if (!contact)
              contact = bodiesOf(frames, i);
          }
        }
      }
      if (contact)
        found[b / kChunk].push_back({i, *contact});
    }
  });
  ctx.checkpoint();
  TrajectoryCheck check;
  check.minClearanceMm = capMm;
  const auto takeLeast = [&] {
    for (std::size_t c = 0; c < found.size(); ++c)
      if (least[c] < check.minClearanceMm) {
        check.minClearanceMm = least[c];
        check.closestPoint = closest[c];
      }
  };
  for (const std::vector<TrajectoryCollision>& some : found)
    check.collisions.insert(check.collisions.end(), some.begin(), some.end());
  takeLeast();

  // Clearance between the points.
  const collision::WayClearance ways(scene.collision, scene.part);
  base::parallelChunks(ctx, n, kChunk, [&](std::size_t b, std::size_t e) {
    double& clearance = least[b / kChunk];
    clearance = check.minClearanceMm;
    auto met = found[b / kChunk].begin();
    for (std::size_t i = std::max<std::size_t>(b, 1); i < e; ++i) {
      if (ctx.cancelled())
        return;
      while (met != found[b / kChunk].end() && met->point < i)
        ++met;
      if (met != found[b / kChunk].end() && met->point == i)
        continue;
      const double all = clearanceOnWay(scene, ways, trajectory.move[i], jointsAt(i - 1),
                                        jointsAt(i), next[i], clearance);
      if (all < clearance)
        closest[b / kChunk] = i;
      clearance = all;
    }
  });
  ctx.checkpoint();
  takeLeast();
  return check;
}

} // namespace voluta::motion
