#include "pipeline/station_plan.h"

#include "base/error.h"
#include "base/far_places.h"
#include "base/files.h"
#include "base/number_list.h"
#include "base/staged_folder.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/resumed_motion.h"
#include "pipeline/checked_program.h"
#include "pipeline/outputs.h"
#include "pipeline/placed_programs.h"
#include "pipeline/replay_stage.h"
#include "pipeline/resume.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "pipeline/station_check.h"
#include "pipeline/station_findings.h"
#include "plan/finding_kinds.h"
#include "plan/marks.h"
#include "program/dialect.h"
#include "together/machine_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <span>

namespace voluta::pipeline {

namespace {
using base::Error;
using base::ErrorCode;

// The motion that is still to be run, with the part as printed before.
together::PlacedMotion placedMotion(const PlanResult& plan, const Eigen::Isometry3d& shared_T_world,
                                    const base::RunContext& ctx) {
  const project::Job& job = plan.job;
  const double pitchMm = collision::growingPitch(*job.toolPlan, plan.tooling());
  together::PlacedMotion motion{
      plan.cell,
      std::make_shared<const collision::CellCollision>(*plan.cell, plan.tooling().first().process),
      job.toolPlan,
      job.trajectory,
      std::make_shared<const collision::GrowingPart>(
          *job.toolPlan, pitchMm, ctx,
          collision::groundCells(project::platformOf(job), *job.toolPlan, pitchMm, ctx)),
      shared_T_world};
  if (job.resumedAt > 0) {
    motion.trajectory = std::make_shared<const plan::Trajectory>(
        motion::partOf(*job.trajectory, job.resumedAt, job.trajectory->pointCount()));
    motion.printedBefore = motion::printedBefore(*job.trajectory, job.resumedAt);
  }
  return motion;
}

// Chooses formats that have words for marks; formats that the user chose have to have them.
void takeFormats(PlanResult& result) {
  std::vector<std::string>& formats = result.job.choices.formats;
  const bool areChosen = !formats.empty();
  formats = chosenFormats(result.job.choices, *result.cell);
  const auto isRefused = [&](const std::string& id) {
    return program::refusal(program::findDialect(id), *result.cell, {}, result.job.trajectory.get())
        .has_value();
  };
  if (!areChosen && !std::ranges::all_of(formats, isRefused))
    std::erase_if(formats, isRefused);
  for (const std::string& id : formats)
    program::requireEvents(program::findDialect(id), *result.job.trajectory);
}

// `marks`: at points of the motion from job.resumedAt on.
void addMarks(PlanResult& result, std::vector<together::MarkPlace> marks) {
  if (marks.empty())
    return;
  for (together::MarkPlace& mark : marks)
    mark.point += result.job.resumedAt;
  result.job.trajectory =
      std::make_shared<const plan::Trajectory>(together::withMarks(*result.job.trajectory, marks));
  takeFormats(result);
}
} // namespace

void requireMotion(const project::Job& job, const std::string& name) {
  if (!job.item().part || !job.toolPlan || !job.trajectory)
    throw Error(ErrorCode::UnusableInput, "the job has no motion"_text, name,
                "plan it without --until"_text);
}

project::Job withoutMarks(project::Job job) {
  plan::Trajectory unmarked = *job.trajectory;
  std::erase_if(unmarked.events, [](const plan::TrajectoryEvent& event) {
    return event.kind == plan::EventKind::Mark;
  });
  job.trajectory = std::make_shared<const plan::Trajectory>(std::move(unmarked));
  return job;
}

project::Station plannedStation(const std::filesystem::path& file) {
  base::finishStaged(std::filesystem::absolute(file).parent_path());
  project::Station station = project::readStation(file, allParameters());
  for (const project::Machine& machine : station.machines)
    requireMotion(machine.job, file.string());
  return station;
}

Eigen::Isometry3d parsedMachinePlace(const std::string& text) {
  double x = 0.0, y = 0.0, z = 0.0, rotationDeg = 0.0;
  if (!base::readNumbers(text, ',', {&x, &y, &z, &rotationDeg}))
    throw Error(ErrorCode::Usage, base::message("'{place}' is no place"_text, text.substr(0, 60)),
                {}, "give X,Y,Z in mm and a rotation about z in degrees, as in 900,0,0,180"_text);
  base::refuseFar(std::array{x, y, z}, text, "the place of a machine"_text);
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() = Eigen::Vector3d(x, y, z);
  place.rotate(Eigen::AngleAxisd(base::degreesToRadians(rotationDeg), Eigen::Vector3d::UnitZ()));
  return place;
}

double machineRotationDeg(const Eigen::Isometry3d& place) {
  const Eigen::Vector3d x = place.linear().col(0);
  return base::radiansToDegrees(std::atan2(x.y(), x.x()));
}

namespace {
std::optional<plan::ReadProgram> readBack(const PlanResult& result, const base::RunContext& ctx) {
  const CheckedProgram* checked = replayedTogether(result);
  if (!checked)
    return std::nullopt;
  return program::readProgram(checked->program.format, checked->program.files, result.tooling(),
                              ctx);
}

std::optional<replay::SharedRun> replayTogether(const StationResult& result,
                                                const base::RunContext& ctx) {
  std::vector<plan::ReadProgram> read;
  for (const PlanResult& plan : result.plans) {
    std::optional<plan::ReadProgram> program = readBack(plan, ctx.quiet());
    if (!program)
      return std::nullopt;
    read.push_back(std::move(*program));
  }
  return replay::runTogether(placedPrograms(read, result.plans, result.shared_T_world), ctx);
}

// The inputs of an order of work.
together::Options optionsOf(const project::StationRules& rules) {
  together::Options options;
  options.distances.clearanceMm = rules.clearanceMm;
  options.insideBeadsS = rules.pauseInBeadsS;
  return options;
}

std::size_t firstNotReplayed(const StationResult& result) {
  const auto found = std::ranges::find_if(
      result.plans, [](const PlanResult& plan) { return !replayedTogether(plan); });
  return static_cast<std::size_t>(found - result.plans.begin());
}

std::shared_ptr<const StationStage> stationStage(const StationResult& result,
                                                 const base::RunContext& ctx) {
  std::vector<together::PlacedMotion> motions;
  for (std::size_t k = 0; k < result.plans.size(); ++k)
    motions.push_back(placedMotion(result.plans[k], result.shared_T_world[k], ctx));
  auto stage = std::make_shared<StationStage>();
  stage->findings = overlapFindings(motions);
  stage->work = together::planTogether(motions, optionsOf(result.rules), ctx.sub(0.05, 1.0));
  if (stage->work.obstruction)
    stage->findings.push_back(
        obstructionFinding(*stage->work.obstruction, stage->work, result.plans, motions));
  return stage;
}
} // namespace

std::string stationKey(const project::Station& station) {
  std::string key =
      fmt::format("station {} {}", station.rules.clearanceMm, station.rules.pauseInBeadsS);
  for (const project::Machine& machine : station.machines) {
    key += "\nmotion: " + machine.job.stages[project::indexOf(project::Stage::Motion)].key;
    for (const double value : std::span(machine.shared_T_world.data(), 16))
      key += fmt::format(" {}", value);
  }
  return key;
}

StationResult planStation(project::Station station, const base::RunContext& ctx,
                          StageCache* cache) {
  const std::size_t count = station.machines.size();
  if (count < 2 || count > plan::kMaxMachines)
    throw Error(ErrorCode::Usage,
                base::message("{count} jobs: two to {most} machines can work together"_text, count,
                              plan::kMaxMachines),
                {}, {});
  // The motion of a rest follows from the place at which the print stopped too.
  const bool isCached = cache && std::ranges::none_of(station.machines, [](const auto& machine) {
                          return machine.job.resumedAt > 0;
                        });
  const std::string key = stationKey(station);
  StationResult result;
  result.rules = station.rules;
  for (project::Machine& machine : station.machines) {
    requireMotion(machine.job, machine.job.item().partName);
    machine.job = withoutMarks(std::move(machine.job));
    result.names.push_back(std::move(machine.name));
    result.shared_T_world.push_back(machine.shared_T_world);
    result.plans.push_back(resultOf(project::upTo(std::move(machine.job), project::Stage::Motion)));
  }
  std::shared_ptr<const StationStage> stage;
  if (isCached)
    stage = cache->find<StationStage>(key, "station");
  if (!stage)
    stage = stationStage(result, ctx.sub(0.0, 0.5));
  if (isCached)
    cache->keep(key, stage, "station");
  result.work = stage->work;
  result.findings = stage->findings;
  if (!result.work.order)
    return result;
  const double share = 0.3 / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    addMarks(result.plans[k], together::marksOf(*result.work.order, k, result.work.rests[k]));
    const double from = 0.5 + share * static_cast<double>(k);
    result.plans[k] = written(std::move(result.plans[k].job), ctx.sub(from, from + share));
    const project::Report& report = result.plans[k].job.report;
    if (auto finding = machineFinding(k, verdictOf(report), report.findings))
      result.findings.push_back(std::move(*finding));
  }
  result.replay = replayTogether(result, ctx.sub(0.8, 1.0));
  if (result.replay)
    std::ranges::copy(runFindings(*result.replay), std::back_inserter(result.findings));
  else if (std::ranges::none_of(result.findings, plan::blocksRunning))
    result.findings.push_back(machineFinding(firstNotReplayed(result),
                                             "no program of it passed that states the arm"_text));
  return result;
}

