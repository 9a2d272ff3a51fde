#include "platform/platform_solid.h"
#include "platform/rod_shape.h"
#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"

#include <algorithm>
#include <cmath>
#include <vtkAppendPolyData.h>
#include <vtkNew.h>

namespace voluta::scene {

namespace {

constexpr double kGridMm = 10.0;
constexpr double kPlateMm = 2.0;
constexpr double kTopMm = kPlateTopMm, kGroundMm = kTopMm - kPlateMm;

constexpr double kChordMm = 0.02;
constexpr double kLineOverRodMm = 0.05;

Eigen::Vector3d at(const Eigen::Vector2d& p, double z) {
  return {p.x(), p.y(), z};
}

void addPlate(const std::vector<Eigen::Vector2d>& polygon, MeshBuffers& plate,
              MeshBuffers& outline) {
  const std::size_t n = polygon.size();
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  std::vector<std::int32_t> top, bottom;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % n];
    top.push_back(plate.addPoint(at(p, kTopMm), up));
    bottom.push_back(plate.addPoint(at(p, kTopMm - kPlateMm), -up));
    const Eigen::Vector2d along = (q - p).normalized();
    const Eigen::Vector3d out(along.y(), -along.x(), 0.0);
    const auto a = plate.addPoint(at(p, kTopMm), out);
    const auto b = plate.addPoint(at(p, kTopMm - kPlateMm), out);
    const auto c = plate.addPoint(at(q, kTopMm - kPlateMm), out);
    const auto d = plate.addPoint(at(q, kTopMm), out);
    plate.addQuad(a, b, c, d);
    outline.addLine(at(p, kTopMm), at(q, kTopMm));
  }
  for (std::size_t i = 2; i < n; ++i) {
    plate.addTriangle(top[0], top[i - 1], top[i]);
    plate.addTriangle(bottom[0], bottom[i], bottom[i - 1]);
  }
}

void addGrid(double radiusMm, MeshBuffers& grid) {
  const int lines = static_cast<int>(radiusMm / kGridMm);
  for (int i = -lines; i <= lines; ++i) {
    const double x = i * kGridMm;
    const double half = std::sqrt(std::max(0.0, radiusMm * radiusMm - x * x));
    grid.addLine({x, -half, kGroundMm}, {x, half, kGroundMm});
    grid.addLine({-half, x, kGroundMm}, {half, x, kGroundMm});
  }
}

// Adds a line along the rod's profile at angle 0.
void addMark(const platform::RodShape& rod, MeshBuffers& outline) {
  for (std::size_t i = 1; i < rod.profile.size(); ++i) {
    const Eigen::Vector2d &p = rod.profile[i - 1], &q = rod.profile[i];
    outline.addLine({p.x(), p.y() + kLineOverRodMm, 0.0}, {q.x(), q.y() + kLineOverRodMm, 0.0});
  }
}

} // namespace

std::shared_ptr<const PlatformDrawing> drawPlatform(const platform::PlatformSolid& platform,
                                                    double groundRadiusMm) {
  auto drawing = std::make_shared<PlatformDrawing>();
  drawing->polygon = platform.polygon;
  MeshBuffers plate, outline, grid;
  addPlate(platform.polygon, plate, outline);
  for (const Eigen::Vector2d& p : platform.polygon)
    for (const double z : {kTopMm, kTopMm - kPlateMm})
      drawing->box.extend(at(p, z));
  if (platform.rod) {
    drawing->rod = drawPart(platform::meshOf(*platform.rod, kChordMm));
    addMark(*platform.rod, outline);
  } else {
    addGrid(groundRadiusMm, grid);
  }
  if (platform.mesh) {
    drawing->body = drawPart(*platform.mesh);
    drawing->box.extend(drawing->body->box);
  }
  vtkNew<vtkAppendPolyData> lines;
  lines->AddInputData(polyDataOf(outline));
  for (const auto& solid : {drawing->rod, drawing->body})
    if (solid)
      lines->AddInputData(solid->edges);
  lines->Update();
  drawing->outline = lines->GetOutput();
  drawing->outline->ComputeBounds();
  drawing->plate = polyDataOf(plate);
  drawing->grid = polyDataOf(grid);
  return drawing;
}

} // namespace voluta::scene
