// Corrected sizes of sections and layers.
#include "planar/slicing/size_correction.h"

#include "base/units.h"
#include "planar/slicing/corrected_mesh.h"
#include "planar/slicing/slicing.h"
#include "sliced_parts.h"

#include <gtest/gtest.h>
#include <map>
#include <random>

namespace voluta::planar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

void addLoop(Section& section, const std::vector<Vector2d>& loop) {
  const auto first = static_cast<int>(section.points.size()), n = static_cast<int>(loop.size());
  for (const Vector2d& p : loop)
    section.points.emplace_back(p.x(), p.y(), section.plane.offsetMm);
  for (int i = 0; i < n; ++i)
    section.edges.push_back({first + i, first + (i + 1) % n});
}

std::vector<Vector2d> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
std::vector<Vector2d> reversed(std::vector<Vector2d> loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

Section plateSection() {
  Section section;
  section.plane.normal = Vector3d::UnitZ();
  section.plane.offsetMm = 0.4;
  addLoop(section, rectangle(-25, -10, 25, 10));
  addLoop(section, reversed(rectangle(-2, -2.5, 8, 2.5)));
  return section;
}

// Returns the solid over a region on z = 0.
geometry::TriangleMesh standing(const std::vector<Vector2d>& points,
                                const std::vector<std::array<int, 2>>& edges, double heightMm) {
  const auto region = meshRegion(points, edges, 1e6);
  geometry::TriangleMesh mesh;
  const auto count = static_cast<int>(region->points.size());
  for (const double z : {0.0, heightMm})
    for (const Vector2d& p : region->points)
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  std::map<std::array<int, 2>, int> sides;
  for (const auto& t : region->triangles) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({count + t[0], count + t[1], count + t[2]});
    for (std::size_t k = 0; k < 3; ++k)
      sides[{t[k], t[(k + 1) % 3]}] = 1;
  }
  for (const auto& [side, one] : sides)
    if (!sides.contains({side[1], side[0]})) {
      mesh.triangles.push_back({side[0], side[1], count + side[1]});
      mesh.triangles.push_back({side[0], count + side[1], count + side[0]});
    }
  return mesh;
}

struct Span {
  double low = 1e9, high = -1e9;
  double length() const { return high - low; }
};
// Returns the extent along x of points whose |y| is below a limit.
Span alongX(const Section& section, double withinY, double minX = -1e9, double maxX = 1e9) {
  Span span;
  for (const Vector3d& p : section.points)
    if (std::abs(p.y()) <= withinY && p.x() > minX && p.x() < maxX) {
      span.low = std::min(span.low, p.x());
      span.high = std::max(span.high, p.x());
    }
  return span;
}

TEST(SizeCorrection, NeutralIsTheSameSection) {
  const Section section = plateSection(), same = corrected(section, {}, {0, 0});
  ASSERT_EQ(same.points.size(), section.points.size());
  for (std::size_t i = 0; i < section.points.size(); ++i)
    EXPECT_EQ(same.points[i], section.points[i]);
}

TEST(SizeCorrection, OutlinesAndHolesMoveByTheirOwn) {
  std::mt19937 random(1);
  const auto pick = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 200; ++i) {
    const SizeCorrection c{pick(0.99, 1.01), pick(0.99, 1.01), pick(-0.4, 0.4), pick(-0.4, 0.4)};
    const Section out = corrected(plateSection(), c, {0, 0});
    EXPECT_NEAR(alongX(out, 20).length(), 50.0 * c.scaleX + 2.0 * c.outlineMm, 2e-3);
    EXPECT_NEAR(alongX(out, 4, -10, 10).length(), 10.0 * c.scaleX + 2.0 * c.holeMm, 2e-3);
    EXPECT_NEAR(areaOf(out),
                (50.0 * c.scaleX + 2.0 * c.outlineMm) * (20.0 * c.scaleY + 2.0 * c.outlineMm) -
                    (10.0 * c.scaleX + 2.0 * c.holeMm) * (5.0 * c.scaleY + 2.0 * c.holeMm),
                0.1);
  }
}

