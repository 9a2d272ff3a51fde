#include "motion/ladder/path_ladder.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "motion/axis_schedule.h"
#include "motion/external_axes.h"
#include "motion/ladder/joint_costs.h"
#include "motion/nozzle_frame.h"
#include "motion/tool_frames.h"
#include "robot/nozzle_turns.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>

namespace voluta::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr double kOffsetStep = 15.0 * base::kPi / 180.0; // Of the last external axis
// kLiftFactor: multiple of liftMm, from both ends of a run
constexpr double kLiftStepMm = 2.0, kLiftFactor = 10.0;
constexpr std::size_t kRungChunk = 2, kJudgeChunk = 1;
// On a rod the nozzle hardly moves in the base, however long the path: limit the waypoints between
// rungs.
constexpr std::size_t kAxisRungWaypoints = 64;
constexpr double kOffsetCost = 0.3;    // Cost of a node per step of the last external axis
constexpr std::size_t kWidenReach = 3; // Rungs on both sides

} // namespace

PathLadder::PathLadder(const MotionScene& scene, std::size_t first, std::size_t count,
                       const RobotState& from, const base::RunContext& ctx, PathTimes& times)
    : scene_(scene), times_(times), first_(first), from_(from) {
  options_.samples = scene.options.samples;
  options_.window = std::max(1, scene.options.samples / 12);
  followed_ = carryTools(count, ctx);
}

std::size_t PathLadder::carryTools(std::size_t count, const base::RunContext& ctx) {
  const robot::Cell& cell = scene_.cell;
  if (cell.rod()) {
    for (const double angle : uprightAngles(scene_.plan, cell, first_, count, from_.axes[0]))
      axes_.push_back(JointVector::Constant(1, angle));
  } else if (!cell.externalAxes().empty()) {
    const base::Stopwatch watch;
    axes_ = axisSchedule(scene_, first_, count, from_, ctx);
    times_.graph += watch.seconds();
  }
  tools_ = toolFrames(scene_.options.rotation, scene_.plan, cell, first_, count, axes_, from_.tool,
                      from_.axes);
  return tools_.size();
}

JointVector PathLadder::axesAt(std::size_t waypoint, double offset) const {
  if (axes_.empty())
    return {};
  JointVector axes = axes_[waypoint - first_];
  axes[axes.size() - 1] += offset;
  return axes;
}

Vector3d PathLadder::pointAt(std::size_t waypoint) const {
  const Vector3d& p = scene_.plan.position[waypoint];
  return axes_.empty() ? p : movedByAxes(scene_.cell, p, axes_[waypoint - first_]);
}

Vector3d PathLadder::directionAt(std::size_t waypoint) const {
  const Vector3d& d = scene_.plan.direction[waypoint];
  return axes_.empty() ? d : turnedByAxes(scene_.cell, d, axes_[waypoint - first_]);
}

bool PathLadder::canOffset() const {
  return !axes_.empty() &&
         scene_.cell.externalAxes().back().limits.kind == robot::JointKind::Turning;
}

std::vector<std::size_t> PathLadder::rungWaypoints(std::size_t count) const {
  std::vector<std::size_t> rungs{first_};
  double distance = 0.0, rotation = 0.0;
  for (std::size_t i = first_ + 1; i < first_ + count; ++i) {
    const double step = (pointAt(i) - pointAt(i - 1)).norm();
    const double angle = std::acos(std::clamp(directionAt(i).dot(directionAt(i - 1)), -1.0, 1.0));
    distance += step;
    rotation += angle;
    const bool tooFar = distance > scene_.options.rungMm ||
                        rotation > scene_.options.rungRotationRad ||
                        (!axes_.empty() && i - rungs.back() > kAxisRungWaypoints);
    if (tooFar && i - 1 > rungs.back()) {
      rungs.push_back(i - 1);
      distance = step;
      rotation = angle;
    }
  }
  if (rungs.back() != first_ + count - 1)
    rungs.push_back(first_ + count - 1);
  return rungs;
}

void PathLadder::setRungs(std::size_t count, const base::RunContext& ctx) {
  setPlaces(rungWaypoints(count), ctx);
}

void PathLadder::keepUpTo(std::size_t rung, const base::RunContext& ctx) {
  std::vector<std::size_t> waypoints;
  for (std::size_t r = 0; r <= rung; ++r)
    waypoints.push_back(places_[r].waypoint);
  setPlaces(waypoints, ctx);
}

