#include "geometry/formats/cad_reader.h"

#include "base/child_process.h"
#include "base/error.h"
#include "base/files.h"
#include "base/run_context.h"
#include "geometry/formats/cad_text.h"
#include "geometry/formats/mesh_formats.h"

#include <algorithm>
#include <fmt/format.h>

namespace voluta::geometry {

namespace {

using base::Error;
using base::ErrorCode;
using End = base::ChildResult::End;

// Exit codes of app/cad_reader/cad_reader_main.cpp.
enum CadCode { kRead = 0, kNothingToRead = 4, kNoFaces = 5, kNoMemory = 6 };

struct CadFile {
  CadFacets facets;
  CadKind kind = CadKind::Step;
};

base::ChildResult runReader(const std::filesystem::path& file, CadKind kind,
                            const Tessellation& tessellation, const base::RunContext& ctx,
                            std::chrono::milliseconds limit) {
  const base::ChildResult read = base::runChild(
      base::programBeside("voluta-cad-reader"),
      {kind == CadKind::Step ? "step" : "iges", fmt::format("{}", tessellation.chordMm),
       fmt::format("{}", tessellation.angleRad), file.string()},
      {.time = limit, .cancelled = [&ctx] { return ctx.cancelled(); }});
  ctx.checkpoint();
  return read;
}

// Throws if the reader did not end with facets.
void requireRead(const base::ChildResult& read, const std::string& name,
                 std::chrono::milliseconds limit) {
  const auto unreadable = [&](const base::Message& problem, const base::Message& remedy = {}) {
    return Error(ErrorCode::UnreadableFile, problem, name, remedy);
  };
  if (read.end == End::NotStarted)
    throw unreadable("cannot be read: voluta-cad-reader is missing beside this program"_text);
  if (read.end == End::TimedOut)
    throw unreadable(base::message("takes longer than {time:.0f} to read"_text,
                                   base::seconds(std::chrono::duration<double>(limit).count())),
                     "allow larger facets, or export less detail"_text);
  if (read.end != End::Exited)
    throw unreadable("is damaged: the reader failed"_text);
  if (read.code == kNoMemory)
    throw unreadable("needs more than 4 GB of memory to read"_text,
                     "allow larger facets, or export less detail"_text);
  if (read.code == kNoFaces)
    throw Error(ErrorCode::UnusableInput, "has only curves, no solid and no surface"_text, name,
                "export the solid from the CAD program"_text);
  if (read.code == kNothingToRead)
    throw Error(ErrorCode::UnusableInput, "has no solid and no surface"_text, name,
                "export the solid from the CAD program"_text);
  if (read.code != kRead)
    throw unreadable("is damaged: Open CASCADE cannot read it"_text);
}

CadFile readFile(const std::filesystem::path& file, const Tessellation& tessellation,
                 const base::RunContext& ctx, std::chrono::milliseconds limit) {
  const std::string name = file.string();
  const CadKind kind = cadKindOf(base::readFile(file), name);
  const base::ChildResult read = runReader(file, kind, tessellation, ctx, limit);
  requireRead(read, name, limit);
  return {readCadFacets(read.output, name), kind};
}

std::vector<base::Message> notesOf(const CadFacets& facets, const Tessellation& tessellation) {
  std::vector<base::Message> notes;
  notes.push_back(base::message("surfaces are read as facets, at most {chord:.3g} off"_text,
                                base::mm(tessellation.chordMm)));
  if (facets.missingFaces > 0)
    notes.push_back(base::message("omitted: {n} surface without facets|"
                                  "omitted: {n} surfaces without facets"_plural,
                                  facets.missingFaces));
  if (facets.curves > 0)
    notes.push_back(base::message("omitted: {n} curve|omitted: {n} curves"_plural, facets.curves));
  return notes;
}

FacetSoup soupOf(CadKind kind) {
  FacetSoup soup;
  soup.format = kind == CadKind::Step ? "STEP" : "IGES";
  return soup;
}

MeshFile joined(const CadFile& file, const Tessellation& tessellation, const std::string& name) {
  FacetSoup soup = soupOf(file.kind);
  soup.repairs = notesOf(file.facets, tessellation);
  for (const CadBody& body : file.facets.bodies)
    for (const Facet& facet : body.facets)
      soup.facets.push_back(
          {facet[0] + body.placeMm, facet[1] + body.placeMm, facet[2] + body.placeMm});
  return meshOf(std::move(soup), name);
}

} // namespace

Tessellation tessellationFor(double beadWidthMm) {
  constexpr double kShare = 0.02, kMinMm = 0.002;
  return {std::max(kShare * beadWidthMm, kMinMm), Tessellation().angleRad};
}

bool isCad(const std::filesystem::path& file) {
  const MeshFormat* format = meshFormatOf(file);
  return format && format->cad;
}

std::vector<PartOfFile> readCadParts(const std::filesystem::path& file,
                                     const Tessellation& tessellation, const base::RunContext& ctx,
                                     std::chrono::milliseconds limit) {
  CadFile read = readFile(file, tessellation, ctx, limit);
  const std::string name = file.string();
  requirePrintable(read.facets.bodies.size(), name);
  if (read.facets.bodies.size() == 1)
    return {{{}, joined(read, tessellation, name), Eigen::Vector3d::Zero()}};
  std::vector<PartOfFile> parts;
  for (CadBody& body : read.facets.bodies) {
    FacetSoup soup = soupOf(read.kind);
    soup.facets = std::move(body.facets);
    const std::string place = body.name.empty() ? name : name + ", " + body.name;
    parts.push_back({body.name, meshOf(std::move(soup), place), body.placeMm});
  }
  if (parts.empty())
    throw Error(ErrorCode::UnusableInput, "has no solid and no surface"_text, name);
  auto& notes = parts.front().file.repairs;
  const std::vector<base::Message> own = notesOf(read.facets, tessellation);
  notes.insert(notes.begin(), own.begin(), own.end());
  return parts;
}

MeshFile readCad(const std::filesystem::path& file, const Tessellation& tessellation,
                 const base::RunContext& ctx, std::chrono::milliseconds limit) {
  return joined(readFile(file, tessellation, ctx, limit), tessellation, file.string());
}

} // namespace voluta::geometry
