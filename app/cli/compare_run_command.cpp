#include "base/files.h"
#include "cli/commands.h"
#include "cli/new_file.h"
#include "cli/run_interruptibly.h"

#include <cmath>
#include <fmt/format.h>

namespace voluta::cli {

namespace {
using record::ErrorKind;
using record::ErrorPlace;
using record::RunComparison;

std::string valueText(const ErrorPlace& place) {
  const bool isLength = place.kind == ErrorKind::Path || place.kind == ErrorKind::Missing;
  return isLength ? fmt::format("{:.3f} mm", place.worst)
                  : fmt::format("{:+.2f} %", 100.0 * place.worst);
}

void sayFigures(const RunComparison& c) {
  fmt::print(
      "beside the plan from {:.2f} s to {:.2f} s of the record; {:.1f} of {:.1f} mm of beads\n",
      c.beginS, c.endS, c.printedMm, c.beadsMm);
  fmt::print("path: mean {:.3f} mm, greatest {:.3f} mm\n", c.pathMeanMm, c.pathMaxMm);
  fmt::print("speed: mean {:+.2f} %, from {:+.2f} to {:+.2f} %\n", 100.0 * c.speedMean,
             100.0 * c.speedSlowest, 100.0 * c.speedFastest);
  fmt::print("flow ({}): mean {:+.2f} %, from {:+.2f} to {:+.2f} %\n",
             c.flowIsRecorded ? "recorded" : "planned rate at the recorded speed",
             100.0 * c.flowMean, 100.0 * c.flowLowest, 100.0 * c.flowHighest);
  if (c.missingMm > 0.0)
    fmt::print("passed over: {:.1f} mm of beads\n", c.missingMm);
}

// The worst places of each kind.
void sayPlaces(const RunComparison& c, std::size_t limit) {
  std::size_t ofKind = 0;
  for (std::size_t i = 0; i < c.places.size(); ++i) {
    const ErrorPlace& place = c.places[i];
    ofKind = i > 0 && c.places[i - 1].kind == place.kind ? ofKind + 1 : 0;
    if (ofKind == limit)
      fmt::print("{}: further places\n", base::english(record::kindName(place.kind)));
    if (ofKind >= limit)
      continue;
    fmt::print("{}: {} at {:.2f} s of the plan, {:.2f} s of the record, over {:.1f} mm, at "
               "({:.2f}, {:.2f}, {:.2f})\n",
               base::english(record::kindName(place.kind)), valueText(place), place.planS,
               place.recordS, place.lengthMm, place.where.x(), place.where.y(), place.where.z());
  }
}
} // namespace

ExitCode compareRunCommand(const CompareRunOptions& options) {
  requireNewFile(options.curve, options.replace);
  auto outcome = runInterruptibly(
      [options](const base::RunContext& ctx) {
        return pipeline::compareRun(options.job, options.record, options.tolerances, ctx);
      },
      options.threads, progressSink(options.progress), [] {});
  endProgress(options.progress);
  const auto ended = endedWith(std::move(outcome));
  if (!ended)
    return kCancelled;
  const RunComparison& comparison = ended->comparison;
  fmt::print("{} ({})\n", options.record.string(), ended->format);
  sayFigures(comparison);
  sayPlaces(comparison, options.places);
  if (!options.curve.empty())
    base::writeFile(options.curve, record::curveCsv(comparison.curve));
  const std::string verdict = base::english(record::verdictSentence(comparison));
  if (comparison.verdict() == record::RunVerdict::Within) {
    fmt::print("{}\n", verdict);
    return kDone;
  }
  fmt::print(stderr, "{}: {}\n", options.record.string(), verdict);
  return kNotAll;
}

} // namespace voluta::cli
