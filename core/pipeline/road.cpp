#include "pipeline/road.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/stopwatch.h"
#include "collision/growing_part.h"
#include "curved/platform.h"
#include "geometry/measures.h"
#include "geometry/placement.h"
#include "motion/motion.h"
#include "pipeline/choices.h"
#include "pipeline/load_stage.h"
#include "pipeline/modes.h"
#include "pipeline/replay_stage.h"
#include "program/dialect.h"
#include "robot/cell.h"
#include "toolpath/plan_toolpaths.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

constexpr std::array<std::string_view, 6> kUntilNames{"load",     "decompose", "layers",
                                                      "toolpath", "motion",    "replay"};

// Tilt to which every point of a part has to be within reach; layers that wrap the sides of a part
// ask for about this much.
constexpr double kReachTiltRad = 1.75;

// Cells of the part that collision is checked against: about half a bead.
constexpr double kGrowingPitchMm = 0.5;

void append(plan::Findings& findings, const plan::Findings& more) {
  findings.insert(findings.end(), more.begin(), more.end());
}

// Largest scale <= 1 at which the ball about the part's box, standing on the plate, is in reach.
double fittingScale(const geometry::TriangleMesh& mesh, const robot::Cell& cell) {
  const geometry::TriangleMesh placed = geometry::placeOnPlate(mesh, 1.0);
  const Eigen::AlignedBox3d box = geometry::bounds(placed);
  const double radius = 0.5 * box.diagonal().norm();
  return std::min(1.0, robot::reachableBallRadius(cell, kReachTiltRad) / radius);
}

std::vector<std::string> chosenFormats(const Choices& choices, const robot::Cell& cell) {
  if (!choices.formats.empty())
    return choices.formats;
  return {cell.robot().controller, "gcode-extended", "csv"};
}

void planToolpathStage(PlanResult& result, const process::Process& process,
                       const base::ParameterValues& values, const base::RunContext& ctx) {
  toolpath::ToolpathOptions options = toolpath::toolpathOptions(values);
  options.stepMm = process.stepMm;
  options.platform = result.job.platform;
  toolpath::ToolpathResult planned = toolpath::planToolpaths(*result.layers, process, options, ctx);
  const toolpath::ToolpathStatistics& s = planned.statistics;
  ToolpathReport& r = result.report.toolpath;
  r.paths = s.paths;
  r.waypoints = s.waypoints;
  r.lengthMm = s.lengthMm;
  r.travelMm = s.travelMm;
  r.starts = s.starts;
  r.simpleRegions = s.simpleRegions;
  r.coveredFraction = s.coveredFraction;
  r.overlapFraction = s.overlapFraction;
  r.gouges = s.gouges;
  r.maxTurnDeg = s.maxTurnDeg;
  r.materialMm3 = s.materialMm3;
  result.report.timings.toolpath = planned.seconds.toolpath;
  result.report.timings.orient = planned.seconds.orient;
  append(result.report.findings, planned.findings);
  result.job.toolPlan = std::make_shared<plan::ToolPlan>(std::move(planned.plan));
}

void planMotionStage(PlanResult& result, const process::Process& process, const robot::Cell& cell,
                     const base::ParameterValues& values, const base::RunContext& ctx) {
  const plan::ToolPlan& toolPlan = *result.job.toolPlan;
  if (toolPlan.paths.empty()) {
    append(result.report.findings,
           {{"motion", "nothingToPrint", std::nullopt, std::nullopt, 1,
             "no tool-path is left to move along", "choose a smaller voxelMm or beadWidthMm"}});
    return;
  }
  base::Stopwatch depositing;
  const motion::MotionOptions options = motion::motionOptions(values);
  const collision::GrowingPart growing(toolPlan, kGrowingPitchMm, ctx.sub(0.0, 0.05));
  result.report.timings.collision += depositing.seconds();
  motion::MotionResult planned =
      motion::planMotion(toolPlan, cell, process, growing, options, ctx.sub(0.05, 1.0));
  const motion::MotionStatistics& s = planned.statistics;
  MotionReport& r = result.report.motion;
  r.waypoints = s.waypoints;
  r.unreachable = s.unreachable;
  r.collisions = s.collisions;
  r.splits = s.splits;
  r.maxJerk = s.maxJerk;
  r.sumSquaredJerk = s.sumSquaredJerk;
  r.sumSquaredJerkBefore = s.sumSquaredJerkBefore;
  r.minClearanceMm = s.minClearanceMm;
  r.durationS = s.durationS;
  Timings& t = result.report.timings;
  t.ik += planned.times.ik;
  t.graph += planned.times.graph;
  t.collision += planned.times.collision;
  t.jerk += planned.times.jerk;
  t.transfer += planned.times.transfer;
  append(result.report.findings, planned.findings);
  result.job.trajectory = std::make_shared<plan::Trajectory>(std::move(planned.trajectory));
}

