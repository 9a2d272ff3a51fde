// Lines around, along and across rods. Places are measured from positions alone, not from charts.
#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "helpers/all_seeds.h"
#include "helpers/rod_level.h"
#include "layers/patches.h"
#include "process/bead_model.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/infill.h"
#include "toolpath/infill/periodic_isolines.h"
#include "toolpath/patch_shapes.h"
#include "toolpath/surface_fields.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <thread>

namespace {
using namespace voluta;
using Eigen::Vector3d;

using base::kPi;
constexpr double kRadius = 3.625, kLength = 50.0;

double angleOf(const Vector3d& p) {
  return std::atan2(p.z(), p.y());
}

// A level around the rod, cut down to where `inside` is positive.
template <typename Inside> layers::Patch rodPatch(Inside&& inside) {
  layers::LevelSurface s = test::rodLevel(kRadius, -0.5 * kLength, 0.5 * kLength, 0.3, 0.25);
  std::vector<double> values;
  for (const Vector3d& p : s.surface.vertices)
    values.push_back(inside(p));
  layers::keepPositive(s, values);
  layers::PatchesOfLevel all = layers::makePatches(s, {0.7});
  EXPECT_EQ(all.patches.size(), 1u);
  layers::Patch patch = all.patches.at(0);
  patch.innerRim.clear(); // its boundary is the part's
  return patch;
}
layers::Patch whole() {
  return rodPatch([](const Vector3d&) { return 1.0; });
}
layers::Patch halfRevolution() {
  return rodPatch([](const Vector3d& p) { return p.z(); });
}
layers::Patch withHole() {
  return rodPatch(
      [](const Vector3d& p) { return p.y() < 0 ? std::hypot(p.x() - 3.0, p.z()) - 2.0 : 1.0; });
}

// Turns from its first point to its last, and its longest step.
struct Course {
  double turns = 0.0, longestMm = 0.0;
};
Course courseOf(const std::vector<Vector3d>& p) {
  Course c;
  for (std::size_t i = 1; i < p.size(); ++i) {
    c.turns += std::remainder(angleOf(p[i]) - angleOf(p[i - 1]), 2 * kPi) / (2 * kPi);
    c.longestMm = std::max(c.longestMm, (p[i] - p[i - 1]).norm());
  }
  return c;
}
std::vector<Vector3d> positions(const toolpath::SurfaceCurve& c) {
  std::vector<Vector3d> p;
  for (const auto& q : c.points)
    p.push_back(q.position);
  return p;
}

// Where polylines pass an angle, by place along the axis.
std::vector<double> passesAtAngle(const std::vector<std::vector<Vector3d>>& lines, double angle) {
  std::vector<double> x;
  for (const auto& p : lines)
    for (std::size_t i = 1; i < p.size(); ++i) {
      const double a = std::remainder(angleOf(p[i - 1]) - angle, 2 * kPi),
                   b = std::remainder(angleOf(p[i]) - angle, 2 * kPi);
      if (std::abs(a) < 1 && a * b <= 0 && a != b)
        x.push_back(p[i - 1].x() + (p[i].x() - p[i - 1].x()) * a / (a - b));
    }
  std::ranges::sort(x);
  const auto same = std::ranges::unique(x, [](double a, double b) { return b - a < 1e-6; });
  x.erase(same.begin(), same.end());
  return x;
}
// Where they pass a place along the axis, by angle.
std::vector<double> passesAtPlace(const std::vector<std::vector<Vector3d>>& lines, double x) {
  std::vector<double> angles;
  for (const auto& p : lines)
    for (std::size_t i = 1; i < p.size(); ++i) {
      const double a = p[i - 1].x() - x, b = p[i].x() - x;
      if (a * b <= 0 && a != b)
        angles.push_back(angleOf(p[i - 1] + (p[i] - p[i - 1]) * (a / (a - b))));
    }
  std::ranges::sort(angles);
  const auto same = std::ranges::unique(angles, [](double a, double b) { return b - a < 1e-6; });
  angles.erase(same.begin(), same.end());
  return angles;
}

std::vector<std::vector<Vector3d>> allPositions(const std::vector<toolpath::SurfaceCurve>& curves) {
  std::vector<std::vector<Vector3d>> all;
  for (const auto& c : curves)
    all.push_back(positions(c));
  return all;
}

TEST(PeriodicIsolines, AHelixIsOneCurveFromEndToEnd) {
  const auto s = toolpath::PatchSurface::refine(whole(), 0.3);
  const int turns = 77;
  const double pitch = kLength / turns;
  const auto curves =
      toolpath::periodicIsolines(s, {-1.0 / s.chart.periodMm, 1.0 / pitch, 0.5 * kLength / pitch});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_FALSE(curves[0].closed);
  const Course course = courseOf(positions(curves[0]));
  EXPECT_NEAR(std::abs(course.turns), turns, 1e-3);
  EXPECT_LT(course.longestMm, 0.31);
  for (const double angle : {0.1, 1.7, 3.1, kPi, -3.1, -1.2}) {
    const auto x = passesAtAngle({positions(curves[0])}, angle);
    EXPECT_NEAR(static_cast<double>(x.size()), turns, 1.0);
    for (std::size_t i = 1; i < x.size(); ++i)
      EXPECT_NEAR((x[i] - x[i - 1]) / pitch, 1.0, 1e-4);
  }
}

TEST(PeriodicIsolines, LinesAlongAreEven) {
  const auto s = toolpath::PatchSurface::refine(whole(), 0.3);
  const int n = 35;
  const auto curves = toolpath::periodicIsolines(s, {n / s.chart.periodMm, 0.0, 0.0});
  ASSERT_EQ(curves.size(), static_cast<std::size_t>(n));
  const auto angles = passesAtPlace(allPositions(curves), 1.234);
  ASSERT_EQ(angles.size(), static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * kPi;
    EXPECT_NEAR((next - angles[i]) * n / (2 * kPi), 1.0, 1e-4);
  }
  for (const auto& c : curves)
    EXPECT_NEAR(toolpath::lengthOf(c), kLength, 1e-2);
}

TEST(PeriodicIsolines, AnInclinedFieldCloses) {
  const auto s = toolpath::PatchSurface::refine(whole(), 0.3);
  const int starts = 17; // 30 degrees at a spacing of 0.67 mm
  const auto curves = toolpath::periodicIsolines(
      s, {starts / s.chart.periodMm, std::sqrt(3.0) * starts / s.chart.periodMm, 0.2});
  EXPECT_EQ(curves.size(), static_cast<std::size_t>(starts));
  for (const auto& c : curves) {
    EXPECT_FALSE(c.closed);
    const auto p = positions(c);
    EXPECT_NEAR(std::abs(p.back().x() - p.front().x()), kLength, 1e-6);
    EXPECT_LT(courseOf(p).longestMm, 0.35);
  }
}

TEST(PeriodicIsolines, RingsClose) {
  const auto s = toolpath::PatchSurface::refine(whole(), 0.3);
  const auto curves = toolpath::periodicIsolines(s, {0.0, 0.2, 0.05});
  ASSERT_EQ(curves.size(), 10u);
  for (const auto& c : curves) {
    EXPECT_TRUE(c.closed);
    EXPECT_NEAR(toolpath::lengthOf(c), 2 * kPi * kRadius, 0.02);
  }
}

TEST(PeriodicIsolines, AHoleCutsLinesAndASectorEndsThem) {
  const toolpath::Winding helix{-1.0 / (2 * kPi * kRadius), 2.0, 0.0};
  const auto holed = toolpath::PatchSurface::refine(withHole(), 0.3);
  const auto cut = toolpath::periodicIsolines(holed, helix);
  EXPECT_GE(cut.size(), 7u); // the hole is 4 mm long
  EXPECT_LE(cut.size(), 10u);
  for (const auto& c : cut)
    for (const auto& p : positions(c))
      EXPECT_TRUE(p.y() > 0 || std::hypot(p.x() - 3.0, p.z()) > 1.95);
  const auto half = toolpath::PatchSurface::refine(halfRevolution(), 0.3);
  const auto arcs = toolpath::periodicIsolines(half, helix);
  EXPECT_NEAR(static_cast<double>(arcs.size()), 100.0, 1.0);
  for (const auto& c : arcs) {
    EXPECT_FALSE(c.closed);
    EXPECT_LE(std::abs(courseOf(positions(c)).turns), 0.51);
    for (const auto& p : positions(c))
      EXPECT_GT(p.z(), -1e-6);
  }
}

process::Process thin() {
  process::Process p;
  p.beadWidthMm = 0.7;
  p.beadWidthMinMm = 0.35;
  p.beadWidthMaxMm = 1.05;
  p.layerHeightMm = 0.25;
  return p;
}

toolpath::PatchCover cover(const layers::Patch& patch, const char* infill, int walls = 2) {
  toolpath::ToolpathOptions o;
  o.infill = infill;
  o.walls = walls;
  o.windingAngleDeg = 30.0;
  o.strands = test::oneDirection;
  return toolpath::coverPatch(patch, thin(), o, base::RunContext{});
}

std::vector<std::vector<Vector3d>> infillOf(const toolpath::PatchCover& c) {
  std::vector<std::vector<Vector3d>> lines;
  for (const toolpath::Bead& b : c.beads)
    if (b.kind == plan::PathKind::Infill) {
      lines.emplace_back();
      for (const toolpath::BeadPoint& p : b.points)
        lines.back().push_back(p.middle);
    }
  return lines;
}

const double kHatch = process::hatchOf(0.7, 0.25);

TEST(WoundInfill, EveryRowOfTheTableFillsRodsSectorsAndHoles) {
  layers::Patch patches[] = {whole(), halfRevolution(), withHole()};
  for (const toolpath::InfillKind& kind : toolpath::infillKinds())
    for (std::size_t i = 0; i < 3; ++i)
      for (int layer = test::ofSeeds(static_cast<int>(i % 2), 0); layer < 2;
           layer += test::ofSeeds(2, 1)) {
        SCOPED_TRACE(std::string(kind.id) + " of patch " + std::to_string(i) + ", layer " +
                     std::to_string(layer));
        patches[i].layer = layer;
        const auto c = cover(patches[i], std::string(kind.id).c_str());
        EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.985);
        EXPECT_NEAR(c.beadVolumeMm3 / c.volumeMm3, 1.0, 0.005);
      }
}

