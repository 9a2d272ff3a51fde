// The rungs of a path's ladder: where they are, what their nodes are, which of them are of use.
#include "motion/path_planner.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "motion/joint_costs.h"
#include "motion/nozzle_frame.h"
#include "motion/rod_turn.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voluta::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr double kTurn = 2.0 * base::kPi;
constexpr double kLiftStepMm = 2.0, kLiftFactor = 10.0; // of liftMm, from both ends of a run
constexpr std::size_t kRungChunk = 2, kJudgeChunk = 1;
// On a rod the nozzle hardly moves in the base, however long the way: rungs come at least so often.
constexpr std::size_t kRodRungWaypoints = 64;
constexpr double kRodCost = 0.3;       // of a node a step of the rod's from the upright angle
constexpr std::size_t kWidenReach = 3; // rungs to both sides

Quaterniond rodTurn(double angle) {
  return Quaterniond(std::cos(0.5 * angle), std::sin(0.5 * angle), 0.0, 0.0);
}

} // namespace

std::size_t PathPlanner::carryTools(std::size_t first, std::size_t count, const RobotState& from) {
  tools_.resize(count);
  toolsFirst_ = first;
  Quaterniond tool = from.tool;
  if (scene_.cell.externalAxes().empty()) {
    for (std::size_t i = 0; i < count; ++i) {
      tool = carried(tool, scene_.plan.direction[first + i]);
      tools_[i] = tool;
    }
    return count;
  }
  // As it stands in the base: round a cone it comes back to itself there, in the work frame not.
  rod_ = uprightAngles(scene_.plan, scene_.cell, first, count, from.rodRad);
  tool = rodTurn(from.rodRad) * tool;
  for (std::size_t i = 0; i < rod_.size(); ++i) {
    tool = carried(tool, turnedByRod(scene_.plan.direction[first + i], rod_[i]));
    tools_[i] = rodTurn(-rod_[i]) * tool;
  }
  return rod_.size();
}

Vector3d PathPlanner::inBase(const Vector3d& v, std::size_t waypoint) const {
  return rod_.empty() ? v : turnedByRod(v, rodAt(waypoint));
}

std::vector<std::size_t> PathPlanner::rungWaypoints(std::size_t first, std::size_t count) const {
  const plan::ToolPlan& plan = scene_.plan;
  std::vector<std::size_t> rungs{first};
  double way = 0.0, turn = 0.0;
  for (std::size_t i = first + 1; i < first + count; ++i) {
    const double step = (inBase(plan.position[i], i) - inBase(plan.position[i - 1], i - 1)).norm();
    const double angle = std::acos(std::clamp(
        inBase(plan.direction[i], i).dot(inBase(plan.direction[i - 1], i - 1)), -1.0, 1.0));
    way += step;
    turn += angle;
    const bool tooFar = way > scene_.options.rungMm || turn > scene_.options.rungTurnRad ||
                        (!rod_.empty() && i - rungs.back() > kRodRungWaypoints);
    if (tooFar && i - 1 > rungs.back()) {
      rungs.push_back(i - 1);
      way = step;
      turn = angle;
    }
  }
  if (rungs.back() != first + count - 1)
    rungs.push_back(first + count - 1);
  return rungs;
}

void PathPlanner::addNodes(Ladder& ladder, const std::vector<std::size_t>& rungs,
                           const RobotState& from, const base::RunContext& ctx) {
  const base::Stopwatch watch;
  base::parallelChunks(ctx, rungs.size(), kRungChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t r = b; r < e; ++r)
      addNodes(ladder.places[rungs[r]], ladder.rungs[rungs[r]], {0}, from);
  });
  times_.ik += watch.seconds();
}

void PathPlanner::addNodes(const Place& place, Rung& rung, const std::vector<int>& rodSteps,
                           const RobotState& from) const {
  const int samples = scene_.options.samples;
  std::vector<JointVector> solutions;
  for (const int rod : rodSteps) {
    const JointVector near = withRod(scene_.cell, from.q, rodAt(place.waypoint) + kRodStep * rod);
    for (int k = 0; k < samples; ++k) {
      const Quaterniond tool =
          turned(tools_[place.waypoint - toolsFirst_], kTurn * k / static_cast<double>(samples));
      scene_.cell.inverse(toolPose(scene_.plan.position[place.waypoint], tool), near, solutions);
      for (const JointVector& q : solutions)
        rung.push_back({q, k, rod,
                        limitCost(q, scene_.cell.robot().limits) + kRodCost * std::abs(rod),
                        false});
    }
  }
}

