// Cost of a program of a million waypoints: long_programs [WAYPOINTS] [--no-replay] [FORMAT]... A
// spiral in each layer, deposited as a round block; per format the seconds of writing, reading and
// replay, bytes and files, and the greatest memory of the process so far. Run one format at a time
// to see its own memory.
#include "base/memory.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "helpers/lathe_parts.h"
#include "process/bead_model.h"
#include "program/dialect.h"
#include "replay/replay_scene.h"
#include "replay/verification.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace voluta;

constexpr double kRadiusMm = 34.0, kStepMm = 0.4;

// Archimedes' spiral outwards in one layer and inwards in the next, points kStepMm apart.
plan::ToolPlan spirals(std::size_t waypoints, const process::Process& p) {
  plan::ToolPlan plan;
  const double h = p.layerHeightMm, hatch = process::hatchOf(p.beadWidthMm, h);
  for (int layer = 0; plan.position.size() < waypoints; ++layer) {
    plan::ToolPath path;
    path.first = plan.position.size();
    path.layer = layer;
    const double last = kRadiusMm - 0.5 * hatch, perRad = hatch / (2.0 * base::kPi);
    std::vector<Eigen::Vector3d> points;
    for (double angle = base::kPi; perRad * angle < last;
         angle += kStepMm / std::max(perRad * angle, 0.2))
      points.emplace_back(perRad * angle * std::cos(angle), perRad * angle * std::sin(angle),
                          (layer + 1) * h);
    if (layer % 2 == 1)
      std::reverse(points.begin(), points.end());
    for (const Eigen::Vector3d& point : points) {
      plan.position.push_back(point);
      plan.direction.push_back(Eigen::Vector3d::UnitZ());
      plan.widthMm.push_back(static_cast<float>(process::widthOfHatch(hatch, h)));
      plan.heightMm.push_back(static_cast<float>(h));
      plan.speedMmPerS.push_back(static_cast<float>(p.speedMmPerS));
    }
    path.count = plan.position.size() - path.first;
    plan.paths.push_back(path);
  }
  return plan;
}

} // namespace

int main(int argc, char** argv) {
  std::size_t waypoints = 1'000'000;
  bool replays = true;
  std::vector<std::string> formats;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--no-replay")
      replays = false;
    else if (std::isdigit(static_cast<unsigned char>(word.front())) != 0)
      waypoints = std::strtoull(word.c_str(), nullptr, 10);
    else
      formats.push_back(word);
  }
  if (formats.empty())
    for (const program::Dialect& dialect : program::dialects())
      if (!dialect.needsJoints || dialect.controller.empty() || dialect.controller == "urscript")
        formats.emplace_back(dialect.id);

  test::usesSourceTreeResources();
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::squarePlatform(70.0));
  const platform::PlatformSolid plate = test::squarePlatform(70.0);
  base::Stopwatch watch;
  const plan::ToolPlan plan = spirals(waypoints, process);
  const plan::Trajectory trajectory = test::walk(plan, cell, process);
  const double top = (plan.paths.back().layer + 1) * process.layerHeightMm;
  const geometry::TriangleMesh part =
      test::revolved({{0.0, 0.01}, {0.0, kRadiusMm}, {top, kRadiusMm}, {top, 0.01}}, 128);
  geometry::TriangleMesh standing = part; // made about x
  for (Eigen::Vector3d& v : standing.vertices)
    v = Eigen::Vector3d(v.y(), v.z(), v.x());
  std::printf("%zu points, made in %.1f s, %.0f MB\n", trajectory.pointCount(), watch.seconds(),
              base::peakResidentMb());
  std::printf("%-16s %8s %8s %8s %8s %6s %8s %7s %s\n", "format", "points s", "write s", "read s",
              "replay s", "files", "MB text", "peak MB", "covered, passed");
  const base::RunContext ctx(base::CancelToken(), 2);
  for (const std::string& format : formats) {
    const program::ProgramInput input{plan, trajectory, cell, process::Tooling(process), "spiral"};
    watch = base::Stopwatch();
    const program::MergedPoints points = program::pointsFor(format, input, ctx);
    const double merging = watch.seconds();
    const program::ProgramInput said{plan, *points.trajectory, cell, process::Tooling(process),
                                     "spiral"};
    watch = base::Stopwatch();
    const plan::Program program = program::writeProgram(format, said, ctx);
    const double writing = watch.seconds();
    watch = base::Stopwatch();
    const plan::ReadProgram read =
        program::readProgram(format, program.files, process::Tooling(process), ctx);
    const double reading = watch.seconds();
    std::size_t bytes = 0;
    for (const plan::ProgramFile& file : program.files)
      bytes += file.text.size();
    double replaying = 0.0, covered = 0.0;
    bool passed = false;
    if (replays) {
      watch = base::Stopwatch();
      const replay::Verification verdict = replay::replayProgram(
          {read, plan, *points.trajectory, cell, process::Tooling(process), standing, plate}, {},
          ctx);
      replaying = watch.seconds();
      covered = verdict.coveredFraction;
      passed = verdict.passed;
    }
    std::printf("%-16s %8.1f %8.1f %8.1f %8.1f %6zu %8.1f %7.0f %.4f %s\n", format.c_str(), merging,
                writing, reading, replaying, program.files.size(),
                1e-6 * static_cast<double>(bytes), base::peakResidentMb(), covered,
                passed ? "yes" : "no");
    std::fflush(stdout);
  }
  return 0;
}
