#include "project/part_formats.h"

#include "base/error.h"
#include "base/files.h"
#include "base/lower_case.h"
#include "base/run_context.h"
#include "build3mf/bead_cells.h"
#include "build3mf/build_reader.h"
#include "geometry/formats/cad_reader.h"
#include "geometry/formats/foreign_reader.h"
#include "geometry/formats/mesh_formats.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/formats/threemf_parts.h"
#include "geometry/measures.h"
#include "project/content_hash.h"
#include "project/file_events.h"
#include "project/file_regions.h"
#include "project/job_magic.h"
#include "project/loaded_part.h"
#include "sliced/sliced_reader.h"
#include "voxel/voxel_text.h"

#include <algorithm>
#include <iterator>

namespace voluta::project {

namespace {
constexpr double kReadShare = 0.3; // of the progress of loading a part

void takeMesh(geometry::MeshFile file, LoadedPart& part) {
  part.source = std::make_shared<geometry::TriangleMesh>(std::move(file.mesh));
  part.readNotes = std::move(file.repairs);
}

void readMeshFile(const std::string& file, LoadedPart& part, const base::RunContext&) {
  takeMesh(geometry::readMesh(base::readFile(file), file), part);
}

void readCadFile(const std::string& file, LoadedPart& part, const base::RunContext& ctx) {
  takeMesh(geometry::readCad(file, {}, ctx), part);
}

void readForeignFile(const std::string& file, LoadedPart& part, const base::RunContext&) {
  takeMesh(geometry::readForeign(file, geometry::ForeignFrame::Upright), part);
}

// Reads a 3MF: its object, or its tool-paths with their object, which is the solid of their beads
// if the file has none.
void readPackage(const std::string& file, LoadedPart& part, const base::RunContext& ctx) {
  constexpr double kCellMm = 0.25;
  const std::string bytes = base::readFile(file);
  if (!build3mf::holdsToolpaths(bytes)) {
    geometry::PartOfFile whole = geometry::read3mfWhole(bytes, file);
    takeMesh(std::move(whole.file), part);
    FileEvents events =
        eventsOfFile(whole.events, geometry::bounds(*part.source).max().z(), part.readNotes);
    part.layerEvents = std::move(events.layerEvents);
    part.regions = std::move(events.tools);
    std::ranges::move(regionsOfFile(whole.modifiers, part.readNotes, ctx),
                      std::back_inserter(part.regions));
    return;
  }
  build3mf::ReadBuild build = build3mf::readBuild(bytes, file, ctx);
  if (build.hasObject) {
    takeMesh(geometry::readMesh(bytes, file), part);
  } else {
    part.source =
        std::make_shared<geometry::TriangleMesh>(build3mf::solidOfBeads(build.plan, kCellMm, ctx));
    part.readNotes.emplace_back("no object in the file: the part is made from its beads"_text);
  }
  part.readNotes.insert(part.readNotes.end(), build.notes.begin(), build.notes.end());
  part.inWorkFrame = build.workFrame;
  part.toolPaths = std::make_shared<plan::ToolPlan>(std::move(build.plan));
}

void readVoxels(const std::string& file, LoadedPart& part, const base::RunContext&) {
  setCells(part,
           std::make_shared<voxel::VoxelObject>(voxel::readVoxelText(base::readFile(file), file)));
}

// The part is the solid of the beads.
void readGcode(const std::string& file, LoadedPart& part, const base::RunContext& ctx) {
  sliced::ReadSliced read =
      sliced::readSliced(base::readFile(file), file, ctx.sub(0.0, kReadShare));
  part.source = std::make_shared<geometry::TriangleMesh>(std::move(read.solid));
  part.readNotes = std::move(read.notes);
  part.toolPaths = std::make_shared<plan::ToolPlan>(std::move(read.plan));
}

PartFormat rowOf(const geometry::MeshFormat& mesh) {
  if (mesh.ending == ".3mf")
    return {mesh.ending, mesh.name, PartContent::Mesh,
            true,        false,     "several parts, or tool-paths (build files)"_text,
            readPackage};
  if (mesh.cad)
    return {mesh.ending, mesh.name, PartContent::Mesh,
            true,        true,      "one or several solids; read by a program of its own"_text,
            readCadFile};
  if (mesh.foreign())
    return {mesh.ending,    mesh.name, PartContent::Mesh,
            false,          true,      "one mesh; read by a program of its own"_text,
            readForeignFile};
  return {mesh.ending, mesh.name, PartContent::Mesh, false, false, "one mesh"_text, readMeshFile};
}

std::vector<PartFormat> makeTable() {
  std::vector<PartFormat> table;
  for (const geometry::MeshFormat& mesh : geometry::meshFormats())
    table.push_back(rowOf(mesh));
  for (const char* ending : {".gcode", ".gco", ".g", ".ngc", ".nc", ".tap", ".bgcode"})
    table.push_back({ending, "G-code", PartContent::SlicedPaths, false, false,
                     "tool-paths of a slicer"_text, readGcode});
  for (const char* ending : {".txt", ".voxels"})
    table.push_back({ending, "voxel text", PartContent::Voxels, false, false,
                     "solid cells, drawn as text"_text, readVoxels});
  return table;
}

bool isOf(const PartFormat& format, NamedFiles files) {
  if (files == NamedFiles::Parts)
    return true;
  return format.content == PartContent::Mesh && (files == NamedFiles::AllMeshes || !format.foreign);
}

// Each once, "STL, OBJ, G-code".
std::string formatNames() {
  std::vector<std::string_view> known;
  std::string names;
  for (const PartFormat& format : partFormats())
    if (std::ranges::find(known, format.name) == known.end()) {
      known.push_back(format.name);
      names += (names.empty() ? "" : ", ") + std::string(format.name);
    }
  return names;
}

[[noreturn]] void refuseUnknown(std::string_view bytes, const std::string& file) {
  using base::Error, base::ErrorCode;
  if (bytes.empty())
    throw Error(ErrorCode::UnreadableFile, "the file is empty"_text, file);
  if (bytes.starts_with(kStationMagic))
    throw Error(ErrorCode::UnreadableFile,
                "the project of a station of several machines, not a part"_text, file,
                "give it to 'together', 'verify' or 'resume'; a part is a file of its own"_text);
  if (bytes.starts_with(kJobMagic))
    throw Error(ErrorCode::UnreadableFile, "a project, not a part"_text, file,
                "give it to 'resume', 'verify' or 'together'; a part is a file of its own"_text);
  throw Error(ErrorCode::UnreadableFile, "not the file of a part"_text, file,
              base::message("use one of these formats: {formats}"_text, formatNames()));
}

const PartFormat& formatNamed(std::string_view ending) {
  return *std::ranges::find(partFormats(), ending, &PartFormat::ending);
}
} // namespace

const std::vector<PartFormat>& partFormats() {
  static const std::vector<PartFormat> kTable = makeTable();
  return kTable;
}

const PartFormat* partFormatOf(const std::filesystem::path& file) {
  const std::string ending = base::lowerCase(file.extension().string());
  const auto format = std::ranges::find(partFormats(), ending, &PartFormat::ending);
  return format == partFormats().end() ? nullptr : &*format;
}

const PartFormat& detectedFormat(const std::string& file) {
  if (const PartFormat* format = partFormatOf(file))
    return *format;
  const std::string bytes = base::readFile(file);
  if (voxel::looksLikeVoxelText(bytes))
    return formatNamed(".voxels");
  if (build3mf::holdsToolpaths(bytes))
    return formatNamed(".3mf");
  if (!geometry::looksLikeMesh(bytes))
    refuseUnknown(bytes, file);
  return formatNamed(".stl");
}

bool isSlicedFile(const std::string& name) {
  const PartFormat* format = partFormatOf(name);
  return format && format->content == PartContent::SlicedPaths;
}

std::string filePatterns(NamedFiles files) {
  std::string patterns;
  for (const PartFormat& format : partFormats())
    if (isOf(format, files))
      patterns += (patterns.empty() ? "*" : " *") + std::string(format.ending);
  return patterns;
}

} // namespace voluta::project
