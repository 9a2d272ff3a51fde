#include "pipeline/together.h"

#include "base/error.h"
#include "base/files.h"
#include "base/number_list.h"
#include "base/staged_folder.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "pipeline/choices.h"
#include "pipeline/outputs.h"
#include "pipeline/replay_stage.h"
#include "pipeline/resume.h"
#include "pipeline/road.h"
#include "plan/waypoints.h"
#include "program/dialect.h"
#include "together/marks.h"

#include <algorithm>
#include <memory>

namespace voluta::pipeline {

namespace {
using base::Error;
using base::ErrorCode;

void dropMarks(project::Job& job) {
  plan::Trajectory unmarked = *job.trajectory;
  std::erase_if(unmarked.events, [](const plan::TrajectoryEvent& event) {
    return event.kind == plan::EventKind::Mark;
  });
  job.trajectory = std::make_shared<const plan::Trajectory>(std::move(unmarked));
}

// A machine with the objects that it refers to.
struct OwnedMachine {
  OwnedMachine(const PlanResult& result, const Eigen::Isometry3d& shared_T_world,
               const base::RunContext& ctx)
      : collision(*result.cell, result.tooling->first().process),
        pitchMm(collision::growingPitch(*result.job.toolPlan, *result.tooling)),
        part(*result.job.toolPlan, pitchMm, ctx,
             collision::groundCells(project::platformOf(result.job), pitchMm, ctx)),
        machine{*result.cell,           collision, *result.job.toolPlan,
                *result.job.trajectory, part,      shared_T_world} {}
  const collision::CellCollision collision;
  const double pitchMm;
  const collision::GrowingPart part;
  const together::Machine machine;
};

// Returns "layer 3", of the first bead in the segment or after it.
base::Message layerIn(const project::Job& job, const together::Rests& rests, std::size_t segment) {
  for (std::size_t i = rests.point[segment]; i < job.trajectory->pointCount(); ++i)
    if (const std::size_t w = job.trajectory->waypoint[i]; w != plan::kNoWaypoint)
      return base::message("layer {layer}"_text, plan::pathOf(*job.toolPlan, w)->layer);
  return "the way home"_text;
}

base::Message inWords(const TogetherResult& result, const together::Obstruction& obstruction) {
  const Eigen::Vector3d& p = obstruction.where;
  const base::Point where{p.x(), p.y(), p.z()};
  using Kind = together::Obstruction::Kind;
  if (obstruction.kind == Kind::Overlap)
    return base::message("the part of one machine is inside the part, the plate or an obstacle of "
                         "the other at {where}: place the machines or the parts further apart"_text,
                         where);
  if (obstruction.kind == Kind::AtStart)
    return base::message("the machines are too close to each other before they move, at {where}: "
                         "place them further apart, or give one another home"_text,
                         where);
  if (obstruction.kind == Kind::AtRest) {
    const auto own = static_cast<std::size_t>(obstruction.machine);
    const auto& bodies = result.plans[own].cell->bodies();
    const auto& others = result.plans[1 - own].cell->bodies();
    return base::message(
        "{body} of machine {machine} meets {other} of the other machine at {where} ({layer}): "
        "place the machines further apart, or the part further from the border"_text,
        robot::nameOf(bodies[static_cast<std::size_t>(obstruction.contact.body)]), own + 1,
        robot::nameOf(others[static_cast<std::size_t>(obstruction.contact.other)]), where,
        layerIn(result.plans[own].job, own == 0 ? result.work.a : result.work.b,
                obstruction.contact.segment));
  }
  return base::message(
      "no order of work keeps the machines apart: {first} of machine 1 and {second} of machine 2 "
      "hinder each other at {where}: place the machines further apart, the parts further from the "
      "border, or the arms at rest further from it"_text,
      layerIn(result.plans[0].job, result.work.a, obstruction.aSegment),
      layerIn(result.plans[1].job, result.work.b, obstruction.bSegment), where);
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

void mark(PlanResult& result, const std::vector<std::size_t>& points) {
  if (points.empty())
    return;
  result.job.trajectory =
      std::make_shared<const plan::Trajectory>(together::withMarks(*result.job.trajectory, points));
  takeFormats(result);
}
} // namespace

project::Job jobToJoin(const std::filesystem::path& file) {
  base::finishStaged(std::filesystem::absolute(file).parent_path());
  project::Job job = project::readJob(file);
  if (!job.item().part || !job.toolPlan || !job.trajectory)
    throw Error(ErrorCode::UnusableInput, "the job has no motion"_text, file.string(),
                "plan it without --until"_text);
  if (job.resumedAt > 0)
    throw Error(ErrorCode::UnusableInput, "the job is the rest of a print"_text, file.string(),
                "use the whole job"_text);
  return job;
}

Eigen::Isometry3d parsedMachinePlace(const std::string& text) {
  double x = 0.0, y = 0.0, z = 0.0, turnDeg = 0.0;
  if (!base::readNumbers(text, ',', {&x, &y, &z, &turnDeg}))
    throw Error(ErrorCode::Usage, base::message("'{place}' is no place"_text, text.substr(0, 60)),
                {}, "give X,Y,Z in mm and a rotation about z in degrees, as in 900,0,0,180"_text);
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() = Eigen::Vector3d(x, y, z);
  place.rotate(Eigen::AngleAxisd(base::degreesToRadians(turnDeg), Eigen::Vector3d::UnitZ()));
  return place;
}

namespace {
// Returns the first program that passed, read back from its text; nullopt if there is none.
std::optional<plan::ReadProgram> readBack(const PlanResult& result, const base::RunContext& ctx) {
  for (const auto& checked : result.checked)
    if (checked->passed && checked->armChecked)
      return program::readProgram(checked->program.format, checked->program.files, *result.tooling,
                                  ctx);
  return std::nullopt;
}

std::optional<replay::TwoMachines> replayTogether(const TogetherResult& result,
                                                  const base::RunContext& ctx) {
  std::array<std::optional<plan::ReadProgram>, 2> read;
  std::vector<replay::RunningMachine> machines;
  for (std::size_t k = 0; k < 2; ++k) {
    read[k] = readBack(result.plans[k], ctx.quiet());
    if (!read[k])
      return std::nullopt;
    machines.push_back({*read[k], *result.plans[k].cell, result.plans[k].tooling->first().process,
                        result.shared_T_world[k]});
  }
  return replay::runTogether(machines[0], machines[1], ctx);
}
} // namespace

TogetherResult planTogether(TogetherRequest request, const base::RunContext& ctx) {
  TogetherResult result;
  result.shared_T_world = {Eigen::Isometry3d::Identity(), request.first_T_second};
  std::array<std::unique_ptr<OwnedMachine>, 2> machines;
  for (std::size_t k = 0; k < 2; ++k) {
    project::Job& job = request.jobs[k];
    base::require(job.item().part && job.toolPlan && job.trajectory, "jobs with motions");
    dropMarks(job);
    result.plans[k] = resultOf(project::upTo(std::move(job), project::Stage::Motion));
    machines[k] = std::make_unique<OwnedMachine>(result.plans[k], result.shared_T_world[k], ctx);
  }
  result.work = together::planTogether(machines[0]->machine, machines[1]->machine, request.options,
                                       ctx.sub(0.05, 0.5));
  if (!result.work.schedule) {
    result.obstruction = inWords(result, *result.work.obstruction);
    return result;
  }
  mark(result.plans[0], together::marksOfA(*result.work.schedule, result.work.a));
  mark(result.plans[1], together::marksOfB(*result.work.schedule, result.work.b));
  for (std::size_t k = 0; k < 2; ++k) {
    const double from = 0.5 + 0.15 * static_cast<double>(k);
    result.plans[k] = written(std::move(result.plans[k].job), ctx.sub(from, from + 0.15));
  }
  result.replay = replayTogether(result, ctx.sub(0.8, 1.0));
  return result;
}

bool passed(const TogetherResult& result) {
  return !result.obstruction && result.replay && !result.replay->clock.stuck &&
         result.replay->collisions == 0 && nothingBlocks(result.plans[0].job.report) &&
         nothingBlocks(result.plans[1].job.report);
}

void writeTogether(TogetherResult& result, const std::filesystem::path& folder,
                   const base::RunContext& ctx) {
  constexpr std::array kFolders = {"first", "second"};
  if (!result.obstruction)
    for (std::size_t k = 0; k < 2; ++k) {
      std::filesystem::create_directories(folder / kFolders[k]);
      writeOutputs(result.plans[k], folder / kFolders[k], ctx.quiet());
    }
  base::writeFile(folder / "together.json", togetherJson(result));
}

} // namespace voluta::pipeline
