#include "pipeline/joined_jobs.h"

#include "base/error.h"
#include "base/files.h"
#include "base/number_list.h"
#include "base/staged_folder.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "pipeline/checked_program.h"
#include "pipeline/outputs.h"
#include "pipeline/replay_stage.h"
#include "pipeline/resume.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "pipeline/together_check.h"
#include "plan/marks.h"
#include "plan/waypoints.h"
#include "program/dialect.h"
#include "together/machine_marks.h"
#include "together/plate_overlap.h"

#include <algorithm>
#include <cmath>
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
  using Kind = together::Obstruction::Kind;
  if (obstruction.kind == Kind::All)
    return "every two machines can work together, but no order of work was found for all: place "
           "the machines or the parts further apart"_text;
  const Eigen::Vector3d& p = obstruction.where;
  const base::Point where{p.x(), p.y(), p.z()};
  const auto [one, other] = obstruction.machines;
  const auto layer = [&](std::size_t machine, std::size_t segment) {
    return layerIn(result.plans[machine].job, result.work.rests[machine], segment);
  };
  if (obstruction.kind == Kind::Overlap)
    return base::message("the part of machine {one} or {two} is inside the part, the plate or an "
                         "obstacle of the other at {where}: place the machines or the parts "
                         "further apart"_text,
                         one + 1, other + 1, where);
  if (obstruction.kind == Kind::AtStart)
    return base::message("machines {one} and {two} are too close to each other before they move, "
                         "at {where}: place them further apart, or give one another home"_text,
                         one + 1, other + 1, where);
  if (obstruction.kind == Kind::AtRest) {
    const auto& bodies = result.plans[one].cell->bodies();
    const auto& others = result.plans[other].cell->bodies();
    return base::message(
        "{body} of machine {one} meets {obstacle} of machine {two} at {where} ({layer}): place "
        "the machines further apart, or the part further from the border"_text,
        robot::nameOf(bodies[static_cast<std::size_t>(obstruction.contact.body)]), one + 1,
        robot::nameOf(others[static_cast<std::size_t>(obstruction.contact.other)]), other + 1,
        where, layer(one, obstruction.contact.segment));
  }
  return base::message(
      "no order of work keeps the machines apart: {first} of machine {one} and {second} of machine "
      "{two} hinder each other at {where}: place the machines further apart, the parts further "
      "from the border, or the arms at rest further from it"_text,
      layer(one, obstruction.segments[0]), one + 1, layer(other, obstruction.segments[1]),
      other + 1, where);
}

std::vector<base::Message> overlapNotes(const std::vector<together::Machine>& machines) {
  std::vector<base::Message> notes;
  for (std::size_t one = 0; one < machines.size(); ++one)
    for (std::size_t two = one + 1; two < machines.size(); ++two)
      if (const auto overlap =
              together::plateOverlap({machines[one].cell, machines[one].shared_T_world},
                                     {machines[two].cell, machines[two].shared_T_world}))
        notes.push_back(base::message(
            "the plates of machine {one} ({cell}) and machine {two} ({other}) overlap by "
            "{depth:.1f} ({area:.0f})"_text,
            one + 1, machines[one].cell.id(), two + 1, machines[two].cell.id(),
            base::mm(overlap->depthMm), base::mm2(overlap->areaMm2)));
  return notes;
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

void mark(PlanResult& result, const std::vector<together::MarkPlace>& marks) {
  if (marks.empty())
    return;
  result.job.trajectory =
      std::make_shared<const plan::Trajectory>(together::withMarks(*result.job.trajectory, marks));
  takeFormats(result);
}
} // namespace

void requireJoinable(const project::Job& job, const std::string& name) {
  if (!job.item().part || !job.toolPlan || !job.trajectory)
    throw Error(ErrorCode::UnusableInput, "the job has no motion"_text, name,
                "plan it without --until"_text);
  if (job.resumedAt > 0)
    throw Error(ErrorCode::UnusableInput, "the job is the rest of a print"_text, name,
                "use the whole job"_text);
}

