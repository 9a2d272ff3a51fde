#include "pipeline/load_stage.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/stopwatch.h"
#include "geometry/diagnosis.h"
#include "geometry/measures.h"
#include "geometry/mesh_reader.h"
#include "geometry/placement.h"
#include "geometry/repair.h"
#include "geometry/sample_part.h"

#include <filesystem>

namespace voluta::pipeline {

namespace {
constexpr std::string_view kSamplePrefix = "sample:";
}

std::vector<std::string> sampleNames() {
  return {"vase"};
}

LoadedPart loadPart(const std::string& part, Timings& timings, const base::RunContext& ctx) {
  LoadedPart loaded;
  if (part.starts_with(kSamplePrefix)) {
    const std::string name = part.substr(kSamplePrefix.size());
    if (name != sampleNames().front())
      throw base::Error(base::ErrorCode::Usage, "unknown sample '" + name + "'", {},
                        "did you mean " + base::nearestName(name, sampleNames()) + "?");
    loaded.name = name + ".stl";
    loaded.mesh = geometry::samplePart();
    return loaded;
  }
  base::Stopwatch reading;
  geometry::MeshFile file = geometry::readMesh(std::filesystem::path(part));
  timings.load = reading.seconds();
  ctx.report(0.3, "repair");
  base::Stopwatch repairing;
  geometry::RepairResult repaired = geometry::repair(file.mesh, ctx.sub(0.3, 1.0));
  timings.repair = repairing.seconds();
  loaded.name = std::filesystem::path(part).filename().string();
  loaded.mesh = std::move(repaired.mesh);
  loaded.notes = std::move(file.repairs);
  loaded.notes.insert(loaded.notes.end(), repaired.repairs.begin(), repaired.repairs.end());
  loaded.remains = std::move(repaired.remains);
  if (const std::string note = geometry::guessUnits(loaded.mesh).note; !note.empty())
    loaded.notes.push_back(note);
  if (loaded.mesh.empty())
    throw base::Error(base::ErrorCode::UnusableInput, "nothing is left of the mesh after repair",
                      part);
  return loaded;
}

std::shared_ptr<const geometry::TriangleMesh> placePart(const LoadedPart& part, double scale,
                                                        Report& report) {
  auto placed = std::make_shared<geometry::TriangleMesh>(geometry::placeOnPlate(part.mesh, scale));
  const geometry::Diagnosis diagnosis = geometry::diagnose(*placed);
  ModelReport& m = report.model;
  m.file = part.name;
  m.scale = scale;
  m.triangles = placed->triangles.size();
  m.watertight = diagnosis.watertight;
  m.volumeMm3 = diagnosis.volumeMm3;
  m.boundsMm = diagnosis.boundsMm;
  m.repairs = part.notes;
  for (const std::string& defect : part.remains) {
    plan::Finding finding;
    finding.stage = "load";
    finding.kind = "meshDefect";
    finding.reason = defect;
    finding.remedy = "mend the mesh in a modelling program if the result looks wrong";
    finding.blocking = false;
    report.findings.push_back(std::move(finding));
  }
  return placed;
}

} // namespace voluta::pipeline