bool PathPlanner::widen(Ladder& ladder, std::size_t rung, const RobotState& from,
                        const base::RunContext& ctx) {
  std::vector<std::size_t> todo;
  if (!rod_.empty())
    for (std::size_t r = rung < kWidenReach ? 0 : rung - kWidenReach;
         r < std::min(rung + kWidenReach + 1, ladder.places.size()); ++r)
      if (!ladder.places[r].widened)
        todo.push_back(r);
  const base::Stopwatch watch;
  base::parallelChunks(ctx, todo.size(), kJudgeChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t t = b; t < e; ++t) {
      Place& place = ladder.places[todo[t]];
      Rung& nodes = ladder.rungs[todo[t]];
      const std::size_t before = nodes.size();
      addNodes(place, nodes, {-2, -1, 1, 2}, from);
      for (std::size_t n = before; n < nodes.size(); ++n)
        if (const auto contact = contactAt(nodes[n].q, place.waypoint)) {
          nodes[n].blocked = true;
          place.contacts.push_back(*contact);
        }
      place.widened = true;
      place.lifted = false;
    }
  });
  times_.collision += watch.seconds();
  return !todo.empty();
}

std::optional<collision::Contact> PathPlanner::contactAt(const JointVector& q,
                                                         std::size_t waypoint) const {
  collision::CellCollision::Frames frames;
  scene_.cell.framePoses(q, frames);
  if (const auto contact = scene_.collision.bodies(frames, scene_.options.printing))
    return contact;
  return scene_.collision.bodiesAndPart(frames, scene_.part, waypoint, scene_.options.printing);
}

void PathPlanner::judge(Ladder& ladder, const std::vector<std::size_t>& rungs,
                        const base::RunContext& ctx) {
  const base::Stopwatch watch;
  std::vector<std::size_t> todo;
  for (const std::size_t r : rungs)
    if (!ladder.places[r].judged) {
      ladder.places[r].judged = true;
      todo.push_back(r);
    }
  base::parallelChunks(ctx, todo.size(), kJudgeChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t t = b; t < e; ++t) {
      Place& place = ladder.places[todo[t]];
      for (LadderNode& node : ladder.rungs[todo[t]])
        if (const auto contact = contactAt(node.q, place.waypoint)) {
          node.blocked = true;
          place.contacts.push_back(*contact);
        }
    }
  });
  times_.collision += watch.seconds();
}

Refused PathPlanner::refusal(const Place& place, const Rung& rung) {
  Refused r{place.waypoint, rung.empty() ? Refusal::Unreachable : Refusal::NoConnection, {}};
  std::map<std::pair<int, int>, int> counts;
  for (const collision::Contact& c : place.contacts)
    ++counts[{c.first, c.second}];
  int most = 0;
  for (const auto& [pair, times] : counts)
    if (times > most) {
      most = times;
      r.contact = {pair.first, pair.second};
      r.why = Refusal::Collision;
    }
  return r;
}

std::size_t PathPlanner::refuseBlocked(Ladder& ladder, const RobotState& from,
                                       const base::RunContext& ctx, std::vector<Refused>& refused) {
  const std::size_t first = ladder.places.front().waypoint;
  std::size_t next = first;
  for (std::size_t r = 0; r < ladder.places.size(); ++r) {
    ctx.checkpoint();
    widen(ladder, r, from, ctx);
    judge(ladder, {r}, ctx);
    const Rung& rung = ladder.rungs[r];
    if (r > 0 &&
        std::any_of(rung.begin(), rung.end(), [](const LadderNode& n) { return !n.blocked; }))
      break;
    Refused why = refusal(ladder.places[r], rung);
    for (; next <= ladder.places[r].waypoint; ++next) {
      why.waypoint = next;
      refused.push_back(why);
    }
  }
  return next - first;
}

bool PathPlanner::liftable(const RobotState& state, std::size_t before) const {
  std::vector<JointVector> scratch;
  JointVector q = state.q;
  for (double height = kLiftStepMm; height <= kLiftFactor * scene_.options.liftMm;
       height += kLiftStepMm) {
    const JointVector last = q;
    if (!solveNear(scene_.cell, state.tip + height * state.direction(), state.tool, last,
                   scene_.options.maxStepRad, scratch, q) ||
        contactAt(q, before))
      return false;
  }
  return true;
}

void PathPlanner::blockUnliftable(Ladder& ladder, std::size_t rung, std::size_t before,
                                  const base::RunContext& ctx) {
  const base::Stopwatch watch;
  Place& place = ladder.places[rung];
  Rung& nodes = ladder.rungs[rung];
  place.lifted = true;
  std::vector<char> bad(nodes.size(), 0);
  base::parallelChunks(ctx, nodes.size(), 4, [&](std::size_t b, std::size_t e) {
    for (std::size_t n = b; n < e; ++n) {
      if (nodes[n].blocked)
        continue;
      const RobotState state{
          scene_.plan.position[place.waypoint],
          turned(tools_[place.waypoint - toolsFirst_],
                 kTurn * nodes[n].sample / static_cast<double>(scene_.options.samples)),
          nodes[n].q};
      bad[n] = contactAt(nodes[n].q, before).has_value() || !liftable(state, before);
    }
  });
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (bad[n]) {
      nodes[n].blocked = true;
      place.unliftable.push_back(n);
    }
  times_.collision += watch.seconds();
}

} // namespace voluta::motion