project::Job jobToJoin(const std::filesystem::path& file) {
  base::finishStaged(std::filesystem::absolute(file).parent_path());
  project::Job job = project::readJob(file, allParameters());
  requireJoinable(job, file.string());
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

double machineTurnDeg(const Eigen::Isometry3d& place) {
  const Eigen::Vector3d x = place.linear().col(0);
  return base::radiansToDegrees(std::atan2(x.y(), x.x()));
}

namespace {
std::optional<plan::ReadProgram> readBack(const PlanResult& result, const base::RunContext& ctx) {
  const CheckedProgram* checked = replayedTogether(result);
  if (!checked)
    return std::nullopt;
  return program::readProgram(checked->program.format, checked->program.files, *result.tooling,
                              ctx);
}

std::optional<replay::SharedRun> replayTogether(const TogetherResult& result,
                                                const base::RunContext& ctx) {
  std::vector<plan::ReadProgram> read;
  for (const PlanResult& plan : result.plans) {
    std::optional<plan::ReadProgram> program = readBack(plan, ctx.quiet());
    if (!program)
      return std::nullopt;
    read.push_back(std::move(*program));
  }
  std::vector<replay::RunningMachine> machines;
  for (std::size_t k = 0; k < read.size(); ++k)
    machines.push_back({read[k], *result.plans[k].cell, result.plans[k].tooling->first().process,
                        result.shared_T_world[k]});
  return replay::runTogether(machines, ctx);
}
} // namespace

TogetherResult planTogether(TogetherRequest request, const base::RunContext& ctx) {
  const std::size_t count = request.machines.size();
  if (count < 2 || count > plan::kMostMachines)
    throw Error(ErrorCode::Usage,
                base::message("{count} jobs: two to {most} machines can work together"_text, count,
                              plan::kMostMachines),
                {}, {});
  TogetherResult result;
  std::vector<std::unique_ptr<OwnedMachine>> owned;
  std::vector<together::Machine> machines;
  for (JoinedJob& joined : request.machines) {
    requireJoinable(joined.job, joined.job.item().partName);
    dropMarks(joined.job);
    PlanResult& plan = result.plans.emplace_back(
        resultOf(project::upTo(std::move(joined.job), project::Stage::Motion)));
    result.shared_T_world.push_back(joined.shared_T_world);
    owned.push_back(std::make_unique<OwnedMachine>(plan, joined.shared_T_world, ctx));
    machines.push_back(owned.back()->machine);
  }
  result.notes = overlapNotes(machines);
  result.work = together::planTogether(machines, request.options, ctx.sub(0.05, 0.5));
  if (!result.work.order) {
    result.obstruction = inWords(result, *result.work.obstruction);
    return result;
  }
  const double share = 0.3 / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    mark(result.plans[k], together::marksOf(*result.work.order, k, result.work.rests[k]));
    const double from = 0.5 + share * static_cast<double>(k);
    result.plans[k] = written(std::move(result.plans[k].job), ctx.sub(from, from + share));
  }
  result.replay = replayTogether(result, ctx.sub(0.8, 1.0));
  return result;
}

const CheckedProgram* replayedTogether(const PlanResult& plan) {
  for (const auto& checked : plan.checked)
    if (checked->passed && checked->armChecked)
      return checked.get();
  return nullptr;
}

std::optional<base::Message> refusal(const TogetherResult& result) {
  if (result.obstruction)
    return result.obstruction;
  for (std::size_t k = 0; k < result.plans.size(); ++k)
    if (!nothingBlocks(result.plans[k].job.report))
      return base::message("a finding of machine {machine} blocks (see its report.json)"_text,
                           k + 1);
  if (!result.replay)
    return "a program was refused, or does not state the arm"_text;
  return refusal(*result.replay);
}

bool passed(const TogetherResult& result) {
  return !refusal(result);
}

std::string togetherFolder(std::size_t machine) {
  return "machine" + std::to_string(machine + 1);
}

void writeTogether(TogetherResult& result, const std::filesystem::path& folder,
                   const base::RunContext& ctx) {
  if (!result.obstruction)
    for (std::size_t k = 0; k < result.plans.size(); ++k) {
      const std::filesystem::path own = folder / togetherFolder(k);
      std::filesystem::create_directories(own);
      writeOutputs(result.plans[k], own, ctx.quiet());
    }
  base::writeFile(folder / "together.json", togetherJson(result));
}

} // namespace voluta::pipeline
