// One layer's tool-paths by several ways (Dai 2020, table 4.2): jerk_table [--cell ID] [--layer N]
// [--noise DEG] [--even-directions] [--even-times] [--no-dense] [--slow FACTOR] [--lean DEG]
// [--axes DEG] [--max-jerk J] [--ladder] JOB. The shortest path through a graph of 30 and of 360
// turns about the nozzle at every waypoint (eqs. 4.4-4.6), the first of them through the source's
// local filter (algorithm 6) and smoothed whole, and the motion as it is planned here, collisions
// looked at; and that smoothed whole, with nothing looked at. Greatest five-point jerk of each
// joint, beside that of the graph of 30, and sum of squares (eqs. 4.2, 4.7-4.10) at the waypoints,
// over times that are the same for all: those of the nozzle alone, with corners and ramps, as if
// joints had no limits. Without --layer it takes the one whose number of waypoints is nearest to
// 3,600. --noise turns each direction by a random angle up to DEG to a random side (4.5.4).
// --even-directions and --even-times measure the share of the jerk due to uneven directions and
// times, which no turn removes. --slow: times are so many times as long, for graphs that joints'
// speeds would else leave without a way. --lean: how far directions may lean where whole paths are
// smoothed; --axes: how far external axes may deviate from their schedule then. --max-jerk: last
// row, the motion as planned slowed to this limit (jerk_limit.h), from rest to rest.
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "helpers/five_point_jerk.h"
#include "motion/jerk.h"
#include "motion/jerk_limit.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "motion/nozzle_frame.h"
#include "motion/smoothing/even_turns.h"
#include "motion/smoothing/smooth_turns.h"
#include "motion/timed_points.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "process/tooling.h"
#include "project/job.h"
#include "replay/replay_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace voluta;
using robot::JointVector;

struct Measure {
  JointVector greatest;
  double sum = 0.0, seconds = 0.0;
  std::size_t points = 0;
};

// A path's joints, one a waypoint; empty where there is no way.
using Joints = std::vector<JointVector>;

std::vector<double> tipTimes(const plan::ToolPlan& plan, const plan::ToolPath& path,
                             const process::Process& process, bool even, double slow) {
  std::vector<motion::TimedPoint> points;
  for (std::size_t i = path.first; i < path.first + path.count; ++i)
    points.push_back(
        {JointVector::Zero(6), plan.position[i], plan.speedMmPerS[i], false, false, {}});
  motion::TimingLimits limits;
  limits.joints.assign(6, {-1e9, 1e9, 1e9, 1e9});
  limits.accelerationMmPerS2 = process.accelerationMmPerS2;
  std::vector<double> times = motion::timesOf(points, limits);
  if (even)
    for (std::size_t i = 0; i < times.size(); ++i)
      times[i] = times.back() * static_cast<double>(i) / static_cast<double>(times.size() - 1);
  for (double& t : times)
    t *= slow;
  return times;
}

void measure(const Joints& q, const std::vector<double>& times, Measure& m) {
  if (m.greatest.size() == 0 && !q.empty())
    m.greatest = JointVector::Zero(q.front().size());
  for (std::size_t i = 2; i + 2 < q.size(); ++i) {
    const auto weights = test::fivePointJerk(times, i);
    JointVector jerk = JointVector::Zero(q[i].size());
    for (std::size_t k = 0; k < 5; ++k)
      jerk += weights[k] * q[i + k - 2];
    m.greatest = m.greatest.cwiseMax(jerk.cwiseAbs());
    m.sum += jerk.squaredNorm();
    ++m.points;
  }
}

struct Node {
  JointVector q;
  int sample;
};

