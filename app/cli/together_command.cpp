#include "base/error.h"
#include "base/staged_folder.h"
#include "cli/run_interruptibly.h"
#include "cli/together_options.h"
#include "pipeline/own_folder.h"
#include "pipeline/together_check.h"
#include "plan/finding_kinds.h"

#include <fmt/format.h>

namespace voluta::cli {

namespace {
void sayRun(const replay::SharedRun& run) {
  fmt::print("all programs in one time: {:.0f} s, {} collisions, least distance {:.1f} mm at "
             "{:.0f} s\n",
             run.makespanS, run.collisions, run.leastDistanceMm, run.leastAtS);
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

void sayOrder(const together::Plan& work) {
  std::string segments;
  for (const together::Rests& rests : work.rests)
    segments += (segments.empty() ? "" : ", ") + std::to_string(rests.segments());
  fmt::print("{} segments, {} marks, {:.0f} s planned\n", segments, work.order->meetings.size(),
             work.order->seconds);
}

ExitCode concluded(const std::optional<base::Message>& refusal) {
  if (refusal)
    fmt::print(stderr, "{}\n", base::english(*refusal));
  return refusal ? kNotAll : kDone;
}

void requireUsable(const TogetherOptions& options) {
  const auto usage = [](base::Message what, base::Message help) {
    throw base::Error(base::ErrorCode::Usage, std::move(what), {}, std::move(help));
  };
  if (options.jobs.size() < 2)
    usage("two jobs or more are needed"_text, "give job.voluta of each machine, or --verify"_text);
  if (options.places.size() + 1 != options.jobs.size())
    usage(base::message("{jobs} jobs with {places} places"_text, options.jobs.size(),
                        options.places.size()),
          "give --place for each job but the first"_text);
  if (options.folder.empty())
    usage("no folder for the results"_text, "give -o DIR"_text);
}
} // namespace

ExitCode togetherCommand(const TogetherOptions& options) {
  requireUsable(options);
  if (!options.replace)
    pipeline::requireOwnFiles(options.folder, pipeline::FolderKind::Together);
  base::StagedFolder staged(options.folder);
  auto outcome = runInterruptibly(
      [options, inside = staged.path()](const base::RunContext& ctx) {
        pipeline::TogetherRequest request;
        request.options = options.limits;
        for (std::size_t k = 0; k < options.jobs.size(); ++k)
          request.machines.push_back(
              {pipeline::jobToJoin(options.jobs[k]),
               k == 0 ? Eigen::Isometry3d::Identity() : options.places[k - 1]});
        pipeline::TogetherResult result =
            pipeline::planTogether(std::move(request), ctx.sub(0.0, 0.97));
        pipeline::writeTogether(result, inside, ctx.sub(0.97, 1.0));
        return result;
      },
      options.threads, progressSink(options.progress), [&] { staged.discard(); });
  endProgress(options.progress);
  const auto result = settled(std::move(outcome), staged, options.folder);
  if (!result)
    return kCancelled;
  for (const base::Message& note : result->notes)
    fmt::print("note: {}\n", base::english(note));
  if (result->work.order)
    sayOrder(result->work);
  if (result->replay)
    sayRun(*result->replay);
  return concluded(pipeline::refusal(*result));
}

ExitCode verifyTogetherCommand(const TogetherOptions& options) {
  auto outcome = runInterruptibly(
      [folder = options.verified](const base::RunContext& ctx) {
        return pipeline::verifyTogether(folder, ctx);
      },
      options.threads, progressSink(options.progress), [] {});
  endProgress(options.progress);
  const auto check = endedWith(std::move(outcome));
  if (!check)
    return kCancelled;
  for (const pipeline::CheckedMachine& machine : check->machines) {
    fmt::print("{}: {} ({})\n", machine.program.string(),
               machine.alone.replay.passed ? "passed" : "refused", machine.alone.format);
    for (const plan::Finding& f : machine.alone.findings)
      if (f.blocking)
        fmt::print("{}: {}\n", plan::reportId(f), plan::englishReason(f));
  }
  sayRun(check->replay);
  return concluded(pipeline::refusal(*check));
}

} // namespace voluta::cli
