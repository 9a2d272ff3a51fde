#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"

#include <cmath>

namespace voluta::scene {

namespace {

constexpr double kGridMm = 10.0;
constexpr double kPlateMm = 2.0;
// The part stands on z = 0; the plate's top lies just below, so that it does not flicker through
// the part's underside.
constexpr double kTopMm = -0.05, kGroundMm = kTopMm - kPlateMm;

Eigen::Vector3d at(const Eigen::Vector2d& p, double z) {
  return {p.x(), p.y(), z};
}

} // namespace

std::shared_ptr<const PlatformDrawing> drawPlatform(const std::vector<Eigen::Vector2d>& polygon,
                                                    double groundRadiusMm) {
  auto drawing = std::make_shared<PlatformDrawing>();
  drawing->polygon = polygon;
  MeshBuffers plate, outline, grid;
  const std::size_t n = polygon.size();
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  std::vector<std::int32_t> top, bottom;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % n];
    top.push_back(plate.addPoint(at(p, kTopMm), up));
    bottom.push_back(plate.addPoint(at(p, kTopMm - kPlateMm), -up));
    drawing->box.extend(at(p, kTopMm));
    drawing->box.extend(at(p, kTopMm - kPlateMm));
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
  const int lines = static_cast<int>(groundRadiusMm / kGridMm);
  for (int i = -lines; i <= lines; ++i) {
    const double x = i * kGridMm;
    const double half = std::sqrt(std::max(0.0, groundRadiusMm * groundRadiusMm - x * x));
    grid.addLine({x, -half, kGroundMm}, {x, half, kGroundMm});
    grid.addLine({-half, x, kGroundMm}, {half, x, kGroundMm});
  }
  drawing->plate = polyDataOf(plate);
  drawing->outline = polyDataOf(outline);
  drawing->grid = polyDataOf(grid);
  return drawing;
}

} // namespace voluta::scene
