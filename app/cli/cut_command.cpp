#include "cli/cut_command.h"

#include "base/error.h"
#include "base/files.h"
#include "base/staged_folder.h"
#include "base/units.h"
#include "cli/option_texts.h"
#include "cli/run_interruptibly.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "planar/parting/part_cut.h"
#include "project/length_unit.h"
#include "project/loaded_part.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::cli {

namespace {

using planar::Joint;

struct CutOptions {
  std::string part, units = "mm", joint = "none";
  std::vector<double> plane;
  Joint sizes;
  double directionDeg = 0.0;
  std::filesystem::path folder;
  bool replace = false; // the results of an earlier cut
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

// Returns the part in mm.
geometry::TriangleMesh partOf(const CutOptions& options, const base::RunContext& ctx) {
  const double mm = project::lengthUnit(options.units).mm;
  geometry::TriangleMesh mesh = *project::loadPart(options.part, true, ctx)->mesh;
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex *= mm;
  return mesh;
}

std::vector<NamedMesh> cutMeshes(const CutOptions& options, const base::RunContext& ctx) {
  const geometry::TriangleMesh part = partOf(options, ctx.sub(0.0, 0.3));
  Joint joint = options.sizes;
  joint.kind = jointWords().at(options.joint);
  joint.directionRad = base::degreesToRadians(options.directionDeg);
  planar::PartHalves halves =
      planar::cutPart(part, planeOf(options.plane), joint, ctx.sub(0.3, 1.0));
  std::vector<NamedMesh> made{{"A", std::move(halves.below)}, {"B", std::move(halves.above)}};
  for (std::size_t i = 0; i < halves.dowels.size(); ++i)
    made.push_back({fmt::format("dowel {}", i + 1), std::move(halves.dowels[i])});
  return made;
}

std::vector<NamedMesh> splitMeshes(const CutOptions& options, const base::RunContext& ctx) {
  const geometry::TriangleMesh part = partOf(options, ctx.sub(0.0, 0.5));
  std::vector<NamedMesh> made;
  for (geometry::TriangleMesh& body : planar::bodiesOf(part))
    made.push_back({std::to_string(made.size() + 1), std::move(body)});
  return made;
}

bool isNumber(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}
bool isCutWord(std::string_view word) {
  constexpr std::string_view kDowel = "dowel ";
  return word == "A" || word == "B" ||
         (word.starts_with(kDowel) && isNumber(word.substr(kDowel.size())));
}

// A command that makes meshes of a part.
struct MakingCommand {
  std::vector<NamedMesh> (*make)(const CutOptions&, const base::RunContext&);
  bool (*isOwnWord)(std::string_view word); // of a mesh that it may make
};
constexpr MakingCommand kCut{cutMeshes, isCutWord}, kSplit{splitMeshes, isNumber};

std::string fileName(const std::string& part, std::string_view word) {
  return fmt::format("{} {}.stl", part, word);
}

// Returns the results of earlier runs of the command for that part, in order.
std::vector<std::filesystem::path> resultsIn(const std::filesystem::path& folder,
                                             const std::string& part,
                                             const MakingCommand& command) {
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    const std::string stem = entry.path().stem().string();
    if (stem.starts_with(part + ' ') && command.isOwnWord(stem.substr(part.size() + 1)) &&
        entry.path().filename() == fileName(part, stem.substr(part.size() + 1)))
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

// Throws Error{Usage, UnreadableFile, UnusableInput, CannotWrite}.
ExitCode writeMeshes(const CutOptions& options, const MakingCommand& command) {
  const std::string part =
      std::filesystem::path(options.part.substr(options.part.find(':') + 1)).stem().string();
  const auto earlier = resultsIn(options.folder, part, command);
  if (!options.replace && !earlier.empty())
    throw base::Error(base::ErrorCode::CannotWrite, "exists already"_text, earlier.front().string(),
                      "choose another folder, or give --replace"_text);
  const auto made = endedWith(
      runInterruptibly([&](const base::RunContext& ctx) { return command.make(options, ctx); },
                       options.threads, {}, [] {}));
  if (!made)
    return kCancelled;
  base::StagedFolder staged(options.folder);
  for (const NamedMesh& mesh : *made)
    base::writeFile(staged.path() / fileName(part, mesh.word), geometry::writeStl(mesh.mesh));
  staged.commit();
  for (const std::filesystem::path& file : earlier) // those of more dowels or bodies than now
    if (std::ranges::none_of(*made, [&](const NamedMesh& mesh) {
          return file.filename() == fileName(part, mesh.word);
        }))
      std::filesystem::remove(file);
  for (const NamedMesh& mesh : *made) {
    const Eigen::Vector3d size = geometry::bounds(mesh.mesh).sizes();
    fmt::print("{}: {:.1f} x {:.1f} x {:.1f} mm, {:.1f} cm3\n",
               (options.folder / fileName(part, mesh.word)).string(), size.x(), size.y(), size.z(),
               geometry::volume(mesh.mesh) / 1000.0);
  }
  return kDone;
}

void addPartAndFolder(CLI::App& command, CutOptions& options) {
  command.add_option("PART", options.part, kPartHelp)->required();
  command.add_option("--units", options.units, kUnitsHelp);
  command.add_option("-o", options.folder, "folder for the STL files, in mm")->required();
  command.add_flag("--replace", options.replace, "replace the files of an earlier run");
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
  cut->callback([options, &run] { run = [options] { return writeMeshes(*options, kCut); }; });
}

void addSplit(CLI::App& app, std::function<ExitCode()>& run, int threads) {
  auto options = std::make_shared<CutOptions>();
  options->threads = threads;
  CLI::App* split = app.add_subcommand("split", "write each body of a part to a file of its own");
  addPartAndFolder(*split, *options);
  split->callback([options, &run] { run = [options] { return writeMeshes(*options, kSplit); }; });
}

} // namespace voluta::cli