// Lines so fine that a layer of them takes minutes.
TEST(WoundInfill, EveryRowOfTheTableCancelsWithinALayer) {
  const auto s = toolpath::PatchSurface::refine(whole(), 0.5);
  std::vector<double> depth = toolpath::distanceToSegments(s, toolpath::boundarySegments(s), 1e9);
  constexpr double kFine = 0.002;
  for (double& d : depth)
    d /= kFine;
  const std::vector<double> hatchMm(depth.size(), kFine);
  for (const toolpath::InfillKind& kind : toolpath::infillKinds()) {
    SCOPED_TRACE(kind.id);
    const base::CancelToken token;
    std::jthread user([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      token.cancel();
    });
    const toolpath::StrandDyads strands = test::oneDirection;
    EXPECT_THROW(
        kind.fill({s, depth, hatchMm, 1.0, 0, 0.0, 0.5, 1.0, &strands}, base::RunContext(token, 1)),
        base::Cancelled);
  }
}

TEST(WoundInfill, AroundIsOnePathWithoutATravelAtTheSeam) {
  for (const int walls : {0, 1, 2}) {
    SCOPED_TRACE(walls);
    const auto c = cover(whole(), "around", walls);
    const auto lines = infillOf(c);
    ASSERT_EQ(lines.size(), 1u);
    const Course course = courseOf(lines[0]);
    // The region's length in pitches, and half a turn of those that narrow down at either end.
    const double turns = (kLength - 2 * walls * kHatch) / kHatch;
    EXPECT_NEAR(std::abs(course.turns), turns, 0.1);
    EXPECT_LT(course.longestMm, 1.001);
    for (const double angle : {0.1, 1.7, kPi, -1.2}) {
      const auto x = passesAtAngle(lines, angle);
      for (std::size_t i = 3; i + 3 < x.size(); ++i)
        EXPECT_NEAR((x[i] - x[i - 1]) / kHatch, 1.0, 0.02);
    }
  }
}

