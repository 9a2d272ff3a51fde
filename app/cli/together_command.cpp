#include "base/error.h"
#include "cli/run_interruptibly.h"
#include "cli/together_options.h"
#include "cli/verdict_words.h"
#include "pipeline/station_check.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "plan/waypoints.h"

#include <fmt/format.h>

namespace voluta::cli {

namespace {
void sayRun(const replay::SharedRun& run) {
  fmt::print("all programs in one time: {:.0f} s, {} collisions, least distance {:.1f} mm at "
             "{:.0f} s\n",
             run.makespanS, run.collisions, run.minDistanceMm, run.minDistanceAtS);
  for (std::size_t k = 0; k < run.clock.machines.size(); ++k) {
    const replay::MachineClock& clock = run.clock.machines[k];
    fmt::print("machine {}: ends at {:.0f} s, {} marks, waits {:.0f} s\n", k + 1, clock.totalS,
               clock.meetings().size(), clock.waitS());
  }
  for (const replay::Meeting& m : run.meetings)
    fmt::print("at {:.1f} s: {} of machine {} meets {} of machine {} at ({:.0f}, {:.0f}, "
               "{:.0f})\n",
               m.whenS, base::english(m.bodies[0]), m.machines[0] + 1, base::english(m.bodies[1]),
               m.machines[1] + 1, m.where.x(), m.where.y(), m.where.z());
}

void sayRests(const pipeline::StationResult& result) {
  for (std::size_t k = 0; k < result.plans.size(); ++k) {
    const project::Job& job = result.plans[k].job;
    const std::size_t first = plan::waypointAhead(*job.trajectory, job.resumedAt);
    if (job.resumedAt == 0 || first == plan::kNoWaypoint)
      continue;
    const double printed = job.trajectory->extrudedMm3[job.resumedAt];
    fmt::print("machine {}: from bead {} of {}; {:.0f} mm3 printed, {:.0f} mm3 left\n", k + 1,
               plan::beadNumber(*job.toolPlan, first), job.toolPlan->paths.size(), printed,
               job.trajectory->extrudedMm3.back() - printed);
  }
}

void sayOrder(const together::Plan& work) {
  std::string segments;
  for (const together::Rests& rests : work.rests)
    segments += (segments.empty() ? "" : ", ") + std::to_string(rests.segments());
  fmt::print("{} segments, {} marks, {:.0f} s planned\n", segments, work.order->meetings.size(),
             work.order->seconds);
}

// Prints notes, and the first blocking finding as the one-line reason: of safety, if there is one.
ExitCode concluded(const plan::Findings& findings) {
  for (const plan::Finding& finding : findings)
    if (!finding.blocking)
      fmt::print("note: {}\n", plan::englishReason(finding));
  const plan::Finding* first = pipeline::firstBlocking(findings);
  if (!first)
    return kDone;
  fmt::print(stderr, "{}{}{} ({})\n", amberWords(*first), plan::englishReason(*first),
             placeWords(*first), plan::englishRemedy(*first));
  return kNotAll;
}

[[noreturn]] void wrongUse(base::Message what, base::Message help) {
  throw base::Error(base::ErrorCode::Usage, std::move(what), {}, std::move(help));
}

void requireUsable(const TogetherOptions& options) {
  if (options.jobs.empty())
    wrongUse("two jobs or more are needed"_text,
             "give job.voluta of each machine, station.voluta of all, or --verify"_text);
  if (options.folder.empty())
    wrongUse("no folder for the results"_text, "give -o DIR"_text);
}

// Returns the station of the options: read from one file, or made from a job for each machine.
project::Station stationOf(const TogetherOptions& options) {
  project::Station station;
  for (const std::filesystem::path& file : options.jobs) {
    project::Station read = pipeline::plannedStation(file);
    if (read.machines.size() > 1 && options.jobs.size() > 1)
      wrongUse(base::message("{file} is a station of {machines} machines"_text, file.string(),
                             read.machines.size()),
               "give it alone, or job.voluta of each machine"_text);
    if (options.jobs.size() == 1)
      station.rules = read.rules;
    for (project::Machine& machine : read.machines)
      station.machines.push_back(std::move(machine));
  }
  const bool isOneFile = options.jobs.size() == 1;
  if (isOneFile && station.machines.size() < 2)
    wrongUse("two jobs or more are needed"_text, "give job.voluta of each machine"_text);
  if (!options.resumed.empty() && !isOneFile)
    wrongUse("only a station is resumed"_text, "give its station.voluta"_text);
  if (!isOneFile && options.places.size() + 1 != station.machines.size())
    wrongUse(base::message("{jobs} jobs with {places} places"_text, options.jobs.size(),
                           options.places.size()),
             "give --place for each job but the first"_text);
  if (isOneFile && !options.places.empty() && options.places.size() + 1 != station.machines.size())
    wrongUse(
        base::message("{machines} machines with {places} places"_text, station.machines.size(),
                      options.places.size()),
        "give --place for each machine but the first, or none to keep those of the station"_text);
  for (std::size_t k = 0; k < options.places.size(); ++k)
    station.machines[k + 1].shared_T_world = options.places[k];
  station.rules.clearanceMm = options.clearanceMm.value_or(station.rules.clearanceMm);
  station.rules.pauseInBeadsS = options.pauseInBeadsS.value_or(station.rules.pauseInBeadsS);
  return station;
}

pipeline::StationResult planned(const TogetherOptions& options, const base::RunContext& ctx) {
  project::Station station = stationOf(options);
  return options.resumed.empty() ? pipeline::planStation(std::move(station), ctx)
                                 : pipeline::resumeStation(std::move(station), options.resumed,
                                                           options.jobs.front().parent_path(), ctx);
}
} // namespace

ExitCode togetherCommand(const TogetherOptions& options) {
  requireUsable(options);
  if (!options.resumed.empty())
    keepStoppedPrint(options.jobs.front(), options.folder, options.replace);
  ResultFolder staged(options.folder, pipeline::FolderKind::Together, options.replace);
  auto outcome = runInterruptibly(
      [options, inside = staged.path()](const base::RunContext& ctx) {
        pipeline::StationResult result = planned(options, ctx.sub(0.0, 0.97));
        pipeline::writeStationOutputs(result, inside, ctx.sub(0.97, 1.0));
        return result;
      },
      options.threads, progressSink(options.progress), [&] { staged.discard(); });
  endProgress(options.progress);
  const auto result = settled(std::move(outcome), staged);
  if (!result)
    return kCancelled;
  sayRests(*result);
  if (result->work.order)
    sayOrder(result->work);
  if (result->replay)
    sayRun(*result->replay);
  return concluded(result->findings);
}

ExitCode verifyTogetherCommand(const TogetherOptions& options) {
  auto outcome = runInterruptibly(
      [folder = options.verified](const base::RunContext& ctx) {
        return pipeline::verifyStation(folder, ctx);
      },
      options.threads, progressSink(options.progress), [] {});
  endProgress(options.progress);
  const auto check = endedWith(std::move(outcome));
  if (!check)
    return kCancelled;
  for (std::size_t k = 0; k < check->programs.size(); ++k) {
    const pipeline::VerifyResult& alone = check->alone[k];
    fmt::print("{}: {} ({})\n", check->programs[k].string(),
               verdictWords(pipeline::verdictOf(alone)), alone.format);
    for (const plan::Finding& f : alone.findings)
      if (f.blocking)
        fmt::print("{}{}: {}\n", amberWords(f), plan::reportId(f), plan::englishReason(f));
  }
  sayRun(check->replay);
  return concluded(check->findings);
}

} // namespace voluta::cli
