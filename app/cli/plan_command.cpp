#include "cli/commands.h"
#include "cli/run_interruptibly.h"
#include "cli/verdict_words.h"
#include "pictures/job_picture.h"
#include "pipeline/outputs.h"
#include "pipeline/search_texts.h"
#include "plan/finding_kinds.h"
#include "project/shown_figures.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <string_view>

namespace voluta::cli {

std::string moreFindings(std::size_t more) {
  return more == 0 ? std::string() : fmt::format("; {} more finding{}", more, more == 1 ? "" : "s");
}

void sayBlocker(const plan::Findings& findings,
                const std::function<std::string(const plan::Finding&)>& nameOf, bool isReleased) {
  const plan::Finding* first = pipeline::firstBlocking(findings);
  if (!first)
    return;
  const auto blocking =
      static_cast<std::size_t>(std::ranges::count_if(findings, &plan::Finding::blocking));
  fmt::print(stderr, "{}{}: {}{}{} ({}){}\n", isReleased ? amberWords(*first) : "",
             plan::stageName(plan::stageOf(*first)), nameOf(*first), plan::englishReason(*first),
             placeWords(*first), plan::englishRemedy(*first),
             blocking > 1 ? moreFindings(blocking - 1) + " in report.json" : "");
}

namespace {
// Returns "kitten.stl: " for a finding about one of several parts.
std::string partOf(const plan::Finding& finding, const project::Report& report) {
  return finding.item < 0 ? std::string()
                          : report.item(static_cast<std::size_t>(finding.item)).model.file + ": ";
}

// Prints programs that were asked for and are not written although the plan may pass.
void sayMissingPrograms(const plan::Findings& findings) {
  using enum plan::FindingKind;
  for (const plan::Finding& f : findings)
    if (!f.blocking &&
        (f.kind == ForeignRefused || f.kind == FormatRefused || f.kind == ProgramRefused))
      fmt::print("not written: {} ({})\n", plan::englishReason(f), plan::englishRemedy(f));
}

// Prints how one part is built. `name`: empty for the only part.
void sayItem(const project::ItemReport& item, const std::string& name) {
  for (const base::Message& rejected : pipeline::rejectedTexts(item))
    fmt::print("{}Rejected: {}\n", name, base::english(rejected));
  if (!item.tried.empty())
    fmt::print("{}{}\n", name, base::english(pipeline::chosenText(item)));
  const project::DecompositionReport& d = item.decomposition;
  fmt::print("{}mode {}; ", name, d.mode);
  if (d.voxels > 0)
    fmt::print("{} voxels, {} missed; ", d.voxels, d.missedAfterSupports);
  if (!d.pieceList.empty())
    fmt::print("{} pieces, {:.1f} of {:.1f} mm2 risky; ", d.pieces, d.riskyAreaMm2,
               d.riskyAreaBeforeMm2);
  fmt::print("{} layers", item.layers.count);
}

void sayResult(const project::Report& r) {
  for (const project::ItemReport& item : r.items) {
    sayItem(item, r.items.size() > 1 ? item.model.file + ": " : std::string());
    fmt::print("{}", &item == &r.items.back() ? "; " : "\n");
  }
  fmt::print("{} waypoints, {:.0f} s", r.toolpath.waypoints, r.motion.durationS);
  if (r.motion.toolChanges > 0)
    fmt::print(", {} tool change{}", r.motion.toolChanges, r.motion.toolChanges == 1 ? "" : "s");
  fmt::print("\n");
  const project::ReplayReport replay = project::shownFigures(r.replay);
  // A format that refuses the motion has no figures.
  const bool isWritten =
      replay.massRatio > 0.0 ||
      std::ranges::none_of(
          r.programs, [](const project::ProgramReport& program) { return program.files.empty(); });
  if (!replay.thresholds.quality.empty() && !isWritten)
    fmt::print("replay {}: not written\n", verdictWords(pipeline::verdictOf(r)));
  else if (!replay.thresholds.quality.empty()) // of a program that was judged
    fmt::print(
        "replay {}: covered {:.4f}, thin {:.4f}, unsupported {:.4f}, overfill {:.4f}, mass {:.4f}, "
        "{} collisions, deviation {:.4f} mm\n",
        verdictWords(pipeline::verdictOf(r)), replay.coveredFraction, replay.thinFraction,
        replay.unsupportedFraction, replay.overfillFraction, replay.massRatio, replay.collisions,
        replay.maxDeviationMm);
}

// Prints how far a bead hangs free, even where its share of the part is small.
void sayHangingBeads(const plan::Findings& findings) {
  using enum plan::FindingKind;
  for (const plan::Finding& f : findings)
    if (f.kind == LongBridge || f.kind == GivenLongBridge)
      fmt::print("note: {}{}\n", plan::englishReason(f), placeWords(f));
}

// Returns the programs with verification reports in `folder` that no file of `staged` replaces.
std::vector<std::string> leftOver(const std::filesystem::path& folder,
                                  const std::filesystem::path& staged) {
  constexpr std::string_view kProof = ".proof.json";
  std::vector<std::string> programs;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    std::string name = entry.path().filename().string();
    if (!name.ends_with(kProof))
      continue;
    name.resize(name.size() - kProof.size());
    if (std::filesystem::exists(folder / name) && !std::filesystem::exists(staged / name))
      programs.push_back(name);
  }
  std::ranges::sort(programs);
  return programs;
}

void sayLeftOver(const std::vector<std::string>& programs) {
  for (const std::string& name : programs)
    fmt::print("of an earlier plan, NOT of this one: {} and its reports; delete them\n", name);
}
} // namespace

ExitCode reportingCommand(const ReportingWork& work, const std::filesystem::path& folder,
                          bool replace, int threads, ProgressStyle progress,
                          const std::shared_ptr<const base::Message>& title) {
  ResultFolder staged(folder, pipeline::FolderKind::Plan, replace);
  auto outcome = runInterruptibly(
      [work, inside = staged.path()](const base::RunContext& ctx) { return work(inside, ctx); },
      threads, progressSink(progress, title), [&] { staged.discard(); });
  endProgress(progress);
  const std::vector<std::string> old = leftOver(folder, staged.path());
  const auto report = settled(std::move(outcome), staged);
  if (!report)
    return kCancelled;
  sayResult(*report);
  sayMissingPrograms(report->findings);
  sayHangingBeads(report->findings);
  sayLeftOver(old);
  sayBlocker(
      report->findings, [&](const plan::Finding& finding) { return partOf(finding, *report); },
      !report->programs.empty() && !pipeline::isRefused(pipeline::verdictOf(*report)));
  return pipeline::nothingBlocks(*report) ? kDone : kNotAll;
}

ExitCode planCommand(const PlanOptions& options) {
  const auto trying = std::make_shared<base::Message>();
  return reportingCommand(
      [options, trying](const std::filesystem::path& folder, const base::RunContext& ctx) {
        const pipeline::PlanRequest request =
            withParts(options.request, options.plate, ctx.sub(0.0, 0.01));
        const auto onStrategy = [&](const pipeline::StrategyProgress& strategy) {
          *trying = pipeline::tryingText(strategy);
        };
        pipeline::PlanResult result =
            pipeline::planPart(request, ctx.sub(0.01, 0.97), nullptr, {.onStrategy = onStrategy});
        *trying = {};
        pipeline::writeOutputs(result, folder, ctx.sub(0.97, 1.0),
                               {.pictures = pictures::proofPictures});
        return result.job.report;
      },
      options.folder, options.replace, options.threads, options.progress, trying);
}

} // namespace voluta::cli