void PathLadder::setPlaces(const std::vector<std::size_t>& waypoints, const base::RunContext& ctx) {
  std::vector<Place> places;
  std::vector<Rung> rungs;
  std::vector<std::size_t> fresh;
  std::size_t old = 0;
  for (const std::size_t w : waypoints) {
    while (old < places_.size() && places_[old].waypoint < w)
      ++old;
    if (old < places_.size() && places_[old].waypoint == w) {
      places.push_back(std::move(places_[old]));
      rungs.push_back(std::move(rungs_[old]));
      ++old;
    } else {
      fresh.push_back(places.size());
      places.push_back({w});
      rungs.emplace_back();
    }
  }
  places_ = std::move(places);
  rungs_ = std::move(rungs);
  options_.maxStepRad.assign(places_.size(), kRungStepRad);
  for (std::size_t r = 1; r < places_.size(); ++r)
    options_.maxStepRad[r] = std::min(
        kRungStepRad, scene_.options.maxStepRad *
                          static_cast<double>(places_[r].waypoint - places_[r - 1].waypoint));
  const base::Stopwatch watch;
  base::parallelChunks(ctx, fresh.size(), kRungChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t r = b; r < e; ++r)
      addNodes(places_[fresh[r]], rungs_[fresh[r]], {0});
  });
  times_.ik += watch.seconds();
}

bool PathLadder::refine(std::size_t rung, const base::RunContext& ctx) {
  const std::size_t b = places_[rung - 1].waypoint, e = places_[rung].waypoint;
  if (e - b <= 1)
    return false;
  std::vector<std::size_t> waypoints;
  std::vector<std::size_t> fresh;
  for (const Place& p : places_) {
    if (p.waypoint == e)
      for (std::size_t i = b + 1; i < e; ++i) {
        fresh.push_back(waypoints.size());
        waypoints.push_back(i);
      }
    waypoints.push_back(p.waypoint);
  }
  setPlaces(waypoints, ctx);
  judge(fresh, ctx);
  return true;
}

void PathLadder::addNodes(const Place& place, Rung& rung, const std::vector<int>& offsets) const {
  const int samples = scene_.options.samples;
  // Orientation as planned
  const int turnsTried = scene_.options.rotation == NozzleRotation::Free ? samples : 1;
  std::vector<JointVector> solutions;
  for (const int offset : offsets) {
    const JointVector near =
        withAxes(scene_.cell, from_.q, axesAt(place.waypoint, kOffsetStep * offset));
    const double last = near[near.size() - 1];
    if (offset != 0 &&
        (last < scene_.cell.limits().back().min || last > scene_.cell.limits().back().max))
      continue;
    const robot::NozzleTurns turns(
        scene_.cell, toolPose(scene_.plan.position[place.waypoint], toolAt(place.waypoint)), near);
    for (int k = 0; k < turnsTried; ++k) {
      turns.at(base::kTwoPi * k / static_cast<double>(samples), solutions);
      for (const JointVector& q : solutions)
        rung.push_back({q, k, offset,
                        limitCost(q, scene_.cell.robot().limits) + kOffsetCost * std::abs(offset),
                        false});
    }
  }
}

bool PathLadder::widen(std::size_t rung, const base::RunContext& ctx) {
  std::vector<std::size_t> todo;
  if (canOffset())
    for (std::size_t r = rung < kWidenReach ? 0 : rung - kWidenReach;
         r < std::min(rung + kWidenReach + 1, places_.size()); ++r)
      if (!places_[r].widened)
        todo.push_back(r);
  const base::Stopwatch watch;
  base::parallelChunks(ctx, todo.size(), kJudgeChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t t = b; t < e; ++t) {
      Place& place = places_[todo[t]];
      Rung& nodes = rungs_[todo[t]];
      const std::size_t before = nodes.size();
      addNodes(place, nodes, {-2, -1, 1, 2});
      for (std::size_t n = before; n < nodes.size(); ++n)
        look(nodes[n], place);
      if (place.sided)
        computeJacobianSigns(todo[t]);
      place.widened = true;
      place.lifted = false;
    }
  });
  times_.collision += watch.seconds();
  return !todo.empty();
}

std::optional<collision::Contact> PathLadder::contactAt(const JointVector& q,
                                                        std::size_t waypoint) const {
  collision::CellCollision::Frames frames;
  scene_.cell.framePoses(q, frames);
  if (const auto contact = scene_.collision.bodies(frames, scene_.options.printing))
    return contact;
  return scene_.collision.bodiesAndPart(frames, scene_.part, waypoint, scene_.options.printing);
}

double PathLadder::clearanceAt(const JointVector& q, std::size_t waypoint,
                               std::size_t& nearest) const {
  collision::CellCollision::Frames frames;
  scene_.cell.framePoses(q, frames);
  return scene_.collision.clearanceToPart(
      frames, scene_.part, waypoint,
      scene_.collision.clearance(frames, scene_.options.enoughMm, &nearest));
}