// Dijkstra over ladders of `samples` turns, all branches: eqs. 4.4-4.6. `reach`: neighbours differ
// by at most so many turns, which is further than a joint's speed allows.
Joints shortestPath(const robot::Cell& cell, const plan::ToolPlan& plan, const plan::ToolPath& path,
                    const std::vector<double>& times, int samples, double reachRad) {
  const int reach =
      std::min((samples - 1) / 2, static_cast<int>(reachRad * samples / base::kTwoPi));
  std::vector<std::vector<Node>> rungs(path.count);
  std::vector<std::vector<double>> cost(path.count);
  std::vector<std::vector<int>> parent(path.count);
  std::vector<std::vector<JointVector>> wound(path.count);
  Eigen::Quaterniond tool = motion::uprightTool();
  std::vector<JointVector> solutions;
  std::vector<std::vector<int>> bySample(static_cast<std::size_t>(samples));
  for (std::size_t i = 0; i < path.count; ++i) {
    const std::size_t w = path.first + i;
    tool = motion::carried(tool, plan.direction[w]);
    for (int k = 0; k < samples; ++k) {
      cell.inverse(
          motion::toolPose(plan.position[w], motion::turned(tool, base::kTwoPi * k / samples)),
          cell.home(), solutions);
      for (const JointVector& q : solutions)
        rungs[i].push_back({q, k});
    }
    const std::size_t n = rungs[i].size();
    cost[i].assign(n, i == 0 ? 0.0 : std::numeric_limits<double>::infinity());
    parent[i].assign(n, -1);
    wound[i].resize(n);
    const double dt = i > 0 ? times[i] - times[i - 1] : 0.0;
    bool any = i == 0;
    for (std::size_t b = 0; b < n; ++b) {
      const JointVector& to = rungs[i][b].q;
      if (i == 0) {
        wound[i][b] = to;
        continue;
      }
      for (int k = -reach; k <= reach; ++k)
        for (const int a : bySample[static_cast<std::size_t>(
                 ((rungs[i][b].sample + k) % samples + samples) % samples)]) {
          const JointVector& from = wound[i - 1][static_cast<std::size_t>(a)];
          double sum = cost[i - 1][static_cast<std::size_t>(a)];
          for (Eigen::Index j = 0; j < cell.armDof() && sum < cost[i][b]; ++j) {
            double d = to[j] - from[j];
            d -= base::kTwoPi * std::round(d / base::kTwoPi);
            if (std::abs(d) > dt * cell.limits()[static_cast<std::size_t>(j)].velocity)
              sum = std::numeric_limits<double>::infinity();
            sum += d * d;
          }
          if (sum < cost[i][b]) {
            cost[i][b] = sum;
            parent[i][b] = a;
          }
        }
      if (parent[i][b] >= 0) {
        any = true;
        const JointVector& from = wound[i - 1][static_cast<std::size_t>(parent[i][b])];
        wound[i][b] = to;
        for (Eigen::Index j = 0; j < cell.armDof(); ++j)
          wound[i][b][j] -= base::kTwoPi * std::round((to[j] - from[j]) / base::kTwoPi);
      }
    }
    if (!any)
      return {};
    for (auto& nodes : bySample)
      nodes.clear();
    for (std::size_t b = 0; b < n; ++b)
      if (cost[i][b] < std::numeric_limits<double>::infinity())
        bySample[static_cast<std::size_t>(rungs[i][b].sample)].push_back(static_cast<int>(b));
  }
  Joints q(path.count);
  auto best = static_cast<int>(std::min_element(cost.back().begin(), cost.back().end()) -
                               cost.back().begin());
  for (std::size_t i = path.count; i-- > 0;) {
    q[i] = wound[i][static_cast<std::size_t>(best)];
    best = parent[i][static_cast<std::size_t>(best)];
  }
  return q;
}

std::vector<motion::RunPoint> runOf(const robot::Cell& cell, const Joints& q) {
  std::vector<motion::RunPoint> points(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Eigen::Isometry3d pose = cell.work_T_tool(q[i]);
    points[i].at = {pose.translation(), Eigen::Quaterniond(pose.linear()), q[i], {}};
  }
  return points;
}

