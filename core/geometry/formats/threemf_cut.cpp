#include "geometry/formats/threemf_cut.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/repair/repair.h"
#include "geometry/subtract.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace voluta::geometry {

namespace {

using base::Error;
using base::ErrorCode;

constexpr double kMaxCoordinate = 1e9; // of coordinates, as of a mesh

// Returns nullopt if neither the meshes nor their repaired ones can be cut.
std::optional<TriangleMesh> cutOrRepaired(const TriangleMesh& part, const TriangleMesh& negative) {
  if (std::optional<TriangleMesh> rest = subtract(part, negative))
    return rest;
  try {
    return subtract(repair(part).mesh, repair(negative).mesh);
  } catch (const Error&) {
    return std::nullopt; // Nothing with area
  }
}

void append(const TriangleMesh& mesh, std::vector<Facet>& facets) {
  for (const auto& t : mesh.triangles)
    facets.push_back({mesh.vertices[static_cast<std::size_t>(t[0])],
                      mesh.vertices[static_cast<std::size_t>(t[1])],
                      mesh.vertices[static_cast<std::size_t>(t[2])]});
}

// Returns the negative in the coordinates of the piece's object; exactly as in the file if both are
// volumes of one object.
TriangleMesh negativeFor(const ThreemfPiece& piece, const ThreemfPiece& negative) {
  const Eigen::Affine3d &to = piece.item_T_object, &from = negative.item_T_object;
  const Eigen::Affine3d between =
      to.matrix() == from.matrix() ? Eigen::Affine3d::Identity() : to.inverse() * from;
  std::vector<Facet> facets;
  appendPlaced(negative, between, facets);
  return soundMesh(facets);
}

void cutOut(ThreemfPiece& piece, const ThreemfPiece& negative, const std::string& name) {
  const TriangleMesh tool = negativeFor(piece, negative);
  if (tool.empty())
    return;
  std::vector<Facet> all;
  std::vector<std::size_t> ends;
  std::size_t from = 0;
  for (const std::size_t to : piece.volumeEnds) {
    const std::vector<Facet> own(piece.facets.begin() + static_cast<std::ptrdiff_t>(from),
                                 piece.facets.begin() + static_cast<std::ptrdiff_t>(to));
    from = to;
    const TriangleMesh mesh = soundMesh(own);
    if (mesh.empty() || !bounds(mesh).intersects(bounds(tool))) {
      all.insert(all.end(), own.begin(), own.end());
    } else if (const std::optional<TriangleMesh> rest = cutOrRepaired(mesh, tool)) {
      append(*rest, all);
    } else {
      throw Error(ErrorCode::UnusableInput,
                  base::message("the negative volume '{negative}' cannot be cut out of '{part}': "
                                "their meshes are not closed or intersect themselves"_text,
                                negative.name, piece.name),
                  name, "repair them in the slicer, or export the part as STL"_text);
    }
    ends.push_back(all.size());
  }
  piece.facets = std::move(all);
  piece.volumeEnds = std::move(ends);
}

} // namespace

TriangleMesh soundMesh(const std::vector<Facet>& facets) {
  std::vector<Facet> sound;
  for (const Facet& f : facets)
    if (std::ranges::all_of(f, [](const Eigen::Vector3d& v) {
          return v.allFinite() && v.cwiseAbs().maxCoeff() <= kMaxCoordinate;
        }))
      sound.push_back(f);
  return shareVertices(sound);
}

void cutNegatives(std::vector<ThreemfPiece>& pieces, const std::string& name) {
  for (const ThreemfPiece& negative : pieces)
    if (negative.kind == ThreemfVolumeKind::Negative)
      for (ThreemfPiece& piece : pieces)
        if (piece.kind == ThreemfVolumeKind::Part && piece.item == negative.item)
          cutOut(piece, negative, name);
  std::erase_if(pieces, [](const ThreemfPiece& piece) {
    return piece.kind != ThreemfVolumeKind::Part || piece.facets.empty();
  });
}

} // namespace voluta::geometry
