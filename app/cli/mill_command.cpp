#include "cli/mill_command.h"

#include "base/files.h"
#include "base/staged_folder.h"
#include "cli/option_texts.h"
#include "cli/run_interruptibly.h"
#include "pipeline/mill_job.h"
#include "pipeline/mill_part.h"
#include "pipeline/own_folder.h"
#include "project/loaded_part.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace voluta::cli {

namespace {
using Json = nlohmann::ordered_json;

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

// The part's notes of its reader and its repair, and defects that remain, a sentence each.
std::vector<std::string> notesOf(const project::LoadedPart& part) {
  std::vector<std::string> notes = base::english(part.notes);
  for (const base::Message& defect : part.remains)
    notes.push_back(base::english(defect));
  return notes;
}

Json reportOf(const MillOptions& options, const pipeline::MilledPart& milled,
              const std::vector<std::string>& notes) {
  const milling::MillVerdict& v = milled.verdict;
  const milling::MillRule& rule = options.order.rule;
  const Eigen::Vector3d size = milled.plan.block.sizes();
  const Eigen::Quaterniond& turn = milled.laid.turn;
  Json refusals = Json::array();
  for (const milling::MillDefect& d : v.refusals)
    refusals.push_back({{"line", d.line}, {"reason", base::english(d.reason)}});
  Json report{{"part", options.part}, {"notes", notes}, {"material", rule.data.id}};
  if (options.order.layDown)
    report["laidDown"] = {{"quaternion", {turn.w(), turn.x(), turn.y(), turn.z()}},
                          {"rounds", milled.laid.rounds},
                          {"scrapBeforeMm3", milled.laid.scrapBeforeMm3},
                          {"scrapMm3", milled.laid.scrapMm3}};
  report.update(Json{{"blockMm", {size.x(), size.y(), size.z()}},
                     {"rpm", rule.data.rpm},
                     {"feedMmPerMin", milling::feedMmPerMin(rule.cutter, rule.data)},
                     {"lineMm", rule.distanceMm()},
                     {"finePassMm", milling::finePassMm(rule.cutter, rule.data)},
                     {"moves", milled.motions},
                     {"passed", v.passed},
                     {"durationS", v.seconds},
                     {"removedMm3", v.removedMm3},
                     {"deepestMm", v.deepestMm},
                     {"residueMm", v.residueMm},
                     {"complete", v.isComplete()},
                     {"leftMm3", v.left.volumeMm3},
                     {"leftThickestMm", v.left.thickestMm},
                     {"leftAtMm", {v.left.atMm.x(), v.left.atMm.y(), v.left.atMm.z()}},
                     {"cornersMm3", v.left.cornersMm3},
                     {"refusals", std::move(refusals)}});
  return report;
}

struct Milled {
  pipeline::MilledPart part;
  std::vector<std::string> notes; // about the part
};

Milled mill(MillOptions options, const std::filesystem::path& folder, const base::RunContext& ctx) {
  const auto loaded = project::loadPart(options.part, true, ctx.sub(0.0, 0.1));
  options.order.name = loaded->name;
  pipeline::MilledPart milled = pipeline::millPart(*loaded->mesh, options.order, ctx.sub(0.1, 1.0));
  std::vector<std::string> notes = notesOf(*loaded);
  base::writeFile(
      folder / "report.json",
      reportOf(options, milled, notes).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  base::writeFile(folder / pipeline::kMillJobFile,
                  pipeline::writeMillJob(milled.part, options.order));
  if (milled.verdict.passed)
    base::writeFile(folder / "mill.nc", milled.program);
  return {std::move(milled), std::move(notes)};
}

} // namespace

ExitCode millExitCode(const milling::MillVerdict& v) {
  if (!v.passed)
    fmt::print(stderr, "voluta-cli: the program was refused: {} (line {})\n",
               base::english(v.refusals.front().reason), v.refusals.front().line);
  else if (!v.isComplete())
    fmt::print(
        stderr,
        "voluta-cli: {:.0f} mm3 of the block stay in slots, undercuts or holes that should be "
        "free, up to {:.1f} mm high at ({:.1f}, {:.1f}, {:.1f}): use a smaller cutter or a smaller "
        "distance of lines, or turn the part\n",
        v.left.volumeMm3, v.left.thickestMm, v.left.atMm.x(), v.left.atMm.y(), v.left.atMm.z());
  return v.isComplete() ? kDone : kNotAll;
}

namespace {

ExitCode millCommand(MillOptions options) {
  const milling::CuttingData* data = milling::cuttingDataFor(options.material);
  if (!data)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("unknown material '{id}'"_text, options.material), {},
                      base::message("give one of {ids}"_text, materialIds()));
  options.order.rule.data = *data;
  if (!options.replace)
    pipeline::requireOwnFiles(options.folder, pipeline::FolderKind::Milling);
  base::StagedFolder staged(options.folder);
  const auto milled =
      settled(runInterruptibly(
                  [&](const base::RunContext& ctx) { return mill(options, staged.path(), ctx); },
                  options.threads, {}, [&] { staged.discard(); }),
              staged, options.folder);
  if (!milled)
    return kCancelled;
  for (const std::string& note : milled->notes)
    fmt::print("note: {}\n", note);
  const milling::MillVerdict& v = milled->part.verdict;
  fmt::print("{} moves, {:.0f} min, {:.0f} mm3 removed; deepest {:.3f} mm, residue {:.3f} mm, "
             "{:.0f} mm3 in corners and between lines\n",
             milled->part.motions, v.seconds / 60.0, v.removedMm3, v.deepestMm, v.residueMm,
             v.left.cornersMm3);
  return millExitCode(v);
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
