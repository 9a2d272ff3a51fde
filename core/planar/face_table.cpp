#include "planar/face_table.h"

#include "geometry/edges.h"
#include "geometry/measures.h"

namespace voluta::planar {

FaceTable faceTable(const Piece& piece, const RiskRule& rule) {
  const geometry::TriangleMesh& mesh = piece.solid.mesh;
  const std::size_t n = mesh.triangles.size();
  FaceTable f;
  f.stands = standsOn(piece, rule);
  f.neighbour.assign(n, {-1, -1, -1});
  f.normal.reserve(n);
  f.area.reserve(n);
  f.risky.reserve(n);
  for (std::size_t t = 0; t < n; ++t) {
    f.normal.push_back(geometry::triangleNormal(mesh, t));
    f.area.push_back(geometry::triangleArea(mesh, t));
    f.onPrinted.push_back(piece.solid.tag[t] == kOnPrinted ||
                          (piece.baseTag != kPlate && f.stands[t] != 0));
    const bool risky =
        !f.stands[t] && !f.onPrinted[t] && isRisky(f.normal[t], piece.base.normal, rule);
    f.risky.push_back(risky ? f.area[t] : 0.0);
    f.standsMm2 += f.stands[t] ? f.area[t] : 0.0;
  }
  const std::vector<geometry::HalfEdge> sides = geometry::sortedHalfEdges(mesh);
  geometry::forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i + 1 < end; ++i) {
      const auto a = static_cast<std::size_t>(sides[i].triangle);
      const auto b = static_cast<std::size_t>(sides[i + 1].triangle);
      f.neighbour[a][static_cast<std::size_t>(sides[i].side)] = static_cast<int>(b);
      f.neighbour[b][static_cast<std::size_t>(sides[i + 1].side)] = static_cast<int>(a);
    }
  });
  return f;
}

} // namespace voluta::planar
