#include "base/files.h"
#include "cli/commands.h"
#include "cli/run_interruptibly.h"
#include "cli/verdict_words.h"
#include "pipeline/mill_job.h"
#include "pipeline/plan_verdict.h"
#include "plan/finding_kinds.h"
#include "project/shown_figures.h"

#include <filesystem>
#include <fmt/format.h>
#include <string>

namespace voluta::cli {

namespace {

// Other jobs may be large: only the beginning is read.
bool isMillJobFile(const std::filesystem::path& file) {
  constexpr std::size_t kBegin = 64;
  return pipeline::isMillJob(base::beginningOf(file, kBegin));
}

// Prints the findings on a program, and to stderr the first one that blocks: of safety, if there is
// one.
void sayFindings(const std::filesystem::path& program, const plan::Findings& findings) {
  for (const plan::Finding& f : findings)
    fmt::print("{}{}: {}{}\n", amberWords(f), plan::reportId(f), plan::englishReason(f),
               placeWords(f));
  if (const plan::Finding* first = pipeline::firstBlocking(findings))
    fmt::print(stderr, "{}: {}{}{}\n", program.string(), amberWords(*first),
               plan::englishReason(*first), placeWords(*first));
}

ExitCode verifyMilled(const VerifyOptions& options) {
  auto outcome = runInterruptibly(
      [options](const base::RunContext& ctx) {
        const pipeline::MillJob job =
            pipeline::readMillJob(base::readFile(options.job), options.job.string());
        return pipeline::verifyMilling(base::readFile(options.program), job, ctx);
      },
      options.threads, progressSink(options.progress), [] {});
  endProgress(options.progress);
  const auto verdict = endedWith(std::move(outcome));
  if (!verdict)
    return kCancelled;
  fmt::print("{}: {} (milling): {:.0f} mm3 removed, {:.0f} mm3 stay, deepest {:.3f} mm\n",
             options.program.string(), verdict->passed ? "passed" : "refused", verdict->removedMm3,
             verdict->left.volumeMm3, verdict->deepestMm);
  sayFindings(options.program, verdict->findings);
  return verdict->isComplete() ? kDone : kNotAll;
}

} // namespace

ExitCode verifyCommand(const VerifyOptions& options) {
  if (isMillJobFile(options.job))
    return verifyMilled(options);
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
  const project::ReplayReport shown = project::shownFigures(result.replay);
  const pipeline::PlanVerdict verdict = pipeline::verdictOf(result);
  fmt::print("{}: {} ({}): covered {:.4f}, thin {:.4f}, unsupported {:.4f}, overfill {:.4f}, mass "
             "{:.4f}, {} "
             "collisions, {} limit violations, deviation {:.4f} mm\n",
             options.program.string(), verdictWords(verdict), result.format, shown.coveredFraction,
             shown.thinFraction, shown.unsupportedFraction, shown.overfillFraction, shown.massRatio,
             shown.collisions, shown.limitViolations, shown.maxDeviationMm);
  sayFindings(options.program, result.findings);
  return verdict == pipeline::PlanVerdict::Passed ? kDone : kNotAll;
}

} // namespace voluta::cli
