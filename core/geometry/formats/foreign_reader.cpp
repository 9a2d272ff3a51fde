#include "geometry/formats/foreign_reader.h"

#include "base/child_process.h"
#include "base/error.h"
#include "base/run_context.h"
#include "geometry/formats/cad_reader.h"
#include "geometry/formats/facet_soup.h"
#include "geometry/formats/mesh_formats.h"

#include <cstring>

namespace voluta::geometry {

namespace {

using base::Error;
using base::ErrorCode;
using End = base::ChildResult::End;

constexpr double kMmInMetre = 1000.0;

MeshFile readCadIn(const std::filesystem::path& file, ForeignFrame frame,
                   std::chrono::milliseconds limit) {
  MeshFile read = readCad(file, {}, {}, limit);
  if (frame == ForeignFrame::AsWritten)
    for (Eigen::Vector3d& v : read.mesh.vertices)
      v /= kMmInMetre;
  return read;
}

} // namespace

bool isForeign(const std::filesystem::path& file) {
  const MeshFormat* format = meshFormatOf(file);
  return format && format->foreign();
}

MeshFile readForeign(const std::filesystem::path& file, ForeignFrame frame,
                     std::chrono::milliseconds limit) {
  const auto fail = [&](const base::Message& what, const base::Message& remedy = {}) {
    return Error(ErrorCode::UnreadableFile, what, file.string(), remedy);
  };
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none))
    throw fail("no such file"_text);
  if (isCad(file))
    return readCadIn(file, frame, limit);
  const base::ChildResult read = base::runChild(
      base::programBeside("voluta-mesh-reader"),
      {frame == ForeignFrame::Upright ? "upright" : "as-written", file.string()}, {.time = limit});
  switch (read.end) {
  case End::NotStarted:
    throw fail("cannot be read: voluta-mesh-reader is missing beside this program"_text);
  case End::TimedOut:
    throw fail("takes too long to read"_text);
  case End::Crashed:
  case End::Cancelled:
  case End::TooMuchOutput:
    throw fail("is damaged: the reader failed"_text);
  case End::Exited:
    break;
  }
  if (read.code != 0)
    throw fail("cannot be read: not a mesh, or damaged"_text);
  // Nine doubles per facet.
  FacetSoup soup;
  constexpr std::size_t kFacetBytes = 9 * sizeof(double);
  if (read.output.size() % kFacetBytes != 0)
    throw fail("is damaged: the reader failed"_text);
  soup.facets.resize(read.output.size() / kFacetBytes);
  for (std::size_t f = 0; f < soup.facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      std::memcpy(soup.facets[f][k].data(), read.output.data() + (3 * f + k) * 3 * sizeof(double),
                  3 * sizeof(double));
  if (const MeshFormat* format = meshFormatOf(file))
    soup.format = format->name;
  return meshOf(std::move(soup), file.string());
}

MeshFile readMeshOf(const std::filesystem::path& file, ForeignFrame frame) {
  return isForeign(file) ? readForeign(file, frame) : readMesh(file);
}

} // namespace voluta::geometry
