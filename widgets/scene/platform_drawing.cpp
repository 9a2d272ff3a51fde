#include "platform/platform_solid.h"
#include "platform/rod_shape.h"
#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>
#include <vtkAppendPolyData.h>
#include <vtkNew.h>

namespace voluta::scene {

namespace {

constexpr double kGridMm = 10.0;
constexpr double kPlateMm = 2.0;
constexpr double kTopMm = kPlateTopMm, kGroundMm = kTopMm - kPlateMm;

constexpr double kOverPlateMm = 0.03; // lines on the plate
constexpr int kMaxRules = 200;        // a larger plate has wider squares
constexpr double kAxisShare = 0.12;   // length of the axes at the origin, of the plate's edge
constexpr double kMinAxisMm = 10.0;

constexpr double kChordMm = 0.02;
constexpr double kLineOverRodMm = 0.05;

Eigen::Vector3d at(const Eigen::Vector2d& p, double z) {
  return {p.x(), p.y(), z};
}

Eigen::AlignedBox2d boxOf(const std::vector<Eigen::Vector2d>& polygon) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : polygon)
    box.extend(p);
  return box;
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

// Returns the part of the line at `at` across the axis `across` that is within the convex polygon.
std::optional<std::pair<double, double>> within(const std::vector<Eigen::Vector2d>& polygon,
                                                int across, double place) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = p[across] - place, b = q[across] - place;
    if (a * b > 0.0 || a == b)
      continue;
    const double along = p[1 - across] + a / (a - b) * (q[1 - across] - p[1 - across]);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  return low < high ? std::optional(std::pair(low, high)) : std::nullopt;
}

// Adds lines every 10 mm on the plate, through its origin, and the axes at the origin.
void addRuling(const std::vector<Eigen::Vector2d>& polygon, MeshBuffers& ruling, MeshBuffers& axisX,
               MeshBuffers& axisY) {
  const Eigen::AlignedBox2d box = boxOf(polygon);
  if (box.isEmpty())
    return;
  const double z = kTopMm + kOverPlateMm;
  double step = kGridMm;
  while (box.sizes().maxCoeff() > kMaxRules * step)
    step *= 10.0;
  for (int across = 0; across < 2; ++across)
    for (double at = step * std::ceil(box.min()[across] / step); at <= box.max()[across];
         at += step)
      if (const auto line = within(polygon, across, at)) {
        Eigen::Vector3d from(0.0, 0.0, z), to(0.0, 0.0, z);
        from[across] = to[across] = at;
        from[1 - across] = line->first;
        to[1 - across] = line->second;
        ruling.addLine(from, to);
      }
  const double length = std::max(kMinAxisMm, kAxisShare * box.sizes().maxCoeff());
  axisX.addLine({0.0, 0.0, 2.0 * kOverPlateMm + kTopMm},
                {length, 0.0, 2.0 * kOverPlateMm + kTopMm});
  axisY.addLine({0.0, 0.0, 2.0 * kOverPlateMm + kTopMm},
                {0.0, length, 2.0 * kOverPlateMm + kTopMm});
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
  MeshBuffers plate, outline, grid, ruling, axisX, axisY;
  addPlate(platform.polygon, plate, outline);
  for (const Eigen::Vector2d& p : platform.polygon)
    for (const double z : {kTopMm, kTopMm - kPlateMm})
      drawing->box.extend(at(p, z));
  if (platform.rod) {
    drawing->rod = drawPart(platform::meshOf(*platform.rod, kChordMm));
    addMark(*platform.rod, outline);
  } else {
    addGrid(groundRadiusMm, grid);
    addRuling(platform.polygon, ruling, axisX, axisY);
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
  drawing->ruling = polyDataOf(ruling);
  drawing->axisX = polyDataOf(axisX);
  drawing->axisY = polyDataOf(axisY);
  return drawing;
}

} // namespace voluta::scene
