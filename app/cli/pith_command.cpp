#include "cli/pith_command.h"

#include "base/files.h"
#include "cli/new_file.h"
#include "cli/run_interruptibly.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "planar/pith_body.h"
#include "project/loaded_part.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>

namespace voluta::cli {

namespace {

struct PithOptions {
  std::string part;
  planar::PithRule rule;
  std::filesystem::path file;
  bool replace = false;
  int threads = 1;
};

struct Made {
  planar::PithBody body;
  double partMm3 = 0.0;
};

Made makePith(const PithOptions& options, const base::RunContext& ctx) {
  const auto loaded = project::loadPart(options.part, true, ctx.sub(0.0, 0.2));
  return {planar::pithBody(*loaded->mesh, options.rule, ctx.sub(0.2, 1.0)),
          geometry::volume(*loaded->mesh)};
}

ExitCode pithCommand(const PithOptions& options) {
  requireNewFile(options.file, options.replace);
  const auto made = endedWith(
      runInterruptibly([&](const base::RunContext& ctx) { return makePith(options, ctx); },
                       options.threads, {}, [] {}));
  if (!made)
    return kCancelled;
  const planar::PithBody& body = made->body;
  base::writeFile(options.file, geometry::writeStl(body.mesh));
  const double mm3 = geometry::volume(body.mesh);
  fmt::print("{} limbs, {:.1f} mm long, radius {:.2f} to {:.2f} mm, {:.0f} mm3 ({:.0f} % of the "
             "part)\n",
             body.limbs, body.lengthMm, body.minRadiusMm, body.maxRadiusMm, mm3,
             100.0 * mm3 / made->partMm3);
  const std::string file = options.file.string();
  fmt::print("print the pith:        voluta-cli plan {}\n"
             "print the part on it:  voluta-cli plan {} --mode substrate --platform mesh:{}\n",
             file, options.part, file);
  return kDone;
}

} // namespace

void addPith(CLI::App& app, std::function<ExitCode()>& run, int threads) {
  auto options = std::make_shared<PithOptions>();
  options->threads = threads;
  planar::PithRule& rule = options->rule;
  CLI::App* pith = app.add_subcommand(
      "pith", "make the pith of a part: a rod along its skeleton, to be printed first");
  pith->add_option("PART", options->part, "mesh file, in mm, or sample:NAME")->required();
  pith->add_option("-o", options->file, "FILE.stl to write, in the part's coordinates")->required();
  addReplaceFile(*pith, options->replace);
  pith->add_option("--share", rule.share, "radius as a share of the part's radius")
      ->check(CLI::Range(0.05, 0.9));
  pith->add_option("--least", rule.minRadiusMm, "least radius [mm]")
      ->check(CLI::Range(0.1, 1000.0));
  pith->add_option("--branch", rule.branchGain, "share by which it is thicker where it branches")
      ->check(CLI::Range(0.0, 2.0));
  pith->add_option("--threads", options->threads, "threads to use")->check(CLI::Range(1, 256));
  pith->callback([options, &run] { run = [options] { return pithCommand(*options); }; });
}

} // namespace voluta::cli
