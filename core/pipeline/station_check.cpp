#include "pipeline/station_check.h"

#include "base/error.h"
#include "base/staged_folder.h"
#include "pipeline/placed_programs.h"
#include "pipeline/plan_verdict.h"
#include "pipeline/program_files.h"
#include "pipeline/station_findings.h"
#include "pipeline/station_plan.h"
#include "plan/marks.h"
#include "program/dialect.h"

#include <algorithm>
#include <string>
#include <utility>

namespace voluta::pipeline {

namespace {
using base::Error;
using base::ErrorCode;

} // namespace

StationCheck verifyStation(const std::filesystem::path& folder, const base::RunContext& ctx) {
  const bool isFolder = std::filesystem::is_directory(folder);
  const std::filesystem::path file = isFolder ? folder / project::kStationFile : folder;
  project::Station station = plannedStation(file);
  const std::size_t count = station.machines.size();
  if (count < 2 || count > plan::kMaxMachines)
    throw Error(ErrorCode::UnusableInput, "the project is not of machines that work together"_text,
                file.string(), "name a folder that 'together' wrote"_text);
  StationCheck check;
  std::vector<PlanResult> plans;
  std::vector<plan::ReadProgram> read;
  std::vector<Eigen::Isometry3d> places;
  const double share = 0.8 / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double from = share * static_cast<double>(k);
    const base::RunContext part = ctx.sub(from, from + share);
    project::Job& job = station.machines[k].job;
    const std::filesystem::path program =
        firstProgramIn(file.parent_path() / machineFolder(k), job.report.programs);
    check.programs.push_back(program);
    check.alone.push_back(verifyProgram(program, job, part));
    const VerifyResult& alone = check.alone.back();
    if (auto finding = machineFinding(k, verdictOf(alone), alone.findings))
      check.findings.push_back(std::move(*finding));
    const FoundProgram found = findProgram(program, job.report.programs);
    plans.push_back(resultOf(std::move(job)));
    places.push_back(station.machines[k].shared_T_world);
    read.push_back(
        program::readProgram(found.dialect->id, found.files, plans.back().tooling(), part.quiet()));
  }
  check.replay = replay::runTogether(placedPrograms(read, plans, places), ctx.sub(0.8, 1.0));
  std::ranges::copy(runFindings(check.replay), std::back_inserter(check.findings));
  return check;
}

} // namespace voluta::pipeline
