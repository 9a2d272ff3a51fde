// hang_report [--keep DIR] [--mode M] [--platform P] [--set KEY=VALUE]... [--over MM] [--list N]
// [--threads N] PART... Lists unsupported beads of real parts: planned up to the tool-paths,
// deposited as in a replay, and listed by path, height and distance to the next material below.
// --keep: plans up to the decomposition are kept in DIR and read from there. PART may be a project
// (.voluta): then the beads of its motion are checked. --over: stretches longer than that are
// listed, else those longer than the process bridges.
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "collision/growing_part.h"
#include "geometry/mesh_query.h"
#include "helpers/laid_beads.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/waypoints.h"
#include "replay/bead_coverage.h"
#include "replay/beads.h"
#include "replay/beneath.h"
#include "replay/printed_part.h"
#include "replay/replay_ground.h"
#include "toolpath/unsupported/bridges.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

using namespace voluta;
using Eigen::Vector3d;

namespace {

constexpr double kDownMm = 60.0; // how far down is looked
constexpr std::array<const char*, 6> kKinds = {"wall",  "infill",  "gap",
                                               "skirt", "support", "prime"};

// The share of a piece with material right below; and the distances from its middle to the first
// material, to the left and to the right.
struct Found {
  double carried = 0.0, leftMm = 0.0, rightMm = 0.0;
  double downMm = 0.0; // to the first material below, along its direction
};
Found found(const replay::Beneath& beneath) {
  Found out;
  out.carried = beneath.carriedShare();
  if (out.carried >= 0.5)
    return out;
  const auto reach = [&](double sign) {
    double lateral = 0.0;
    while (lateral < 6.0 && !beneath.carriedAt(sign * lateral))
      lateral += 0.05;
    return lateral;
  };
  out.leftMm = reach(1.0);
  out.rightMm = reach(-1.0);
  while (out.downMm < kDownMm &&
         !beneath.holds(beneath.tip() - (beneath.heightMm() + out.downMm) * beneath.up()))
    out.downMm += 0.1;
  return out;
}

struct Run {
  std::size_t first = 0, end = 0;
  double lengthMm = 0.0;
};

// The waypoints of a plan that a motion lays.
plan::ToolPlan depositedOf(const plan::ToolPlan& plan, const plan::Trajectory& trajectory) {
  std::vector<char> leftOut(plan.waypointCount(), 1);
  for (const std::size_t i : trajectory.waypoint)
    if (i != plan::kNoWaypoint)
      leftOut[i] = 0;
  return plan::without(plan, leftOut).plan;
}

void report(const project::Job& job, const plan::ToolPlan& plan, const process::Process& process,
            std::optional<double> over, int listed, const base::RunContext& ctx) {
  const double overMm = over.value_or(process.bridgeMm);
  const std::vector<replay::BeadPiece> pieces = test::depositedBeads(plan);
  const geometry::TriangleMesh& part = job.item().printed();
  Vector3d low = part.vertices.front(), high = low;
  for (const auto* points : {&part.vertices, &plan.position})
    for (const Vector3d& p : *points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const Vector3d margin = Vector3d::Constant(process.beadWidthMaxMm);
  const voxel::VoxelGrid grid =
      replay::gridOver(low - margin, high + margin, 0.25 * process.beadWidthMm, 48'000'000);
  const replay::BeadGrid beads =
      replay::depositBeads(grid, pieces, {.widthMaxMm = 3.0 * process.beadWidthMaxMm}, ctx);
  const replay::PrintedPart printed(beads, pieces);
  const replay::GroundProbe ground(job.item().platform);
  const replay::SupportedBeads support = replay::findSupport(pieces, printed, ground, ctx);
  const geometry::MeshQuery query(part);
  const replay::PartCells cells = replay::partCells(part, query, grid, ctx);
  const replay::Coverage coverage = replay::measureCoverage(
      beads, cells, query,
      {.outsideMm = 0.25 * process.beadWidthMm, .notchMm = 0.5 * process.layerHeightMm}, ctx);
  double excess = 0.0;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    excess += pieces[p].ofPart ? static_cast<double>(beads.pieceExcessMm3[p]) : 0.0;
  std::printf("  unsupported %.4f halfCarried %.4f longest %.1f covered %.4f overfill %.4f "
              "layers %d thickness %.3f +- %.3f p01 %.2f p99 %.2f\n",
              support.unsupportedMm / support.lengthMm, support.halfCarriedMm / support.lengthMm,
              support.longestUnsupportedMm, coverage.coveredFraction,
              (coverage.outsideMm3 + excess) / std::max(1e-9, cells.volumeMm3),
              job.report.item().layers.count, job.report.item().layers.thicknessMeanMm,
              job.report.item().layers.thicknessStdMm, job.report.item().layers.thicknessP01Mm,
              job.report.item().layers.thicknessP99Mm);

  // The unsupported beads by the tool-paths' own stage.
  const collision::GrowingPart growing(
      plan, collision::growingPitch(plan, process::Tooling(process)), ctx);
  const std::vector<char> hanging =
      toolpath::unsupportedWaypoints(plan, growing, job.item().platform, ctx);
  std::vector<Found> under(pieces.size());
  base::parallelChunks(ctx, pieces.size(), 4096, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e; ++p)
      under[p] = found(replay::Beneath(pieces, static_cast<std::uint32_t>(p), printed, ground));
  });
  // Length that is carried on less than half, by kind of path, height, and which side holds.
  std::map<std::string, std::array<double, 2>> share;
  std::vector<Run> runs;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const double length = (pieces[p].to - pieces[p].from).norm();
    const plan::ToolPath& path = *plan::pathOf(plan, pieces[p].motion);
    if (under[p].carried < 0.5) {
      const double h = static_cast<double>(pieces[p].toHeightMm);
      const double near = std::min(under[p].leftMm, under[p].rightMm),
                   far = std::max(under[p].leftMm, under[p].rightMm);
      const char* held = far < 6.0 ? "between" : near < 6.0 ? "beside" : "nowhere";
      char key[80];
      std::snprintf(key, sizeof key, "%-7s %-8s h %.1f w %.1f aside %.1f",
                    kKinds[static_cast<std::size_t>(path.kind)], held, 0.2 * std::floor(h / 0.2),
                    0.2 * std::floor(replay::sectionOf(pieces[p], 10.0).widthMm / 0.2),
                    0.4 * std::floor(near / 0.4));
      share[key][under[p].carried > 0.0 ? 0 : 1] += length;
    }
    const bool continues = p > 0 && pieces[p].run == pieces[p - 1].run;
    if (under[p].carried > 0.0)
      continue;
    if (!continues || runs.empty() || runs.back().end != p)
      runs.push_back({p, p, 0.0});
    runs.back().end = p + 1;
    runs.back().lengthMm += length;
  }
  std::vector<std::pair<std::string, std::array<double, 2>>> sorted(share.begin(), share.end());
  std::ranges::sort(sorted, std::greater{},
                    [](const auto& s) { return s.second[0] + s.second[1]; });
  for (std::size_t k = 0; k < std::min<std::size_t>(sorted.size(), 14); ++k)
    std::printf("    %s: less than half %.5f, on nothing %.5f of all\n", sorted[k].first.c_str(),
                sorted[k].second[0] / support.lengthMm, sorted[k].second[1] / support.lengthMm);
  std::erase_if(runs, [&](const Run& r) { return r.lengthMm <= overMm; });
  std::ranges::sort(runs, std::greater{}, &Run::lengthMm);
  std::printf("  %zu runs over %.1f mm\n", runs.size(), overMm);
  for (std::size_t r = 0; r < std::min(runs.size(), static_cast<std::size_t>(listed)); ++r) {
    const Run& run = runs[r];
    double h = 0, w = 0, near = 0, far = 0, lean = 0, down = 0, within = 0, later = 0, reported = 0;
    const double n = static_cast<double>(run.end - run.first);
    for (std::size_t p = run.first; p < run.end; ++p) {
      h += static_cast<double>(pieces[p].toHeightMm) / n;
      w += replay::sectionOf(pieces[p], 10.0).widthMm / n;
      near += std::min(under[p].leftMm, under[p].rightMm) / n;
      far += std::max(under[p].leftMm, under[p].rightMm) / n;
      down += under[p].downMm / n;
      const Vector3d gap =
          pieces[p].to - (static_cast<double>(pieces[p].toHeightMm) + 0.5 * under[p].downMm) *
                             pieces[p].toDirection;
      within += query.inside(gap) ? 1 / n : 0;
      reported += hanging[pieces[p].motion] ? 1 / n : 0;
      later += printed.printedAt(gap, {static_cast<std::uint32_t>(pieces.size())}) ? 1 / n : 0;
      const auto hit = query.closest(pieces[p].to - 0.5 * h * pieces[p].toDirection);
      const auto& t = part.triangles[static_cast<std::size_t>(hit.triangle)];
      const Vector3d normal = (part.vertices[static_cast<std::size_t>(t[1])] -
                               part.vertices[static_cast<std::size_t>(t[0])])
                                  .cross(part.vertices[static_cast<std::size_t>(t[2])] -
                                         part.vertices[static_cast<std::size_t>(t[0])])
                                  .normalized();
      lean += std::asin(std::clamp(-normal.dot(pieces[p].toDirection), -1.0, 1.0)) * 57.29578 / n;
    }
    const plan::ToolPath& path = *plan::pathOf(plan, pieces[run.first].motion);
    const std::size_t of = static_cast<std::size_t>(&path - plan.paths.data());
    const Vector3d at = pieces[(run.first + run.end) / 2].to;
    std::printf(
        "    %6.1f mm of %7.1f  layer %4d patch %4d path %5zu %-7s %s h %.2f w %.2f "
        "aside %.2f/%.2f down %.1f in %.2f later %.2f told %.2f lean %5.1f  at (%.1f %.1f %.1f)\n",
        run.lengthMm,
        static_cast<double>(std::ranges::max(std::vector<float>(
            1,
            [&] {
              float maximum = 0;
              for (std::size_t p = run.first;
                   p < pieces.size() && pieces[p].run == pieces[run.first].run; ++p)
                maximum = pieces[p].runMm;
              return maximum;
            }()))),
        path.layer, path.patch, of, kKinds[static_cast<std::size_t>(path.kind)],
        path.closed ? "ring" : "open", h, w, near, far, down, within, later, reported, lean, at.x(),
        at.y(), at.z());
  }
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app;
  std::vector<std::string> parts, sets;
  std::string keep, mode = "curved", platform = "fit:0", scale = "fit";
  int listed = 12, threads = 1;
  std::optional<double> overMm;
  app.add_option("parts", parts)->required();
  app.add_option("--keep", keep);
  app.add_option("--mode", mode);
  app.add_option("--platform", platform);
  app.add_option("--scale", scale);
  app.add_option("--set", sets);
  app.add_option("--over", overMm);
  app.add_option("--list", listed);
  app.add_option("--threads", threads);
  CLI11_PARSE(app, argc, argv);
  const base::RunContext ctx(base::CancelToken(), threads);
  for (const std::string& file : parts) {
    if (file.ends_with(".voluta")) {
      const project::Job job = project::readJob(file, pipeline::allParameters());
      report(job, depositedOf(*job.toolPlan, *job.trajectory),
             pipeline::chosenProcess(job.choices, pipeline::parameterValues(job.choices)), overMm,
             listed, ctx);
      continue;
    }
    pipeline::PlanRequest request;
    request.item().part = file;
    request.choices.item().mode = mode;
    request.choices.item().platform = project::Platform(platform);
    request.choices.item().scale = scale;
    for (const std::string& set : sets)
      pipeline::setParameters(request.choices, {set});
    request.until = project::Stage::Toolpath;
    pipeline::StageCache cache;
    const std::filesystem::path kept =
        std::filesystem::path(keep) /
        (std::filesystem::path(file).stem().string() + "-" + mode + ".voluta");
    if (!keep.empty() && std::filesystem::exists(kept)) {
      const project::Job job = project::readJob(kept, pipeline::allParameters());
      request.item().loaded = job.item().loaded;
      pipeline::seedCache(cache, project::upTo(job, project::Stage::Decompose));
    }
    const base::Stopwatch clock;
    const pipeline::PlanResult planned = pipeline::planPart(request, ctx, &cache);
    std::printf("%s %s: %.1f s\n", std::filesystem::path(file).stem().c_str(), mode.c_str(),
                clock.seconds());
    if (!keep.empty() && !std::filesystem::exists(kept))
      project::writeJob(kept, project::upTo(planned.job, project::Stage::Decompose));
    if (planned.job.toolPlan)
      report(planned.job, *planned.job.toolPlan, planned.tooling().first().process, overMm, listed,
             ctx);
    std::fflush(stdout);
  }
}