// Algorithm 6 with d = 5, at most 20, 100 rounds a path; each window by the whole-path smoother
// with all other points held, in place of quadratic programmes.
Joints localFilter(const robot::Cell& cell, const robot::ArmTwists& twists, const Joints& q,
                   const std::vector<double>& times, const base::RunContext& ctx) {
  constexpr std::size_t kFirst = 5, kMax = 20;
  constexpr int kRounds = 100;
  constexpr double kAllowed = 1.0; // rad/s3
  const std::vector<motion::RunPoint> points = runOf(cell, q);
  const motion::RotationSmoother smoother(cell, twists, points, times);
  std::vector<motion::TurnedPoint> at = smoother.start(ctx);
  std::vector<char> locked(q.size(), 0);
  for (int round = 0; round < kRounds; ++round) {
    double maximum = kAllowed;
    std::size_t centre = q.size();
    for (std::size_t i = 2; i + 2 < q.size(); ++i) {
      const auto weights = test::fivePointJerk(times, i);
      JointVector jerk = JointVector::Zero(q[i].size());
      for (std::size_t k = 0; k < 5; ++k)
        jerk += weights[k] * at[i + k - 2].q;
      if (!locked[i] && jerk.norm() > maximum) {
        maximum = jerk.norm();
        centre = i;
      }
    }
    if (centre == q.size())
      break;
    bool success = false;
    for (std::size_t d = kFirst; d <= kMax && !success; d += 5) {
      const std::size_t b = centre < d ? 0 : centre - d, e = std::min(q.size(), centre + d + 1);
      std::vector<motion::RotationHold> held(q.size(), {motion::kHeld, 0.0});
      std::fill(held.begin() + static_cast<std::ptrdiff_t>(b),
                held.begin() + static_cast<std::ptrdiff_t>(e), motion::RotationHold{});
      const double before = smoother.cost(at, held);
      smoother.smooth(at, held, {}, ctx);
      success = smoother.cost(at, held) < before * (1.0 - 1e-6);
      for (std::size_t i = b; i < e; ++i)
        locked[i] = !success && d + 5 > kMax;
    }
  }
  Joints filtered;
  for (const motion::TurnedPoint& p : at)
    filtered.push_back(p.q);
  return filtered;
}

// The whole path at once, over given times, nothing looked at for collisions.
Joints wholePath(const robot::Cell& cell, const robot::ArmTwists& twists, const Joints& q,
                 const std::vector<double>& times, double leanRad, const base::RunContext& ctx) {
  const std::vector<motion::RunPoint> points = runOf(cell, q);
  const motion::RotationSmoother smoother(cell, twists, points, times, leanRad);
  std::vector<motion::TurnedPoint> at = smoother.start(ctx);
  motion::RotationSmoothing much;
  much.rounds = 60;
  much.enough = 1e-5;
  smoother.smooth(at, std::vector<motion::RotationHold>(q.size()), much, ctx);
  Joints smooth;
  for (const motion::TurnedPoint& p : at)
    smooth.push_back(p.q);
  return smooth;
}

// Removes waves shorter than about 24 waypoints from the directions.
void evenDirections(plan::ToolPlan& plan, const plan::ToolPath& path) {
  constexpr double kSmoothing = 200.0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    std::vector<double> part;
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      part.push_back(plan.direction[i][k]);
    part = motion::evened(part, kSmoothing);
    for (std::size_t i = 0; i < path.count; ++i)
      plan.direction[path.first + i][k] = part[i];
  }
  for (std::size_t i = path.first; i < path.first + path.count; ++i)
    plan.direction[i].normalize();
}