bool PathLadder::seekClearance(const LadderPath& path, const base::RunContext& ctx) {
  if (scene_.options.nearCost <= 0.0)
    return false;
  const base::Stopwatch watch;
  std::vector<char> isNear(places_.size(), 0);
  base::parallelChunks(ctx, places_.size(), kJudgeChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t r = b; r < e; ++r) {
      Place& place = places_[r];
      if (place.cleared || place.clearNode == path.node[r])
        continue;
      const LadderNode& here = rungs_[r][static_cast<std::size_t>(path.node[r])];
      std::size_t nearest = 0;
      if (clearanceAt(here.q, place.waypoint, nearest) >= scene_.options.enoughMm) {
        place.clearNode = path.node[r];
        continue;
      }
      isNear[r] = 1;
      place.cleared = true;
      for (LadderNode& node : rungs_[r]) {
        if (node.blocked)
          continue;
        const double lacks =
            1.0 - clearanceAt(node.q, place.waypoint, nearest) / scene_.options.enoughMm;
        node.cost += scene_.options.nearCost * lacks * lacks;
      }
    }
  });
  times_.collision += watch.seconds();
  return std::find(isNear.begin(), isNear.end(), 1) != isNear.end();
}

void PathLadder::look(LadderNode& node, Place& place) const {
  if (const auto contact = contactAt(node.q, place.waypoint)) {
    node.blocked = true;
    place.contacts.push_back(*contact);
  }
}

void PathLadder::computeJacobianSigns(std::size_t rung) {
  places_[rung].sided = true;
  for (LadderNode& node : rungs_[rung])
    node.side = scene_.sideOf(node.q);
}

void PathLadder::keepJacobianSigns(std::size_t rung) {
  computeJacobianSigns(rung);
  if (rung > 0)
    computeJacobianSigns(rung - 1);
}

void PathLadder::judge(const std::vector<std::size_t>& rungs, const base::RunContext& ctx) {
  const base::Stopwatch watch;
  std::vector<std::size_t> todo;
  for (const std::size_t r : rungs)
    if (!places_[r].judged) {
      places_[r].judged = true;
      todo.push_back(r);
    }
  base::parallelChunks(ctx, todo.size(), kJudgeChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t t = b; t < e; ++t) {
      Place& place = places_[todo[t]];
      for (LadderNode& node : rungs_[todo[t]])
        look(node, place);
    }
  });
  times_.collision += watch.seconds();
}

Refused PathLadder::refusalOf(std::size_t rung) const {
  const Place& place = places_[rung];
  Refused r{
      place.waypoint, rungs_[rung].empty() ? Refusal::Unreachable : Refusal::NoConnection, {}};
  std::map<std::pair<int, int>, int> counts;
  for (const collision::Contact& c : place.contacts)
    ++counts[{c.first, c.second}];
  int maximum = 0;
  for (const auto& [pair, times] : counts)
    if (times > maximum) {
      maximum = times;
      r.contact = {pair.first, pair.second};
      r.why = Refusal::Collision;
    }
  return r;
}

std::size_t PathLadder::refuseBlocked(const base::RunContext& ctx, std::vector<Refused>& refused) {
  const std::size_t first = places_.front().waypoint;
  std::size_t next = first;
  for (std::size_t r = 0; r < places_.size(); ++r) {
    ctx.checkpoint();
    widen(r, ctx);
    judge({r}, ctx);
    const Rung& rung = rungs_[r];
    if (r > 0 &&
        std::any_of(rung.begin(), rung.end(), [](const LadderNode& n) { return !n.blocked; }))
      break;
    Refused why = refusalOf(r);
    for (; next <= places_[r].waypoint; ++next) {
      why.waypoint = next;
      refused.push_back(why);
    }
  }
  return next - first;
}

std::size_t PathLadder::rungAt(std::size_t waypoint) const {
  const auto at = std::lower_bound(places_.begin(), places_.end(), waypoint,
                                   [](const Place& p, std::size_t w) { return p.waypoint < w; });
  return static_cast<std::size_t>(at - places_.begin());
}

std::vector<LadderStart> PathLadder::startsNear(const JointVector& near,
                                                std::vector<LadderStart> starts) const {
  for (LadderStart& start : starts) {
    for (Eigen::Index j = 0; j < scene_.cell.armDof(); ++j) {
      const auto& limit = scene_.cell.limits()[static_cast<std::size_t>(j)];
      if (limit.kind == robot::JointKind::Sliding)
        continue;
      const double q =
          start.q[j] + base::kTwoPi * std::round((near[j] - start.q[j]) / base::kTwoPi);
      if (q >= limit.min && q <= limit.max)
        start.q[j] = q;
    }
    start.cost = startCost(from_.q, start.q, scene_.cell.robot().limits);
  }
  return starts;
}

