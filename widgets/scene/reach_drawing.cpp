#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"

#include <cmath>

namespace voluta::scene {

namespace {

// Above the plate's top, to avoid z-fighting.
constexpr double kOverPlateMm = 0.05;

// Returns the part of a convex polygon on the left of the line from a to b.
std::vector<Eigen::Vector2d> leftOf(const std::vector<Eigen::Vector2d>& polygon,
                                    const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const auto side = [&](const Eigen::Vector2d& p) {
    return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
  };
  std::vector<Eigen::Vector2d> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double sp = side(p), sq = side(q);
    if (sp >= 0.0)
      left.push_back(p);
    if ((sp < 0.0) != (sq < 0.0))
      left.push_back(p + sp / (sp - sq) * (q - p));
  }
  return left;
}

} // namespace

std::shared_ptr<const ReachDrawing> drawReach(const std::vector<ReachPoint>& points,
                                              double spacingMm,
                                              const std::vector<Eigen::Vector2d>& plate) {
  auto drawing = std::make_shared<ReachDrawing>();
  MeshBuffers buffers;
  const double half = 0.5 * spacingMm;
  for (const ReachPoint& point : points) {
    const Eigen::Vector2d across(half, 0.0), along(0.0, half);
    std::vector<Eigen::Vector2d> square{point.at - across - along, point.at + across - along,
                                        point.at + across + along, point.at - across + along};
    for (std::size_t i = 0; i < plate.size() && !square.empty(); ++i)
      square = leftOf(square, plate[i], plate[(i + 1) % plate.size()]);
    const Colour colour = sequentialColour(point.share);
    std::vector<std::int32_t> corners;
    for (const Eigen::Vector2d& p : square) {
      corners.push_back(buffers.addPoint({p.x(), p.y(), kOverPlateMm}, Eigen::Vector3d::UnitZ()));
      for (const double part : colour)
        buffers.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0 * part)));
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
      buffers.addTriangle(corners[0], corners[i - 1], corners[i]);
  }
  drawing->surface = polyDataOf(buffers);
  return drawing;
}

Legend reachLegend() {
  constexpr int kStops = 5;
  Legend legend{"Reached poses"_text, "%", false, false, {}, {}};
  for (int i = 0; i < kStops; ++i) {
    const double share = static_cast<double>(i) / (kStops - 1);
    legend.entries.push_back(
        {100.0 * share, std::to_string(std::lround(100.0 * share)), sequentialColour(share)});
  }
  return legend;
}

} // namespace voluta::scene
