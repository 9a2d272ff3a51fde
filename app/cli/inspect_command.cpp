#include "cli/commands.h"
#include "geometry/diagnosis.h"
#include "geometry/mesh_reader.h"
#include "geometry/placement.h"
#include "geometry/repair.h"

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
              {"defects", d.sentences()}};
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

ExitCode inspectCommand(const InspectOptions& options) {
  const geometry::MeshFile file = geometry::readMesh(std::filesystem::path(options.part));
  const geometry::RepairResult repaired = geometry::repair(file.mesh, {});
  Json found = diagnosisJson(geometry::diagnose(file.mesh));
  Json mended = diagnosisJson(geometry::diagnose(repaired.mesh));
  std::vector<std::string> repairs = file.repairs;
  repairs.insert(repairs.end(), repaired.repairs.begin(), repaired.repairs.end());
  const std::string note = geometry::guessUnits(file.mesh).note;
  if (options.json) {
    const Json all{{"file", options.part}, {"format", file.format},
                   {"unitNote", note},     {"asRead", std::move(found)},
                   {"repairs", repairs},   {"afterRepair", std::move(mended)}};
    fmt::print("{}\n", all.dump(2, ' ', false, Json::error_handler_t::replace));
    return kDone;
  }
  printText(found, fmt::format("{} ({})", options.part, file.format));
  if (!note.empty())
    fmt::print("note: {}\n", note);
  if (repairs.empty()) {
    fmt::print("nothing to repair\n");
    return kDone;
  }
  fmt::print("repairs\n");
  for (const std::string& repair : repairs)
    fmt::print("  - {}\n", repair);
  printText(mended, "after repair");
  return kDone;
}

} // namespace voluta::cli