project::Station stationOf(const StationResult& result) {
  project::Station station;
  station.rules = result.rules;
  for (std::size_t k = 0; k < result.plans.size(); ++k)
    station.machines.push_back({result.names[k], result.plans[k].job, result.shared_T_world[k]});
  return station;
}

const CheckedProgram* replayedTogether(const PlanResult& plan) {
  for (const auto& checked : plan.checked)
    if (checked->safeToRun && checked->armChecked)
      return checked.get();
  return nullptr;
}

PlanVerdict verdictOf(const StationResult& result) {
  const plan::Finding* first = firstBlocking(result.findings);
  if (!first)
    return PlanVerdict::Passed;
  if (plan::blocksRunning(*first))
    return PlanVerdict::Refused;
  const bool isUnchecked = std::ranges::any_of(result.plans, [](const PlanResult& plan) {
    return verdictOf(plan.job.report) == PlanVerdict::Unchecked;
  });
  return isUnchecked ? PlanVerdict::Unchecked : PlanVerdict::NotAsAsked;
}

bool passed(const StationResult& result) {
  return !firstBlocking(result.findings);
}

std::string machineFolder(std::size_t machine) {
  return "machine" + std::to_string(machine + 1);
}

void writeStationOutputs(StationResult& result, const std::filesystem::path& folder,
                         const base::RunContext& ctx) {
  if (result.work.order)
    for (std::size_t k = 0; k < result.plans.size(); ++k) {
      const std::filesystem::path own = folder / machineFolder(k);
      std::filesystem::create_directories(own);
      writeOutputs(result.plans[k], own, ctx.quiet());
    }
  project::writeStation(folder / project::kStationFile, stationOf(result));
  base::writeFile(folder / "together.json", stationJson(result));
}

} // namespace voluta::pipeline
