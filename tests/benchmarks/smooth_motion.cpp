// Effect of smoothing on the motion of planned jobs: smooth_motion [--ladder] [--evened] [--lean
// DEG] [--axes DEG] [--near-cost C] [--max-jerk J] [--learned] [--threads N] [--paths N] JOB... The
// motion of each job's tool-paths, planned anew: seconds (wall and of the processor), jerk before
// and after, and how clear of everything the arm stays while it prints. With --lean directions may
// lean so far (else 3 degrees); with --ladder the turns about the nozzle stay as the ladder graph
// gives them, with --evened they are evened out; --axes: how far external axes may deviate from
// their schedule; --near-cost: cost of poses near an obstacle (0: clearance is kept, not sought);
// with --paths only the first N are taken.
#include "base/memory.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "process/tooling.h"
#include "project/job.h"
#include "replay/replay_scene.h"

#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace voluta;

constexpr double kCapMm = 50.0, kNearMm = 5.0;

struct Clearance {
  double meanMm = 0.0, nearShare = 0.0, minMm = kCapMm; // of printing time
};

Clearance clearanceOf(const plan::Trajectory& t, const robot::Cell& cell,
                      const process::Process& process, const collision::GrowingPart& part,
                      const base::RunContext& ctx) {
  const collision::CellCollision collision(cell, process);
  const std::size_t n = t.pointCount();
  std::vector<double> clear(n, kCapMm);
  base::parallelChunks(ctx, n, 256, [&](std::size_t b, std::size_t e) {
    std::vector<Eigen::Isometry3d> frames;
    for (std::size_t i = b; i < e; ++i) {
      if (t.move[i] != plan::MoveKind::Print || t.waypoint[i] == plan::kNoWaypoint)
        continue;
      cell.framePoses(Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof), frames);
      clear[i] = collision.clearanceToPart(frames, part, t.waypoint[i],
                                           collision.clearance(frames, kCapMm));
    }
  });
  Clearance c;
  double total = 0.0;
  for (std::size_t i = 1; i < n; ++i) {
    if (t.move[i] != plan::MoveKind::Print || t.waypoint[i] == plan::kNoWaypoint)
      continue;
    const double dt = t.timeS[i] - t.timeS[i - 1];
    total += dt;
    c.meanMm += clear[i] * dt;
    c.nearShare += clear[i] < kNearMm ? dt : 0.0;
    c.minMm = std::min(c.minMm, clear[i]);
  }
  if (total > 0.0) {
    c.meanMm /= total;
    c.nearShare /= total;
  }
  return c;
}

plan::ToolPlan firstPaths(plan::ToolPlan plan, std::size_t paths) {
  if (paths == 0 || paths >= plan.paths.size())
    return plan;
  plan.paths.resize(paths);
  const std::size_t n = plan.paths.back().first + plan.paths.back().count;
  plan.position.resize(n);
  plan.direction.resize(n);
  plan.widthMm.resize(n);
  plan.heightMm.resize(n);
  plan.speedMmPerS.resize(n);
  return plan;
}

} // namespace

int main(int argc, char** argv) {
  motion::MotionOptions options;
  options.smoothing = motion::SmoothingMethod::WholePath;
  int threads = 2;
  std::size_t paths = 0;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--ladder")
      options.smoothing = motion::SmoothingMethod::None;
    else if (word == "--lean" && i + 1 < argc)
      options.leanRad = base::degreesToRadians(std::stod(argv[++i]));
    else if (word == "--evened")
      options.smoothing = motion::SmoothingMethod::Evened;
    else if (word == "--axes" && i + 1 < argc)
      options.axesRad = base::degreesToRadians(std::stod(argv[++i]));
    else if (word == "--near-cost" && i + 1 < argc)
      options.nearCost = std::stod(argv[++i]);
    else if (word == "--max-jerk" && i + 1 < argc)
      options.maxJerk = std::stod(argv[++i]);
    else if (word == "--learned")
      options.learnedCollisions = true;
    else if (word == "--threads" && i + 1 < argc)
      threads = std::stoi(argv[++i]);
    else if (word == "--paths" && i + 1 < argc)
      paths = std::stoul(argv[++i]);
    else
      files.push_back(word);
  }
  test::usesSourceTreeResources();
  for (const std::string& file : files) {
    const project::Job job = project::readJob(file, pipeline::allParameters());
    const process::Process process = process::loadProcess(job.choices.tool().process);
    const robot::Cell cell = robot::loadCell(job.choices.cell, process, job.item().platform);
    const base::RunContext ctx(base::CancelToken(), threads);
    const plan::ToolPlan toolPlan = firstPaths(*job.toolPlan, paths);
    const double pitch = collision::growingPitch(toolPlan, process::Tooling(process));
    platform::PlatformSolid ground = job.item().platform;
    ground.rod.reset();
    const collision::GrowingPart part(toolPlan, pitch, ctx,
                                      collision::groundCells(ground, toolPlan, pitch, ctx));
    motion::MotionPlanner planner(toolPlan, cell, process::Tooling(process), part, options);
    const base::Stopwatch watch;
    const std::clock_t cpu = std::clock();
    const motion::MotionResult result = planner.plan(ctx);
    const double cpuS = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
    const double wallS = watch.seconds();
    const auto& s = result.statistics;
    const auto& t = result.times;
    const Clearance c = clearanceOf(result.trajectory, cell, process, part, ctx);
    std::printf("%s\n  %zu waypoints, %zu points, printed %zu, collisions %zu, unreachable %zu, "
                "splits %zu\n",
                file.c_str(), toolPlan.waypointCount(), result.trajectory.pointCount(), s.waypoints,
                s.collisions, s.unreachable, s.splits);
    std::printf("  wall %.1f s, processor %.1f s (%.2f s a 100,000 waypoints): ik %.1f graph %.1f "
                "jerk %.1f collision %.1f transfer %.1f\n",
                wallS, cpuS, 1e5 * cpuS / static_cast<double>(toolPlan.waypointCount()), t.ik,
                t.graph, t.jerk, t.collision, t.transfer);
    std::printf("  jerk %.4g -> %.4g (%.1f %%), greatest", s.sumSquaredJerkBefore, s.sumSquaredJerk,
                100.0 * s.sumSquaredJerk / s.sumSquaredJerkBefore);
    for (const double j : s.maxJerk)
      std::printf(" %.0f", j);
    std::printf("\n  before");
    for (const double j : s.maxJerkBefore)
      std::printf(" %.0f", j);
    std::printf(", of transfers");
    for (const double j : s.maxTravelJerk)
      std::printf(" %.0f", j);
    std::printf("; slowed by %.0f s, %zu findings", s.jerkSlowedS, result.findings.size());
    double printingS = 0.0;
    for (std::size_t i = 1; i < result.trajectory.pointCount(); ++i)
      if (result.trajectory.move[i] == plan::MoveKind::Print)
        printingS += result.trajectory.timeS[i] - result.trajectory.timeS[i - 1];
    std::printf("\n  transfers %zu: arcs %zu, joint %zu, tree %zu; %.0f s printing", s.transfers,
                s.arcTransfers, s.jointTransfers, s.treeTransfers, printingS);
    std::printf("\n  duration %.0f s, clearance mean %.2f mm, under %.0f mm %.2f %% of the time, "
                "least %.2f mm\n",
                s.durationS, c.meanMm, kNearMm, 100.0 * c.nearShare, c.minMm);
  }
  return 0;
}