TEST(WoundInfill, ItsFirstAndLastTurnsStayBetweenTheEndAndTheNextTurn) {
  const auto lines = infillOf(cover(whole(), "around", 0));
  ASSERT_EQ(lines.size(), 1u);
  const double end = 0.5 * kLength;
  int narrowed = 0;
  for (const double angle : {0.1, 0.9, 1.7, 2.5, kPi, -0.7, -1.5, -2.3}) {
    const auto x = passesAtAngle(lines, angle);
    ASSERT_GT(x.size(), 10u);
    // Next to the end there is a whole bead, or one that ends where the next turn's begins.
    const double fromEnd = x.front() + end, next = x[1] - 0.5 * kHatch + end;
    EXPECT_GT(fromEnd, 0.2 * kHatch);
    EXPECT_LT(fromEnd, 1.01 * kHatch);
    if (fromEnd < 0.499 * kHatch) {
      EXPECT_NEAR(2 * fromEnd, next, 0.02 * kHatch);
      ++narrowed;
    }
    const double toEnd = end - x.back(), before = end - x[x.size() - 2] - 0.5 * kHatch;
    EXPECT_LT(toEnd, 1.01 * kHatch);
    if (toEnd < 0.499 * kHatch) {
      EXPECT_NEAR(2 * toEnd, before, 0.02 * kHatch);
      ++narrowed;
    }
  }
  EXPECT_GE(narrowed, 6); // half a turn at either end, seen at eight angles
}

