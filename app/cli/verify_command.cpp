#include "cli/commands.h"
#include "cli/run_interruptibly.h"
#include "plan/finding_kinds.h"

#include <fmt/format.h>

namespace voluta::cli {

ExitCode verifyCommand(const VerifyOptions& options) {
  auto outcome = runInterruptibly(
      [options](const base::RunContext& ctx) {
        return pipeline::verifyProgram(options.program, options.job, ctx);
      },
      options.threads, progressSink(options.progress), [] {});
  endProgress(options.progress);
  const auto ended = endedWith(std::move(outcome));
  if (!ended)
    return kCancelled;
  const pipeline::VerifyResult& result = *ended;
  fmt::print("{}: {} ({}): covered {:.4f}, unsupported {:.4f}, overfill {:.4f}, mass {:.4f}, {} "
             "collisions, {} limit violations, deviation {:.4f} mm\n",
             options.program.string(), result.replay.passed ? "passed" : "refused", result.format,
             result.replay.coveredFraction, result.replay.unsupportedFraction,
             result.replay.overfillFraction, result.replay.massRatio, result.replay.collisions,
             result.replay.limitViolations, result.replay.maxDeviationMm);
  const plan::Finding* first = nullptr;
  for (const plan::Finding& f : result.findings) {
    fmt::print("{}: {}\n", plan::reportId(f), plan::englishReason(f));
    if (f.blocking && !first)
      first = &f;
  }
  if (first)
    fmt::print(stderr, "{}: {}\n", options.program.string(), plan::englishReason(*first));
  return result.replay.passed && !first ? kDone : kNotAll;
}

} // namespace voluta::cli
