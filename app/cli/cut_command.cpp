#include "cli/cut_command.h"

#include "base/error.h"
#include "base/files.h"
#include "base/units.h"
#include "cli/run_interruptibly.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "planar/parting/part_cut.h"
#include "project/loaded_part.h"

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace voluta::cli {

namespace {

using planar::Joint;

struct CutOptions {
  std::string part, joint = "none";
  std::vector<double> plane;
  Joint sizes;
  double directionDeg = 0.0;
  std::filesystem::path folder;
  int threads = 1;
};

struct NamedMesh {
  std::string word; // after the name of the part
  geometry::TriangleMesh mesh;
};

const std::map<std::string, Joint::Kind>& jointWords() {
  static const std::map<std::string, Joint::Kind> kWords{{"none", Joint::Kind::None},
                                                         {"dowels", Joint::Kind::Dowels},
                                                         {"pegs", Joint::Kind::Pegs},
                                                         {"dovetail", Joint::Kind::Dovetail}};
  return kWords;
}

planar::Plane planeOf(const std::vector<double>& numbers) {
  const Eigen::Vector3d normal(numbers[0], numbers[1], numbers[2]);
  if (!(normal.norm() > 0.0))
    throw base::Error(base::ErrorCode::Usage, "the normal of the plane is zero"_text, {},
                      "give a normal and a distance, such as 0,0,1,20"_text);
  return {normal.normalized(), numbers[3]};
}

std::vector<NamedMesh> cutMeshes(const CutOptions& options, const base::RunContext& ctx) {
  const auto loaded = project::loadPart(options.part, true, ctx.sub(0.0, 0.3));
  Joint joint = options.sizes;
  joint.kind = jointWords().at(options.joint);
  joint.directionRad = base::degreesToRadians(options.directionDeg);
  planar::PartHalves halves =
      planar::cutPart(*loaded->mesh, planeOf(options.plane), joint, ctx.sub(0.3, 1.0));
  std::vector<NamedMesh> made{{"A", std::move(halves.below)}, {"B", std::move(halves.above)}};
  for (std::size_t i = 0; i < halves.dowels.size(); ++i)
    made.push_back({fmt::format("dowel {}", i + 1), std::move(halves.dowels[i])});
  return made;
}

std::vector<NamedMesh> splitMeshes(const CutOptions& options, const base::RunContext& ctx) {
  const auto loaded = project::loadPart(options.part, true, ctx.sub(0.0, 0.5));
  std::vector<NamedMesh> made;
  for (geometry::TriangleMesh& body : planar::bodiesOf(*loaded->mesh))
    made.push_back({std::to_string(made.size() + 1), std::move(body)});
  return made;
}

ExitCode writeMeshes(const CutOptions& options,
                     std::vector<NamedMesh> (*make)(const CutOptions&, const base::RunContext&)) {
  const auto made = endedWith(runInterruptibly(
      [&](const base::RunContext& ctx) { return make(options, ctx); }, options.threads, {}, [] {}));
  if (!made)
    return kCancelled;
  const std::string name =
      std::filesystem::path(options.part.substr(options.part.find(':') + 1)).stem().string();
  std::error_code failed;
  std::filesystem::create_directories(options.folder, failed); // writing reports a failure
  for (const NamedMesh& mesh : *made) {
    const auto file = options.folder / (name + " " + mesh.word + ".stl");
    base::writeFile(file, geometry::writeStl(mesh.mesh));
    const Eigen::Vector3d size = geometry::bounds(mesh.mesh).sizes();
    fmt::print("{}: {:.1f} x {:.1f} x {:.1f} mm, {:.1f} cm3\n", file.string(), size.x(), size.y(),
               size.z(), geometry::volume(mesh.mesh) / 1000.0);
  }
  return kDone;
}

void addPartAndFolder(CLI::App& command, CutOptions& options) {
  command.add_option("PART", options.part, "mesh file, in mm, or sample:NAME")->required();
  command.add_option("-o", options.folder, "folder for the STL files")->required();
  command.add_option("--threads", options.threads, "threads to use")->check(CLI::Range(1, 256));
}

} // namespace

void addCut(CLI::App& app, std::function<ExitCode()>& run, int threads) {
  auto options = std::make_shared<CutOptions>();
  options->threads = threads;
  CLI::App* cut = app.add_subcommand("cut", "cut a part in two with a plane, with a joint");
  addPartAndFolder(*cut, *options);
  cut->add_option("--plane", options->plane,
                  "NX,NY,NZ,D: its normal, and its distance from the origin along it [mm]")
      ->required()
      ->delimiter(',')
      ->expected(4);
  std::vector<std::string> words;
  for (const auto& [word, kind] : jointWords())
    words.push_back(word);
  cut->add_option(
         "--joint", options->joint,
         "none (default), loose dowels, pegs of the lower half, or a dovetail of the lower half")
      ->check(CLI::IsMember(words));
  Joint& sizes = options->sizes;
  cut->add_option("--size", sizes.sizeMm, "diameter of a pin, width of a dovetail [mm]")
      ->check(CLI::Range(0.5, 500.0));
  cut->add_option("--depth", sizes.depthMm, "depth of a pin, height of a dovetail [mm]")
      ->check(CLI::Range(0.5, 500.0));
  cut->add_option("--clearance", sizes.clearanceMm, "gap on every side [mm]")
      ->check(CLI::Range(0.0, 5.0));
  cut->add_option("--number", sizes.count, "pins in each section")->check(CLI::Range(1, 12));
  cut->add_option("--direction", options->directionDeg,
                  "in which a dovetail slides, in degrees from the horizontal");
  cut->callback([options, &run] { run = [options] { return writeMeshes(*options, cutMeshes); }; });
}

void addSplit(CLI::App& app, std::function<ExitCode()>& run, int threads) {
  auto options = std::make_shared<CutOptions>();
  options->threads = threads;
  CLI::App* split = app.add_subcommand("split", "write each body of a part to a file of its own");
  addPartAndFolder(*split, *options);
  split->callback(
      [options, &run] { run = [options] { return writeMeshes(*options, splitMeshes); }; });
}

} // namespace voluta::cli