TEST(WoundInfill, AlongIsEvenAndWovenTakesTurns) {
  layers::Patch patch = whole();
  const double n = std::round(2 * kPi * kRadius / kHatch);
  const auto spacingsAt = [&](const std::vector<std::vector<Vector3d>>& lines) {
    const auto angles = passesAtPlace(lines, 1.234);
    EXPECT_EQ(static_cast<double>(angles.size()), n);
    for (std::size_t i = 1; i < angles.size(); ++i)
      EXPECT_NEAR((angles[i] - angles[i - 1]) * n / (2 * kPi), 1.0, 0.02);
  };
  const auto along = cover(patch, "along");
  spacingsAt(infillOf(along));
  EXPECT_EQ(infillOf(along).size(), 1u); // lines are joined at their ends, all around
  // Away from the ends, beads are as wide as their spacing.
  double narrowest = 1.0, widest = 0.0;
  for (const toolpath::Bead& b : along.beads)
    for (const toolpath::BeadPoint& p : b.points)
      if (b.kind == plan::PathKind::Infill && std::abs(p.middle.x()) < 20.0) {
        narrowest = std::min(narrowest, p.widthMm);
        widest = std::max(widest, p.widthMm);
      }
  EXPECT_LT(widest / narrowest, 1.08);
  const auto around = infillOf(cover(patch, "woven"));
  ASSERT_EQ(around.size(), 1u);
  EXPECT_GT(std::abs(courseOf(around[0]).turns), 70.0);
  patch.layer = 1;
  spacingsAt(infillOf(cover(patch, "woven")));
}

TEST(WoundInfill, HelicalKeepsAngleAndSpacingAndCloses) {
  const auto lines = infillOf(cover(whole(), "helical"));
  const double starts = std::round(2 * kPi * kRadius * 0.5 / kHatch);
  // Across a circle in the middle, and along a line of the rod.
  const auto angles = passesAtPlace(lines, 0.3);
  ASSERT_EQ(static_cast<double>(angles.size()), starts);
  for (std::size_t i = 1; i < angles.size(); ++i)
    EXPECT_NEAR((angles[i] - angles[i - 1]) * starts / (2 * kPi), 1.0, 0.02);
  auto x = passesAtAngle(lines, 2.0);
  std::erase_if(x, [](double v) { return std::abs(v) > 18.0; });
  ASSERT_GT(x.size(), 10u);
  const double alongRod = (x.back() - x.front()) / static_cast<double>(x.size() - 1),
               aroundRod = 2 * kPi * kRadius / starts;
  const double spacing = 1.0 / std::hypot(1.0 / alongRod, 1.0 / aroundRod);
  EXPECT_NEAR(spacing / kHatch, 1.0, 0.02);
  EXPECT_NEAR(std::atan2(alongRod, aroundRod), kPi / 6, 0.09);
}

TEST(WoundInfill, ASectorIsFilledWithoutABeadInTheGap) {
  for (const char* infill : {"around", "along", "helical"}) {
    SCOPED_TRACE(infill);
    const auto lines = infillOf(cover(halfRevolution(), infill));
    ASSERT_FALSE(lines.empty());
    for (const auto& line : lines)
      for (const Vector3d& p : line)
        EXPECT_GT(p.z(), 1.0);
  }
}

} // namespace
