#include "cli/mill_command.h"

#include "cli/commands.h"
#include "cli/option_texts.h"
#include "cli/run_interruptibly.h"
#include "pipeline/mill_report.h"
#include "project/loaded_part.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>

namespace voluta::cli {

namespace {
struct MillOptions {
  std::string part, material = "soft-plastic";
  pipeline::MillOrder order;
  std::filesystem::path folder;
  bool replace = false; // files of the folder that are not of such a job
  int threads = 1;
};

std::string materialIds() {
  std::string ids;
  for (const milling::CuttingData& data : milling::cuttingData())
    ids += (ids.empty() ? "" : ", ") + std::string(data.id);
  return ids;
}

project::MilledReport mill(MillOptions options, const std::filesystem::path& folder,
                           const base::RunContext& ctx) {
  const auto loaded = project::loadPart(options.part, true, ctx.sub(0.0, 0.1));
  options.order.name = loaded->name;
  const pipeline::MilledPart milled =
      pipeline::millPart(*loaded->mesh, options.order, ctx.sub(0.1, 1.0));
  project::MilledReport report = pipeline::millReport(*loaded, options.order, milled);
  report.threads = options.threads;
  pipeline::writeMilled(report, options.order, milled, folder);
  return report;
}

void sayResult(const project::MilledReport& report) {
  for (const base::Message& note : report.model.repairs)
    fmt::print("note: {}\n", base::english(note));
  for (const plan::Finding& finding : report.findings)
    if (!finding.blocking)
      fmt::print("note: {}\n", plan::englishReason(finding));
  const project::MillingReport& m = report.milling;
  fmt::print("{} moves, {:.0f} min, {:.0f} mm3 removed; deepest {:.3f} mm, residue {:.3f} mm, "
             "{:.0f} mm3 in corners and between lines\n",
             m.moves, report.replay.controllerDurationS / 60.0, m.removedMm3, m.deepestMm,
             m.residueMm, m.cornersMm3);
  sayBlocker(
      report.findings, [](const plan::Finding&) { return std::string(); }, false);
}

ExitCode millCommand(MillOptions options) {
  const milling::CuttingData* data = milling::cuttingDataFor(options.material);
  if (!data)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("unknown material '{id}'"_text, options.material), {},
                      base::message("give one of {ids}"_text, materialIds()));
  options.order.rule.data = *data;
  ResultFolder staged(options.folder, pipeline::FolderKind::Milling, options.replace);
  const auto report =
      settled(runInterruptibly(
                  [&](const base::RunContext& ctx) { return mill(options, staged.path(), ctx); },
                  options.threads, {}, [&] { staged.discard(); }),
              staged);
  if (!report)
    return kCancelled;
  sayResult(*report);
  return report->milling.complete ? kDone : kNotAll;
}

} // namespace

void addMill(CLI::App& app, std::function<ExitCode()>& run, int threads) {
  auto options = std::make_shared<MillOptions>();
  options->threads = threads;
  milling::MillRule& rule = options->order.rule;
  CLI::App* mill = app.add_subcommand("mill", "mill a part out of a block");
  mill->add_option("PART", options->part, "mesh file, in mm")->required();
  mill->add_option("-o,--output", options->folder, "folder for the program and the report")
      ->required();
  mill->add_flag("--replace", options->replace, kReplaceHelp);
  mill->add_option("--cut", options->material, "material of the block: " + materialIds());
  mill->add_option("--cutter", rule.cutter.diameterMm, "diameter of the round cutter [mm]");
  mill->add_option("--teeth", rule.cutter.teeth, "teeth of the cutter");
  mill->add_option("--line", rule.lineMm, "distance of lines [mm]; 0: that of the material");
  mill->add_option("--roughing", rule.roughingMm, "depth of roughing passes [mm]");
  mill->add_option("--gap", rule.acrossMm, "block beyond the part along y [mm]");
  mill->add_option("--anchor", rule.alongMm, "block beyond the part along x [mm]");
  mill->add_option("--skin", rule.skinMm, "block above and below the part [mm]");
  mill->add_option("--clearance", rule.clearanceMm, "height of moves above the block [mm]");
  mill->add_option("--pitch", rule.pitchMm, "cells of the part's map [mm]");
  mill->add_flag("!--as-it-lies", options->order.layDown,
                 "keep the part's orientation; by default the part is laid down first");
  mill->add_option("--threads", options->threads, "threads to use")->check(CLI::Range(1, 256));
  mill->callback([options, &run] { run = [options] { return millCommand(*options); }; });
}

} // namespace voluta::cli