// Writes each program, reads it back and replays it; those that hold are kept.
void programStage(PlanResult& result, const process::Process& process, const robot::Cell& cell,
                  bool keepRefused, const base::RunContext& ctx) {
  const std::vector<std::string> formats = chosenFormats(result.job.choices, cell);
  const std::string name = std::filesystem::path(result.job.partName).stem().string();
  const program::ProgramInput input{*result.job.toolPlan, *result.job.trajectory, cell, process,
                                    name};
  bool judged = false;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const base::RunContext part = ctx.sub(static_cast<double>(i) / formats.size(),
                                          static_cast<double>(i + 1) / formats.size());
    base::Stopwatch writing;
    part.report(0.0, "write " + formats[i]);
    plan::Program written = program::writeProgram(formats[i], input, part.sub(0.0, 0.1));
    result.report.timings.write += writing.seconds();
    ProgramReport row;
    row.format = written.format;
    row.foreign = written.foreign;
    for (const plan::ProgramFile& file : written.files) {
      row.files.push_back(file.name);
      row.bytes += file.text.size();
    }
    base::Stopwatch replaying;
    replay::Verification verdict =
        replayText(written.format, written.files, result.job, cell, process, part.sub(0.1, 1.0));
    result.report.timings.replay += replaying.seconds();
    row.maxDeviationMm = verdict.maxDeviationMm;
    row.maxDeviationRad = verdict.maxDeviationRad;
    result.report.programs.push_back(row);
    // Lines are of this program's text, and there are several programs.
    for (plan::Finding& finding : verdict.findings)
      finding.reason = fmt::format("{}: {}", formats[i], finding.reason);
    // The first program, the cell's own unless the user chose others, carries the verdict.
    if (!judged)
      result.report.replay = replayReport(verdict);
    if (!judged || !verdict.passed)
      append(result.report.findings, verdict.findings);
    judged = true;
    if (!verdict.passed) {
      append(result.report.findings, {{"replay", "programRefused", std::nullopt, std::nullopt, 1,
                                       fmt::format("the {} program is not handed over: {}",
                                                   formats[i], failedThresholds(verdict)),
                                       "see the findings before this one"}});
      for (plan::ProgramFile& file : written.files)
        file.name = "refused-" + file.name;
    }
    if (verdict.passed || keepRefused)
      result.programs.push_back(std::move(written));
  }
}
} // namespace

Until untilOf(const std::string& name) {
  const auto found = std::find(kUntilNames.begin(), kUntilNames.end(), name);
  if (found == kUntilNames.end())
    throw base::Error(base::ErrorCode::Usage, "unknown stage '" + name + "'", {},
                      "did you mean " +
                          base::nearestName(name, std::vector<std::string>(kUntilNames.begin(),
                                                                           kUntilNames.end())) +
                          "?");
  return static_cast<Until>(found - kUntilNames.begin());
}

PlanResult planPart(const PlanRequest& request, const base::RunContext& ctx) {
  base::Stopwatch whole;
  const Choices& choices = request.choices;
  checkChoices(choices);
  const base::ParameterValues values = parameterValues(choices);
  const process::Process process = chosenProcess(choices, values);

  PlanResult result;
  Report& report = result.report;
  report.threads = ctx.threads();
  result.debug = values.boolean("output.debug");
  result.job.choices = choices;
  report.decomposition.mode = choices.mode;
  const auto finish = [&] {
    report.timings.total = whole.seconds();
    return std::move(result);
  };

  ctx.report(0.0, "load");
  const LoadedPart loaded = loadPart(request.part, report.timings, ctx.sub(0.0, 0.03));
  const double wanted = parsedScale(choices.scale);
  result.job.partName = loaded.name;
  result.job.scale = wanted > 0.0
                         ? wanted
                         : fittingScale(loaded.mesh, robot::loadCell(choices.cell, process,
                                                                     curved::platformDisc(80.0)));
  result.job.part = placePart(loaded, result.job.scale, report);
  if (request.until == Until::Load)
    return finish();

  ModeResult built =
      findMode(choices.mode)
          .build({*result.job.part, choices, values, process, request.until == Until::Decompose},
                 report, ctx.sub(0.03, 0.3));
  result.job.platform = std::move(built.platform);
  result.decomposition = std::move(built.decomposition);
  result.layers = std::move(built.layers);
  if (request.until <= Until::Layers)
    return finish();

  planToolpathStage(result, process, values, ctx.sub(0.3, 0.5));
  if (request.until == Until::Toolpath)
    return finish();

  const robot::Cell cell = robot::loadCell(choices.cell, process, result.job.platform);
  report.motion.robot = cell.robot().id;
  report.motion.cell = cell.id();
  planMotionStage(result, process, cell, values, ctx.sub(0.5, 0.8));
  if (request.until == Until::Motion || !result.job.trajectory)
    return finish();

  programStage(result, process, cell, values.boolean("output.refused"), ctx.sub(0.8, 1.0));
  return finish();
}

bool nothingBlocks(const Report& report) {
  return std::none_of(report.findings.begin(), report.findings.end(),
                      [](const plan::Finding& f) { return f.blocking; });
}

} // namespace voluta::pipeline