plan::ToolPlan layerOf(const plan::ToolPlan& plan, int wanted, double noise, bool evened) {
  std::map<int, std::size_t> counts;
  for (const plan::ToolPath& p : plan.paths)
    counts[p.layer] += p.count;
  if (wanted < 0) {
    constexpr double kWaypoints = 3600.0;
    double best = 1e18;
    for (const auto& [layer, count] : counts)
      if (const double off = std::abs(static_cast<double>(count) - kWaypoints); off < best) {
        best = off;
        wanted = layer;
      }
  }
  plan::ToolPlan layer;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (plan::ToolPath p : plan.paths) {
    if (p.layer != wanted)
      continue;
    const std::size_t first = layer.waypointCount();
    for (std::size_t i = p.first; i < p.first + p.count; ++i) {
      Eigen::Vector3d d = plan.direction[i];
      if (noise > 0.0) {
        const double side = base::kTwoPi * unit(random), angle = noise * unit(random);
        const Eigen::Vector3d x = d.unitOrthogonal();
        d = std::cos(angle) * d +
            std::sin(angle) * (std::cos(side) * x + std::sin(side) * d.cross(x));
      }
      layer.position.push_back(plan.position[i]);
      layer.direction.push_back(d.normalized());
      layer.widthMm.push_back(plan.widthMm[i]);
      layer.heightMm.push_back(plan.heightMm[i]);
      layer.speedMmPerS.push_back(plan.speedMmPerS[i]);
    }
    p.first = first;
    layer.paths.push_back(p);
  }
  for (const plan::ToolPath& p : layer.paths)
    if (evened)
      ::evenDirections(layer, p);
  std::printf("layer %d: %zu paths, %zu waypoints\n", wanted, layer.paths.size(),
              layer.waypointCount());
  return layer;
}

void row(const char* name, const Measure& m, const Measure& p30) {
  std::printf("%-22s %9.2f s  sum %11.4g  greatest", name, m.seconds, m.sum);
  for (Eigen::Index j = 0; j < m.greatest.size(); ++j)
    std::printf(" %8.2f (%+4.0f %%)", m.greatest[j], 100.0 * (m.greatest[j] / p30.greatest[j] - 1));
  std::printf("  at %zu points\n", m.points);
}

} // namespace