LadderPath PathLadder::bestPath(const base::RunContext& ctx) const {
  std::vector<LadderStart> asFound;
  for (const LadderNode& node : rungs_.front())
    asFound.push_back({node.q});
  const std::vector<LadderStart> near = startsNear(from_.q, std::move(asFound));
  const std::vector<LadderStart> unwound = startsNear(scene_.cell.home(), near);
  const auto search = [&](const std::vector<LadderStart>& starts) {
    return shortestPath(rungs_, starts, scene_.cell.robot().limits, options_);
  };
  const auto same = [&](std::size_t n) { return near[n].q == unwound[n].q; };
  bool changed = false;
  for (std::size_t n = 0; n < near.size(); ++n)
    changed = changed || !same(n);
  if (!changed)
    return search(near);

  LadderPath nearPath, unwoundPath;
  std::atomic<bool> unwinds = true; // False: the unwound search is not needed
  const auto nothingToUnwind = [&] {
    return nearPath.reached == rungs_.size() &&
           same(static_cast<std::size_t>(nearPath.node.front()));
  };
  base::parallelChunks(ctx, 2, 1, [&](std::size_t which, std::size_t) {
    if (which == 0) {
      nearPath = search(near);
      unwinds = !nothingToUnwind();
    } else if (unwinds) {
      unwoundPath = search(unwound);
    }
  });
  const bool further = unwoundPath.reached > nearPath.reached;
  const bool cheaper = unwoundPath.reached == nearPath.reached && unwoundPath.cost < nearPath.cost;
  return !nothingToUnwind() && (further || cheaper) ? unwoundPath : nearPath;
}

Course PathLadder::courseOf(const LadderPath& path) const {
  const plan::ToolPlan& plan = scene_.plan;
  const int samples = scene_.options.samples;
  Course course;
  double rotation = 0.0, offset = 0.0;
  int last = 0;
  for (std::size_t r = 0; r < path.reached; ++r) {
    const LadderNode& node = rungs_[r][static_cast<std::size_t>(path.node[r])];
    const int sample = node.sample;
    int change = r == 0 ? sample : (sample - last + samples) % samples;
    if (change > samples / 2)
      change -= samples;
    const double next = rotation + base::kTwoPi * change / samples,
                 nextOffset = kOffsetStep * node.offset;
    if (r == 0) {
      course.rotation.push_back(next);
      course.offset.push_back(nextOffset);
    } else {
      const std::size_t b = places_[r - 1].waypoint, e = places_[r].waypoint;
      double length = 0.0;
      for (std::size_t i = b + 1; i <= e; ++i)
        length += (plan.position[i] - plan.position[i - 1]).norm();
      double travelled = 0.0;
      for (std::size_t i = b + 1; i <= e; ++i) {
        travelled += (plan.position[i] - plan.position[i - 1]).norm();
        const double t = length > 0.0 ? travelled / length
                                      : static_cast<double>(i - b) / static_cast<double>(e - b);
        course.rotation.push_back(rotation + t * (next - rotation));
        course.offset.push_back(offset + t * (nextOffset - offset));
      }
    }
    rotation = next;
    offset = nextOffset;
    last = sample;
  }
  return course;
}

bool PathLadder::liftable(const RobotState& state, std::size_t before) const {
  std::vector<JointVector> scratch;
  RobotState at = state;
  for (double height = kLiftStepMm; height <= kLiftFactor * scene_.options.liftMm;
       height += kLiftStepMm) {
    const RobotState last = at;
    at.tip = state.tip + height * state.direction();
    if (!solveNear(scene_.cell, at.tip, at.tool, last.q, scene_.options.maxStepRad, scratch,
                   at.q) ||
        !scene_.movesStraight(last, at) || contactAt(at.q, before))
      return false;
  }
  return true;
}

void PathLadder::blockUnliftable(std::size_t rung, std::size_t before,
                                 const base::RunContext& ctx) {
  const base::Stopwatch watch;
  Place& place = places_[rung];
  Rung& nodes = rungs_[rung];
  place.lifted = true;
  std::vector<char> bad(nodes.size(), 0);
  base::parallelChunks(ctx, nodes.size(), 4, [&](std::size_t b, std::size_t e) {
    for (std::size_t n = b; n < e; ++n) {
      if (nodes[n].blocked)
        continue;
      const RobotState state{
          scene_.plan.position[place.waypoint],
          turned(toolAt(place.waypoint),
                 base::kTwoPi * nodes[n].sample / static_cast<double>(scene_.options.samples)),
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

bool PathLadder::allowUnliftable() {
  bool allowed = false;
  for (std::size_t r = 0; r < places_.size(); ++r) {
    for (const std::size_t n : places_[r].unliftable)
      rungs_[r][n].blocked = false;
    allowed = allowed || !places_[r].unliftable.empty();
    places_[r].unliftable.clear();
  }
  return allowed;
}

} // namespace voluta::motion
