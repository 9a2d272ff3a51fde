#include "pipeline/station_resume.h"

#include "base/error.h"
#include "pipeline/program_files.h"
#include "pipeline/station_findings.h"
#include "plan/finding_kinds.h"

namespace voluta::pipeline {

namespace {
// `folder`: the machine's.
ResumeRequest requestOf(const ResumePlace& place, const project::Job& job,
                        const std::filesystem::path& folder) {
  ResumeRequest request;
  request.bead = place.bead;
  request.line = place.line;
  if (place.line)
    request.program = firstProgramIn(folder, job.report.programs);
  return request;
}

// Returns the job with the motion of its rest. Errors name the machine, counted from 0.
project::Job restOf(project::Job job, const ResumePlace& place, std::size_t machine,
                    const std::filesystem::path& folder, const base::RunContext& ctx) {
  const std::string name = machineFolder(machine);
  requireMotion(job, name);
  try {
    const ResumeRequest request = requestOf(place, job, folder / name);
    PlanResult planned = resultOf(std::move(job));
    const std::size_t point = resumePointOf(request, planned, ctx.sub(0.0, 0.3));
    planned.job = withoutMarks(std::move(planned.job));
    return restMotion(std::move(planned), point, ctx.sub(0.3, 1.0));
  } catch (const base::Error& error) {
    if (!error.context().empty())
      throw;
    throw base::Error(error.code(), error.message(), name, error.remedy());
  }
}
} // namespace

StationResult resumeStation(project::Station station, const std::vector<ResumePlace>& places,
                            const std::filesystem::path& folder, const base::RunContext& ctx) {
  const std::size_t count = station.machines.size();
  if (places.size() != count)
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("{places} places for {machines} machines"_text, places.size(), count), {},
        "give a bead or a line for each machine, in their order"_text);
  plan::Findings refused;
  const double share = 0.4 / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    project::Job& job = station.machines[k].job;
    const base::RunContext own =
        ctx.sub(share * static_cast<double>(k), share * static_cast<double>(k + 1));
    job = restOf(std::move(job), places[k], k, folder, own);
    // What a part lacks does not keep the machines from going on.
    const plan::Finding* finding = firstBlocking(job.report.findings);
    if (finding && (!job.trajectory || plan::blocksRunning(*finding)))
      refused.push_back(machineFinding(k, plan::reasonOf(*finding)));
  }
  if (refused.empty())
    return planStation(std::move(station), ctx.sub(0.4, 1.0));
  StationResult result;
  result.rules = station.rules;
  result.findings = std::move(refused);
  for (project::Machine& machine : station.machines) {
    result.names.push_back(std::move(machine.name));
    result.shared_T_world.push_back(machine.shared_T_world);
    result.plans.push_back(resultOf(std::move(machine.job)));
  }
  return result;
}

} // namespace voluta::pipeline
