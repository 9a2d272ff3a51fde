#include "base/files.h"
#include "cli/commands.h"
#include "geometry/formats/foreign_reader.h"
#include "geometry/placement.h"
#include "geometry/repair/diagnosis.h"
#include "geometry/repair/repair.h"
#include "project/loaded_part.h"
#include "project/part_formats.h"
#include "voxel/voxel_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace voluta::cli {

namespace {
using Json = nlohmann::ordered_json;

Json diagnosisJson(const geometry::Diagnosis& d) {
  const Eigen::Vector3d low = d.boundsMm.min(), high = d.boundsMm.max();
  return Json{{"triangles", d.triangles},
              {"vertices", d.vertices},
              {"components", d.components},
              {"watertight", d.watertight},
              {"genus", d.genus ? Json(*d.genus) : Json()},
              {"volumeMm3", d.volumeMm3},
              {"areaMm2", d.areaMm2},
              {"boundsMm", Json::array({Json::array({low.x(), low.y(), low.z()}),
                                        Json::array({high.x(), high.y(), high.z()})})},
              {"boundaryEdges", d.boundaryEdges.count},
              {"boundaryLoops", d.boundaryLoops},
              {"nonManifoldEdges", d.nonManifoldEdges.count},
              {"misorientedEdges", d.misorientedEdges.count},
              {"duplicateFaces", d.duplicateFaces.count},
              {"degenerateFaces", d.degenerateFaces.count},
              {"selfIntersections", d.selfIntersections.count},
              {"insideOutComponents", d.insideOutComponents.count},
              {"defects", base::english(d.sentences())}};
}

void printText(const Json& json, const std::string& heading) {
  fmt::print("{}\n", heading);
  for (const auto& [key, value] : json.items()) {
    if (value.is_array() && !value.empty() && value[0].is_string()) {
      for (const Json& sentence : value)
        fmt::print("  - {}\n", sentence.get<std::string>());
    } else if (!(value.is_array() && value.empty())) {
      fmt::print("  {}: {}\n", key, value.dump());
    }
  }
}
} // namespace

namespace {
// A voxel object has nothing to repair; lengths of its surface are in cells.
ExitCode inspectCells(const InspectOptions& options, const std::string& bytes,
                      const base::RunContext& ctx) {
  const voxel::VoxelObject object = voxel::readVoxelText(bytes, options.part);
  const Json cells{{"size", Json::array({object.size.x(), object.size.y(), object.size.z()})},
                   {"solid", std::count(object.solid.begin(), object.solid.end(), 1)},
                   {"platform", object.platform.size()}};
  geometry::Diagnosis surface = geometry::diagnose(voxel::surfaceOf(object), ctx);
  surface.selfIntersections = {}; // These are where cells only touch
  const char* const kFormat = "voxel text";
  if (options.json) {
    const Json all{{"file", options.part},
                   {"format", kFormat},
                   {"cells", cells},
                   {"unitNote", "a cell is as wide as voxelMm"},
                   {"repairs", Json::array()},
                   {"asRead", diagnosisJson(surface)},
                   {"afterRepair", diagnosisJson(surface)}};
    fmt::print("{}\n", all.dump(2, ' ', false, Json::error_handler_t::replace));
    return kDone;
  }
  printText(cells, fmt::format("{} ({}; a cell is as wide as voxelMm)", options.part, kFormat));
  printText(diagnosisJson(surface), "surface, in cells");
  return kDone;
}
} // namespace

ExitCode inspectCommand(const InspectOptions& options, const base::RunContext& ctx) {
  if (project::detectedFormat(options.part).content == project::PartContent::Voxels)
    return inspectCells(options, base::readFile(options.part), ctx);
  const geometry::MeshFile file =
      geometry::readMeshOf(options.part, geometry::ForeignFrame::Upright);
  const geometry::RepairResult repaired = geometry::repair(file.mesh, ctx);
  const std::string open = repaired.open ? base::english(repaired.open->sentence()) : "";
  Json found = diagnosisJson(repaired.found);
  Json mended = diagnosisJson(repaired.diagnosis);
  std::vector<std::string> repairs = base::english(file.repairs);
  for (const base::Message& repair : repaired.repairs)
    repairs.push_back(base::english(repair));
  const std::string note = base::english(geometry::guessUnits(file.mesh).note);
  if (options.json) {
    const Json all{{"file", options.part},
                   {"format", file.format},
                   {"open", open},
                   {"unitNote", note},
                   {"repairs", repairs},
                   {"asRead", std::move(found)},
                   {"afterRepair", std::move(mended)}};
    fmt::print("{}\n", all.dump(2, ' ', false, Json::error_handler_t::replace));
    return kDone;
  }
  if (!open.empty())
    fmt::print("{}\n", open);
  printText(found, fmt::format("{} ({})", options.part, file.format));
  if (!note.empty())
    fmt::print("note: {}\n", note);
  if (repaired.found.clean() && repairs.empty()) {
    fmt::print("nothing to repair\n");
    return kDone;
  }
  fmt::print("{}\n", repairs.empty() ? "nothing could be repaired" : "repairs");
  for (const std::string& repair : repairs)
    fmt::print("  - {}\n", repair);
  printText(mended, "after repair");
  return kDone;
}

} // namespace voluta::cli
