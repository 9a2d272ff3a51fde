#include "project/loaded_part.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/stopwatch.h"
#include "geometry/repair/repair.h"
#include "project/accuracy_plate.h"
#include "project/content_hash.h"
#include "project/part_formats.h"
#include "project/rib_samples.h"
#include "project/sample_part.h"
#include "project/specimens.h"
#include "voxel/voxel_text.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace voluta::project {

namespace {
constexpr std::string_view kSamplePrefix = "sample:";

using Mesh = std::shared_ptr<const geometry::TriangleMesh>;

// Fills in all fields that follow from source, readNotes and `repair`.
void mend(LoadedPart& part, const base::RunContext& ctx) {
  base::Stopwatch mending;
  part.notes = part.readNotes;
  // Solids made of beads are made of cells too.
  if (part.cells || (part.toolPaths && isSlicedFile(part.name))) {
    part.mesh = part.source;
    part.found = geometry::diagnose(*part.source, ctx);
    part.found.selfIntersections = {}; // reported where cells only touch
    part.remains.clear();
    part.repairS = mending.seconds();
    return;
  }
  if (part.repair) {
    geometry::RepairResult repaired = geometry::repair(*part.source, ctx);
    part.notes.insert(part.notes.end(), repaired.repairs.begin(), repaired.repairs.end());
    part.remains = std::move(repaired.remains);
    part.found = std::move(repaired.found);
    part.open = std::move(repaired.open);
    part.mesh = part.found.clean()
                    ? part.source
                    : std::make_shared<geometry::TriangleMesh>(std::move(repaired.mesh));
  } else {
    part.mesh = part.source;
    part.found = geometry::diagnose(*part.source, ctx);
    part.remains = part.found.sentences();
    part.open.reset();
  }
  part.repairS = mending.seconds();
  if (part.mesh->empty())
    throw base::Error(base::ErrorCode::UnusableInput,
                      "nothing is left of the mesh after repair"_text, part.name);
  part.units = geometry::guessUnits(*part.mesh);
  if (!part.units.note.empty())
    part.notes.push_back(part.units.note);
}

std::shared_ptr<const LoadedPart> mended(LoadedPart part, const base::RunContext& ctx) {
  mend(part, ctx);
  return std::make_shared<LoadedPart>(std::move(part));
}
struct SampleRow {
  std::string_view name;
  geometry::TriangleMesh (*mesh)();
};
template <int kLengthMm> geometry::TriangleMesh accuracyPlateOf() {
  return accuracyPlateMesh(accuracyPlate(kLengthMm));
}
constexpr std::array<SampleRow, 16> kSamples{
    {{"vase", samplePart},
     {"bar", barSpecimen},
     {"dumbbell", dumbbellSpecimen},
     {"plate", plateSpecimen},
     {"curved-bar", [] { return curvedSpecimen(); }},
     {"curved-mould", [] { return mouldOfCurvedSpecimen(); }},
     {"roof", gableRoof},
     {"roof-rib", ribOnRoof},
     {"half-cylinder", halfCylinder},
     {"cylinder-rib", ribOnCylinder},
     {"accuracy-plate", accuracyPlateOf<50>},
     {"accuracy-plate-100", accuracyPlateOf<100>},
     {"accuracy-plate-210", accuracyPlateOf<210>},
     {"accuracy-plate-260", accuracyPlateOf<260>},
     {"accuracy-plate-310", accuracyPlateOf<310>},
     {"accuracy-plate-360", accuracyPlateOf<360>}}};
} // namespace

std::string hashOf(const LoadedPart& part) {
  const std::string mesh = contentHash(*part.source);
  return part.toolPaths ? contentHash(mesh + contentHash(*part.toolPaths)) : mesh;
}

void setCells(LoadedPart& part, std::shared_ptr<const voxel::VoxelObject> cells) {
  part.source = std::make_shared<geometry::TriangleMesh>(voxel::surfaceOf(*cells));
  part.hash = contentHash(voxel::writeVoxelText(*cells));
  part.cells = std::move(cells);
}

std::vector<std::string> sampleNames() {
  std::vector<std::string> names;
  for (const SampleRow& row : kSamples)
    names.emplace_back(row.name);
  return names;
}

std::shared_ptr<const LoadedPart> loadedFrom(std::string name, Mesh source,
                                             std::vector<base::Message> readNotes, bool repair,
                                             const base::RunContext& ctx) {
  LoadedPart part;
  part.name = std::move(name);
  part.hash = contentHash(*source);
  part.source = std::move(source);
  part.readNotes = std::move(readNotes);
  part.repair = repair;
  return mended(std::move(part), ctx);
}

std::shared_ptr<const LoadedPart> loadedFrom(std::string name,
                                             std::shared_ptr<const voxel::VoxelObject> cells,
                                             bool repair, const base::RunContext& ctx) {
  LoadedPart part;
  part.name = std::move(name);
  part.repair = repair;
  setCells(part, std::move(cells));
  return mended(std::move(part), ctx);
}

geometry::RepairResult closedPart(const LoadedPart& part, const base::RunContext& ctx) {
  return geometry::repair(*part.source, ctx, geometry::OpenSurfaces::Close);
}

std::shared_ptr<const LoadedPart> loadPart(const std::string& part, bool repair,
                                           const base::RunContext& ctx) {
  base::Stopwatch reading;
  LoadedPart loaded;
  loaded.repair = repair;
  if (part.starts_with(kSamplePrefix)) {
    const std::string name = part.substr(kSamplePrefix.size());
    const auto sample = std::ranges::find(kSamples, name, &SampleRow::name);
    if (sample == kSamples.end())
      throw base::Error(base::ErrorCode::Usage, base::message("unknown sample '{name}'"_text, name),
                        {}, base::didYouMean(name, sampleNames()));
    loaded.name = name + ".stl";
    loaded.source = std::make_shared<geometry::TriangleMesh>(sample->mesh());
  } else {
    loaded.name = std::filesystem::path(part).filename().string();
    detectedFormat(part).read(part, loaded, ctx);
  }
  if (!loaded.cells)
    loaded.hash = hashOf(loaded);
  loaded.readS = reading.seconds();
  ctx.report(0.3, "repair"_text);
  return mended(std::move(loaded), ctx.sub(0.3, 1.0));
}

std::shared_ptr<const LoadedPart> withRepair(std::shared_ptr<const LoadedPart> part, bool repair,
                                             const base::RunContext& ctx) {
  if (part->repair == repair)
    return part;
  LoadedPart again = *part;
  again.repair = repair;
  return mended(std::move(again), ctx);
}

} // namespace voluta::project
