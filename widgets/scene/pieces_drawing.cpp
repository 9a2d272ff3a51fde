#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"

#include "planar/face_table.h"

#include <algorithm>
#include <limits>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace voluta::scene {

namespace {

constexpr double kBeyondSection = 0.08; // relative to the section's size, but
constexpr double kMinBeyondMm = 1.5, kMaxBeyondMm = 5.0;
constexpr double kOverSectionMm = 0.15; // avoids z-fighting with the plane

// Returns the `wanted` triangles of a surface, with the same points.
vtkSmartPointer<vtkPolyData> trianglesOf(vtkPolyData* surface, const std::vector<bool>& wanted) {
  auto out = vtkSmartPointer<vtkPolyData>::New();
  out->SetPoints(surface->GetPoints());
  out->GetPointData()->ShallowCopy(surface->GetPointData());
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> corners;
  for (std::size_t t = 0; t < wanted.size(); ++t)
    if (wanted[t]) {
      surface->GetPolys()->GetCellAtId(static_cast<vtkIdType>(t), corners);
      triangles->InsertNextCell(corners);
    }
  out->SetPolys(triangles);
  out->ComputeBounds();
  return out;
}

// Draws the rectangle around a piece's section, slightly enlarged.
void drawBase(const planar::Piece& piece, PieceShape& shape) {
  const Eigen::Matrix3d axes = baseAxes(piece.base.normal);
  const Eigen::Vector3d across = axes.col(0), along = axes.col(1);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Eigen::Vector2d low(kFar, kFar), high(-kFar, -kFar);
  for (std::size_t t = 0; t < piece.solid.tag.size(); ++t)
    if (piece.solid.tag[t] == piece.baseTag)
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d& p = piece.solid.mesh.corner(t, k);
        const Eigen::Vector2d q(across.dot(p), along.dot(p));
        low = low.cwiseMin(q);
        high = high.cwiseMax(q);
      }
  if (!(low.x() <= high.x()))
    return;
  const double beyond =
      std::clamp(kBeyondSection * (high - low).maxCoeff(), kMinBeyondMm, kMaxBeyondMm);
  low.array() -= beyond;
  high.array() += beyond;
  const auto at = [&](double u, double v) -> Eigen::Vector3d {
    return u * across + v * along + (piece.base.offsetMm + kOverSectionMm) * piece.base.normal;
  };
  const Eigen::Vector3d corners[] = {at(low.x(), low.y()), at(high.x(), low.y()),
                                     at(high.x(), high.y()), at(low.x(), high.y())};
  MeshBuffers quad, rim;
  for (const Eigen::Vector3d& corner : corners)
    quad.addPoint(corner, piece.base.normal);
  quad.addQuad(0, 1, 2, 3);
  for (std::size_t k = 0; k < 4; ++k)
    rim.addLine(corners[k], corners[(k + 1) % 4]);
  shape.base = polyDataOf(quad);
  shape.baseRim = polyDataOf(rim);
}

} // namespace

std::shared_ptr<const PiecesDrawing> drawPieces(const std::vector<planar::Piece>& pieces,
                                                const planar::RiskRule& rule) {
  auto drawing = std::make_shared<PiecesDrawing>();
  for (const planar::Piece& piece : pieces) {
    PieceShape shape;
    shape.solid = drawPart(piece.solid.mesh);
    shape.direction = piece.base.normal;
    shape.parent = piece.parent;
    const planar::FaceTable faces = planar::faceTable(piece, rule);
    std::vector<bool> risky(faces.risky.size());
    for (std::size_t t = 0; t < risky.size(); ++t)
      risky[t] = faces.risky[t] > 0.0;
    drawing->anyRisky =
        drawing->anyRisky || std::find(risky.begin(), risky.end(), true) != risky.end();
    shape.risky = trianglesOf(shape.solid->surface, risky);
    risky.flip();
    shape.safe = trianglesOf(shape.solid->surface, risky);
    if (piece.baseTag != planar::kPlate)
      drawBase(piece, shape);
    drawing->box.extend(shape.solid->box);
    drawing->pieces.push_back(std::move(shape));
  }
  return drawing;
}

Eigen::Matrix3d baseAxes(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d level = Eigen::Vector3d::UnitZ().cross(normal);
  const Eigen::Vector3d across =
      level.norm() > 1e-6 ? level.normalized() : Eigen::Vector3d::UnitX();
  Eigen::Matrix3d axes;
  axes << across, normal.cross(across), normal;
  return axes;
}

int pieceCount(const PiecesDrawing& drawing) {
  return static_cast<int>(drawing.pieces.size());
}

std::vector<Eigen::Vector3d> pieceOffsets(const PiecesDrawing& drawing, double explodeMm) {
  std::vector<Eigen::Vector3d> offsets(drawing.pieces.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < offsets.size(); ++i)
    // Pieces come after the piece they are printed on.
    if (const int parent = drawing.pieces[i].parent; parent >= 0 && parent < static_cast<int>(i))
      offsets[i] =
          offsets[static_cast<std::size_t>(parent)] + explodeMm * drawing.pieces[i].direction;
  return offsets;
}

Eigen::Vector3d basePlaneOffset(const PiecesDrawing& drawing, std::size_t piece, double explodeMm) {
  const int parent = drawing.pieces[piece].parent;
  return pieceOffsets(drawing, explodeMm)[parent < 0 ? piece : static_cast<std::size_t>(parent)];
}

} // namespace voluta::scene