TEST(SizeCorrection, ARoundHoleStaysRound) {
  constexpr int kAround = 192;
  Section section;
  section.plane.normal = Vector3d::UnitZ();
  addLoop(section, rectangle(-20, -20, 20, 20));
  std::vector<Vector2d> circle;
  for (int i = 0; i < kAround; ++i) {
    const double angle = -2.0 * base::kPi * i / kAround;
    circle.emplace_back(5.0 * std::cos(angle), 5.0 * std::sin(angle));
  }
  addLoop(section, circle);
  const Section out = corrected(section, {1, 1, 0, 0.2}, {0, 0});
  EXPECT_NEAR(std::sqrt((1600.0 - areaOf(out)) / base::kPi), 5.2, 2e-3);
}

TEST(SizeCorrection, AnIslandInAHoleIsAnOutline) {
  Section section;
  section.plane.normal = Vector3d::UnitZ();
  addLoop(section, rectangle(-20, -20, 20, 20));
  addLoop(section, reversed(rectangle(-12, -12, 12, 12)));
  addLoop(section, rectangle(-4, -4, 4, 4));
  const Section out = corrected(section, {1, 1, 0.5, 0.25}, {0, 0});
  EXPECT_NEAR(areaOf(out), 41.0 * 41.0 - 24.5 * 24.5 + 9.0 * 9.0, 0.02);
}

TEST(SizeCorrection, ATiltedSectionIsUnchanged) {
  Section section = plateSection();
  section.plane.normal = Vector3d(0, 0.6, 0.8);
  EXPECT_EQ(corrected(section, {1.1, 1.1, 0.5, 0.5}, {0, 0}).points, section.points);
}

// The mesh that a replay judges has the sections of the layers.
TEST(SizeCorrection, ACorrectedMeshHasTheCorrectedSections) {
  std::mt19937 random(5);
  const auto pick = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 100; ++i) {
    // A plate with a hole of many sides and a slot, upright along z.
    const int around = 8 + i;
    std::vector<Vector2d> points = rectangle(-30, -20, 30, 20);
    std::vector<std::array<int, 2>> edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * base::kPi * k / around;
      points.emplace_back(-15.0 + 6.0 * std::cos(angle), 6.0 * std::sin(angle));
      edges.push_back({4 + k, 4 + (k + 1) % around});
    }
    const geometry::TriangleMesh plate = standing(points, edges, 5.0);
    const SizeCorrection c{pick(0.99, 1.01), pick(0.99, 1.01), pick(-0.3, 0.3), pick(-0.3, 0.3)};
    const geometry::TriangleMesh mesh = correctedMesh(plate, c);
    const Sections before(plate, Vector3d::UnitZ()), after(mesh, Vector3d::UnitZ());
    EXPECT_NEAR(areaOf(after.at(2.3)), areaOf(corrected(before.at(2.3), c, {0, 0})), 0.05) << i;
  }
}

TEST(SizeCorrection, LayersAreScaledAboutTheirMiddle) {
  // A box from x = 10 to 50, 20 deep, 8 high.
  const geometry::TriangleMesh box = prism({{10, 0}, {50, 0}, {50, 8}, {10, 8}}, 20.0);
  SliceOptions options;
  options.sizes = {1.01, 1.02, 0.1, 0.0};
  const SliceResult sliced = slicePieces({pieceOf(box)}, options, base::RunContext());
  Eigen::AlignedBox3d bounds;
  for (const layers::Patch& patch : sliced.stack.patches)
    for (const Vector3d& v : patch.surface.vertices)
      bounds.extend(v);
  EXPECT_NEAR(bounds.sizes().x(), 40.0 * 1.01 + 0.2, 2e-3);
  EXPECT_NEAR(bounds.sizes().y(), 20.0 * 1.02 + 0.2, 2e-3);
  EXPECT_NEAR(bounds.center().x(), 30.0, 2e-3);
  EXPECT_NEAR(bounds.center().y(), 10.0, 2e-3);
}

} // namespace
} // namespace voluta::planar