int main(int argc, char** argv) {
  std::string cellId, file;
  int wanted = -1;
  double noise = 0.0, slow = 1.0, leanRad = 0.0, axesRad = 0.0, maxJerk = 0.0;
  bool ladder = false, dense = true, evenTimes = false, evenDirections = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--cell" && i + 1 < argc)
      cellId = argv[++i];
    else if (word == "--layer" && i + 1 < argc)
      wanted = std::stoi(argv[++i]);
    else if (word == "--noise" && i + 1 < argc)
      noise = base::degreesToRadians(std::stod(argv[++i]));
    else if (word == "--slow" && i + 1 < argc)
      slow = std::stod(argv[++i]);
    else if (word == "--lean" && i + 1 < argc)
      leanRad = base::degreesToRadians(std::stod(argv[++i]));
    else if (word == "--axes" && i + 1 < argc)
      axesRad = base::degreesToRadians(std::stod(argv[++i]));
    else if (word == "--max-jerk" && i + 1 < argc)
      maxJerk = std::stod(argv[++i]);
    else if (word == "--ladder")
      ladder = true;
    else if (word == "--no-dense")
      dense = false;
    else if (word == "--even-times")
      evenTimes = true;
    else if (word == "--even-directions")
      evenDirections = true;
    else
      file = word;
  }
  test::usesSourceTreeResources();
  const project::Job job = project::readJob(file, pipeline::allParameters());
  const process::Process process = process::loadProcess(job.choices.tool().process);
  const robot::Cell cell =
      robot::loadCell(cellId.empty() ? job.choices.cell : cellId, process, job.item().platform);
  const plan::ToolPlan plan = layerOf(*job.toolPlan, wanted, noise, evenDirections);
  const base::RunContext ctx(base::CancelToken(), 2);
  const robot::ArmTwists twists(*cell.robot().kinematics);
  const collision::GrowingPart part(plan, collision::growingPitch(plan, process::Tooling(process)),
                                    ctx);
  motion::MotionOptions options;
  options.smoothing = ladder ? motion::SmoothingMethod::None : motion::SmoothingMethod::WholePath;
  options.leanRad = leanRad;
  options.axesRad = axesRad;

  base::Stopwatch watch;
  motion::MotionPlanner planner(plan, cell, process::Tooling(process), part, options);
  const motion::MotionResult result = planner.plan(ctx);
  Measure ours, limited, graph30, graph360, filtered, whole, whole2;
  ours.seconds = watch.seconds();
  std::vector<JointVector> at(plan.waypointCount());
  for (std::size_t i = 0; i < result.trajectory.pointCount(); ++i)
    if (const std::size_t w = result.trajectory.waypoint[i]; w != plan::kNoWaypoint)
      at[w] = Eigen::Map<const JointVector>(result.trajectory.at(i), cell.dof());
  std::printf(
      "%s: printed %zu, collisions %zu, unreachable %zu; times ik %.2f graph %.2f jerk %.2f "
      "collision %.2f transfer %.2f; own measure %.4g -> %.4g\n",
      cell.id().c_str(), result.statistics.waypoints, result.statistics.collisions,
      result.statistics.unreachable, result.times.ik, result.times.graph, result.times.jerk,
      result.times.collision, result.times.transfer, result.statistics.sumSquaredJerkBefore,
      result.statistics.sumSquaredJerk);
  double before = 0.0, after = 0.0;
  for (const plan::ToolPath& path : plan.paths) {
    const std::vector<double> times = tipTimes(plan, path, process, evenTimes, slow);
    Joints q(at.begin() + static_cast<std::ptrdiff_t>(path.first),
             at.begin() + static_cast<std::ptrdiff_t>(path.first + path.count));
    const auto missing = [](const JointVector& v) { return v.size() == 0; };
    if (std::any_of(q.begin(), q.end(), missing))
      continue;
    watch = base::Stopwatch();
    const Joints sparse = shortestPath(cell, plan, path, times, 30, base::kPi);
    graph30.seconds += watch.seconds();
    if (sparse.empty()) {
      std::printf("no way through 30 turns over a path of %zu waypoints\n", path.count);
      continue;
    }
    watch = base::Stopwatch();
    const Joints local = localFilter(cell, twists, sparse, times, ctx);
    filtered.seconds += watch.seconds();
    watch = base::Stopwatch();
    const Joints optimal = wholePath(cell, twists, sparse, times, leanRad, ctx);
    whole.seconds += watch.seconds();
    measure(optimal, times, whole);
    measure(wholePath(cell, twists, q, times, leanRad, ctx), times, whole2);
    watch = base::Stopwatch();
    const Joints fine = dense ? shortestPath(cell, plan, path, times, 360, 0.35) : sparse;
    graph360.seconds += watch.seconds();
    measure(q, times, ours);
    before += times.back();
    if (maxJerk > 0.0) {
      watch = base::Stopwatch();
      const std::vector<double> slower = motion::timesWithinJerk(q, times, cell.limits(), maxJerk);
      limited.seconds += watch.seconds();
      measure(q, slower, limited);
      after += slower.back();
    }
    measure(sparse, times, graph30);
    measure(local, times, filtered);
    measure(fine, times, graph360);
  }
  row("30 turns", graph30, graph30);
  row("and local filter", filtered, graph30);
  row("whole path", whole, graph30);
  row("planned, whole path", whole2, graph30);
  row("360 turns", graph360, graph30);
  row("planned", ours, graph30);
  if (maxJerk > 0.0) {
    row("planned, limited", limited, graph30);
    std::printf("%.1f s within the limit instead of %.1f s\n", after, before);
  }
  std::printf("sum: %.3f of 30 turns', %.3f of 360 turns'\n", ours.sum / graph30.sum,
              ours.sum / graph360.sum);
  return 0;
}
