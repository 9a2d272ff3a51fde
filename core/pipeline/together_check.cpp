#include "pipeline/together_check.h"

#include "base/error.h"
#include "base/files.h"
#include "base/units.h"
#include "pipeline/program_files.h"
#include "pipeline/stage_options.h"
#include "plan/marks.h"
#include "program/dialect.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace voluta::pipeline {

namespace {
using base::Error;
using base::ErrorCode;

struct Entry {
  std::filesystem::path program, job;
  Eigen::Isometry3d shared_T_world = Eigen::Isometry3d::Identity();
};

std::vector<Entry> entriesOf(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "together.json";
  std::vector<Entry> entries;
  try {
    const auto json = nlohmann::json::parse(base::readFile(file));
    for (const auto& machine : json.at("machines")) {
      Entry& entry = entries.emplace_back();
      const std::filesystem::path own = folder / machine.at("folder").get<std::string>();
      entry.program = own / machine.at("program").get<std::string>();
      entry.job = own / "job.voluta";
      const auto& place = machine.at("placeMm");
      for (Eigen::Index k = 0; k < 3; ++k)
        entry.shared_T_world.translation()[k] = place.at(static_cast<std::size_t>(k)).get<double>();
      const double turn = base::degreesToRadians(machine.at("turnDeg").get<double>());
      entry.shared_T_world.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()));
    }
  } catch (const nlohmann::json::exception&) {
    entries.clear();
  }
  if (entries.size() < 2 || entries.size() > plan::kMostMachines)
    throw Error(ErrorCode::UnusableInput, "the file names no programs that work together"_text,
                file.string(), "name a folder that 'together' wrote"_text);
  return entries;
}
} // namespace

TogetherCheck verifyTogether(const std::filesystem::path& folder, const base::RunContext& ctx) {
  const std::vector<Entry> entries = entriesOf(folder);
  TogetherCheck check;
  std::vector<PlanResult> plans;
  std::vector<plan::ReadProgram> programs;
  const double share = 0.8 / static_cast<double>(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const double from = share * static_cast<double>(k);
    const base::RunContext part = ctx.sub(from, from + share);
    project::Job job = project::readJob(entries[k].job, allParameters());
    if (!job.item().part || !job.toolPlan || !job.trajectory)
      throw Error(ErrorCode::UnusableInput, "the job has no motion to verify against"_text,
                  entries[k].job.string(), {});
    check.machines.push_back({entries[k].program, verifyProgram(entries[k].program, job, part)});
    const FoundProgram found = findProgram(entries[k].program, job.report.programs);
    plans.push_back(resultOf(std::move(job)));
    programs.push_back(
        program::readProgram(found.dialect->id, found.files, *plans.back().tooling, part.quiet()));
  }
  std::vector<replay::RunningMachine> machines;
  for (std::size_t k = 0; k < entries.size(); ++k)
    machines.push_back({programs[k], *plans[k].cell, plans[k].tooling->first().process,
                        entries[k].shared_T_world});
  check.replay = replay::runTogether(machines, ctx.sub(0.8, 1.0));
  return check;
}

std::optional<base::Message> refusal(const replay::SharedRun& run) {
  if (const auto& unsafe = run.unsafeStart; unsafe && unsafe->early)
    return base::message("machine {machine} passes the mark in line {line} before machine {other} "
                         "has reached it, if signals are still on or the programs are not started "
                         "at once"_text,
                         unsafe->early->machine + 1, unsafe->early->line, unsafe->early->other + 1);
  if (const auto& stuck = run.clock.stuck)
    return base::message("machine {machine} waits in line {line} for a mark that the other does "
                         "not reach"_text,
                         stuck->machine + 1, stuck->line);
  if (run.collisions > 0)
    return base::message("collisions of the machines: {count}, first at {time}"_text,
                         run.collisions, base::seconds(run.meetings.front().whenS));
  return std::nullopt;
}

std::optional<base::Message> refusal(const TogetherCheck& check) {
  for (std::size_t k = 0; k < check.machines.size(); ++k) {
    const VerifyResult& alone = check.machines[k].alone;
    for (const plan::Finding& finding : alone.findings)
      if (finding.blocking)
        return base::message("machine {machine}: {reason}"_text, k + 1, plan::reasonOf(finding));
    if (!alone.replay.passed)
      return base::message("machine {machine}: the program is refused"_text, k + 1);
  }
  return refusal(check.replay);
}

} // namespace voluta::pipeline
