#include "base/error.h"
#include "robot/cell.h"
#include "robot/shape/arm_look.h"
#include "robot/shape/tool_shape.h"
#include "scene/drawing_data.h"
#include "scene/shape_mesh.h"
#include "scene/surface.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace voluta::scene {

namespace {

constexpr double kFeatureAngleDeg = 30.0; // of links with visual meshes

using Body = robot::Body;
using Surface = vtkSmartPointer<vtkPolyData>;

Surface surfaceOf(const std::vector<robot::Shape>& shapes) {
  MeshBuffers buffers;
  for (const robot::Shape& shape : shapes)
    addShape(buffers, shape);
  return polyDataOf(buffers);
}

void addSolid(MeshBuffers& buffers, const robot::ShapeSolid& solid) {
  const robot::LoftMesh loft = robot::meshOf(solid.loft);
  const auto first = static_cast<std::int32_t>(buffers.points.size() / 3);
  for (std::size_t i = 0; i < loft.normals.size(); ++i) {
    buffers.addPoint(loft.mesh.vertices[i], loft.normals[i]);
    for (const double share : solid.colour)
      buffers.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0 * share)));
  }
  for (const auto& t : loft.mesh.triangles)
    buffers.addTriangle(first + t[0], first + t[1], first + t[2]);
}

// Returns null if there are no solids.
template <typename Solids> Surface colouredSurface(const Solids& solids) {
  MeshBuffers buffers;
  for (const robot::ShapeSolid& solid : solids)
    addSolid(buffers, solid);
  return buffers.corners.empty() ? nullptr : polyDataOf(buffers);
}

// Returns the link of a frame, or the last link before it if it has none.
std::size_t bodyOfFrame(const robot::Cell& cell, int frame) {
  std::size_t found = 0;
  int nearest = -1;
  for (std::size_t i = 0; i < cell.bodies().size(); ++i) {
    const Body& body = cell.bodies()[i];
    if (body.role != robot::BodyRole::Link || body.frame > frame || body.frame <= nearest)
      continue;
    nearest = body.frame;
    found = i;
  }
  return found;
}

std::vector<CellPiece> drawnArm(const robot::Cell& cell, const robot::ArmLook& look) {
  std::vector<CellPiece> pieces;
  for (int frame = 0; frame <= cell.armDof(); ++frame) {
    const std::size_t body = bodyOfFrame(cell, frame);
    const auto mesh = std::ranges::find(look.meshes, frame, &robot::LinkMesh::frame);
    if (mesh != look.meshes.end())
      pieces.push_back(
          {body, frame, shadedSurface(plainSurface(mesh->mesh), kFeatureAngleDeg), false});
    std::vector<robot::ShapeSolid> solids;
    std::ranges::copy_if(look.solids, std::back_inserter(solids),
                         [&](const robot::ShapeSolid& solid) { return solid.frame == frame; });
    if (const Surface surface = colouredSurface(solids))
      pieces.push_back({body, frame, surface, true});
  }
  return pieces;
}

// A stem is drawn with its visual shape, the rest of a platform with its collision solids, except
// for its top.
std::vector<robot::Shape> plainShapes(const robot::Cell& cell, const Body& body) {
  std::vector<robot::Shape> shapes = body.shapes;
  if (body.role != robot::BodyRole::Platform || cell.rod())
    return shapes;
  std::erase_if(shapes, [](const robot::Shape& shape) {
    return std::holds_alternative<robot::Frustum>(shape);
  });
  for (robot::Shape& shape : shapes)
    if (auto* prism = std::get_if<robot::Prism>(&shape))
      prism->zMax = std::min(prism->zMax, kPlateTopMm);
  return shapes;
}

void addOthers(const robot::Cell& cell, std::vector<CellPiece>& pieces) {
  for (std::size_t i = 0; i < cell.bodies().size(); ++i) {
    const Body& body = cell.bodies()[i];
    if (body.role == robot::BodyRole::Link)
      continue;
    const bool rod = body.role == robot::BodyRole::Platform && cell.rod();
    const Surface coloured = rod ? nullptr : colouredSurface(robot::toolShape(body));
    if (coloured)
      pieces.push_back({i, body.frame, coloured, true});
    if (coloured && body.role != robot::BodyRole::Platform)
      continue;
    if (const auto shapes = plainShapes(cell, body); !shapes.empty())
      pieces.push_back({i, body.frame, surfaceOf(shapes), false});
  }
}

Surface pinAt(const Eigen::Vector3d& place) {
  constexpr double kConeMm = 30.0, kHeadMm = 12.0, kRadiusMm = 10.0;
  const Eigen::Vector3d neck = place + kConeMm * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d top = neck + kHeadMm * Eigen::Vector3d::UnitZ();
  return surfaceOf({robot::Frustum{place, neck, 0.0, kRadiusMm},
                    robot::Frustum{neck, top, kRadiusMm, kRadiusMm}});
}

std::shared_ptr<const CellDrawing> drawn(const robot::Cell& cell, std::vector<CellPiece> arm) {
  auto drawing = std::make_shared<CellDrawing>(CellDrawing{cell, std::move(arm), {}, {}});
  if (cell.purgePlaceMm())
    drawing->purgePlace = pinAt(*cell.purgePlaceMm());
  addOthers(cell, drawing->pieces);
  for (const Body& body : cell.bodies())
    drawing->solids.push_back(surfaceOf(body.shapes));
  return drawing;
}

} // namespace

std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell, const robot::ArmLook& look) {
  return drawn(cell, drawnArm(cell, look));
}

std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell, const CellDrawing& before) {
  base::require(cell.robot().id == before.cell.robot().id, "the arm that was drawn before");
  std::vector<CellPiece> arm;
  for (const CellPiece& piece : before.pieces)
    if (before.cell.bodies()[piece.body].role == robot::BodyRole::Link)
      arm.push_back(piece);
  return drawn(cell, std::move(arm));
}

} // namespace voluta::scene
