#include "base/staged_folder.h"
#include "cli/run_interruptibly.h"
#include "cli/together_options.h"

#include <fmt/format.h>

namespace voluta::cli {

namespace {
void sayRun(const pipeline::TogetherResult& result) {
  const together::Schedule& schedule = *result.work.schedule;
  fmt::print("{} and {} segments, {} phases, {} marks, {:.0f} s planned\n",
             result.work.a.segments(), result.work.b.segments(), schedule.phases.size(),
             schedule.marks(), schedule.seconds);
  if (!result.replay)
    return;
  const replay::TwoMachines& run = *result.replay;
  fmt::print("both programs in one time: {:.0f} s, waits {:.0f} s and {:.0f} s, {} collisions, "
             "least distance {:.1f} mm at {:.0f} s\n",
             run.makespanS, run.clock.machines[0].waitS, run.clock.machines[1].waitS,
             run.collisions, run.leastDistanceMm, run.leastAtS);
  for (const replay::Meeting& m : run.meetings)
    fmt::print("at {:.1f} s: {} meets {} at ({:.0f}, {:.0f}, {:.0f})\n", m.whenS,
               base::english(m.first), base::english(m.second), m.where.x(), m.where.y(),
               m.where.z());
}

// Prints the one-line reason why the machines cannot work together.
void sayWhyNot(const pipeline::TogetherResult& result) {
  if (result.obstruction)
    fmt::print(stderr, "{}\n", base::english(*result.obstruction));
  else if (!result.replay)
    fmt::print(stderr, "a program was refused, or does not state the arm\n");
  else if (result.replay->clock.stuck)
    fmt::print(stderr, "machine {} waits for a mark that the other does not reach\n",
               result.replay->clock.stuck->machine + 1);
  else if (result.replay->collisions > 0)
    fmt::print(stderr, "the programs collide\n");
  else if (!pipeline::passed(result))
    fmt::print(stderr, "a finding of one of the jobs blocks (see its report.json)\n");
}
} // namespace

ExitCode togetherCommand(const TogetherOptions& options) {
  base::StagedFolder staged(options.folder);
  auto outcome = runInterruptibly(
      [options, inside = staged.path()](const base::RunContext& ctx) {
        pipeline::TogetherRequest request = options.request;
        for (std::size_t k = 0; k < options.jobs.size(); ++k)
          request.jobs[k] = pipeline::jobToJoin(options.jobs[k]);
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
  if (result->work.schedule)
    sayRun(*result);
  sayWhyNot(*result);
  return pipeline::passed(*result) ? kDone : kNotAll;
}

} // namespace voluta::cli
