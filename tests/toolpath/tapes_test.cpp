// Paths of tapes: closed forms on rectangles, rings and cylinders; invariants on any outline.
#include "toolpath/fibre/tape_paths.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "helpers/all_seeds.h"
#include "toolpath/fibre/tape_curves.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/patch_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::toolpath {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::Loop;

constexpr process::Tape kTape{.widthMm = 5.0,
                              .thicknessMm = 0.08,
                              .minLengthMm = 20.0,
                              .minBendRadiusMm = 30.0,
                              .cutAheadMm = 10.0};
constexpr double kEdgeMm = 1.0, kStepMm = 2.0;

TapePaths tapesOn(const layers::Patch& patch, const TapeChoice& choice,
                  const process::Tape& tape = kTape) {
  return tapePaths(PatchSurface::refine(patch, kEdgeMm), tape, choice, kStepMm, {});
}

// A rectangle about the origin, of even triangles, lifted.
layers::Patch evenPatch(double lengthMm, double widthMm, const test::Lift& lift = {}) {
  layers::Patch patch;
  const int nx = static_cast<int>(std::ceil(lengthMm)), ny = static_cast<int>(std::ceil(widthMm));
  const auto point = [&](double u, double v) -> Vector3d {
    const Vector2d p((u - 0.5) * lengthMm, (v - 0.5) * widthMm);
    return lift ? lift(p) : Vector3d(p.x(), p.y(), 0.4);
  };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const double u = static_cast<double>(i) / nx, v = static_cast<double>(j) / ny;
      patch.surface.vertices.push_back(point(u, v));
      constexpr double kStep = 1e-4;
      patch.direction.push_back((point(u + kStep, v) - point(u, v))
                                    .cross(point(u, v + kStep) - point(u, v))
                                    .normalized());
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + 1, c = a + nx + 2, d = a + nx + 1;
      patch.surface.triangles.push_back({a, b, c});
      patch.surface.triangles.push_back({a, c, d});
    }
  patch.thicknessMm.assign(patch.surface.vertices.size(), 0.8);
  patch.clearDirection = patch.direction;
  return patch;
}

double lengthOfAll(const TapePaths& tapes) {
  double length = 0.0;
  for (const SurfaceCurve& path : tapes.paths)
    length += lengthOf(path);
  return length;
}

// ---- rectangles

TEST(Tapes, AreOneWidthApartOnARectangle) {
  // 30 wide: six tapes of 5. They end half a width before the outline.
  for (const double angleDeg : {0.0, 90.0}) {
    const bool turned = angleDeg > 0.0;
    const layers::Patch patch = turned ? evenPatch(30, 120) : evenPatch(120, 30);
    const TapePaths tapes = tapesOn(patch, {.directionRad = base::degreesToRadians(angleDeg)});
    ASSERT_EQ(tapes.paths.size(), 6u);
    std::vector<double> offset;
    for (const SurfaceCurve& path : tapes.paths) {
      EXPECT_NEAR(lengthOf(path), 115.0, 0.1);
      const Vector3d& p = path.points.front().position;
      offset.push_back(turned ? p.x() : p.y());
      for (const SurfacePoint& q : path.points)
        EXPECT_NEAR(turned ? q.position.x() : q.position.y(), offset.back(), 1e-3);
    }
    std::ranges::sort(offset);
    for (std::size_t i = 0; i < offset.size(); ++i)
      EXPECT_NEAR(offset[i], -12.5 + 5.0 * static_cast<double>(i), 1e-3);
    EXPECT_NEAR(tapes.coveredMm2, 6 * 5.0 * 115.0, 0.03 * 6 * 5 * 115); // by triangles
    EXPECT_GT(tapes.coveredMm2, 0.99 * tapes.regionMm2);
    EXPECT_LT(tapes.overlapMm2, 0.002 * tapes.regionMm2);
    EXPECT_EQ(tapes.bentMm, 0.0);
  }
}

TEST(Tapes, ALimitedNumberIsInTheMiddleAndEndsBeforeTheOutline) {
  // Dai 5.4: a bar of 250 x 10 with a tape of 240 x 5.
  const TapePaths tapes = tapesOn(evenPatch(250, 10), {.maxCount = 1, .endMm = 5.0});
  ASSERT_EQ(tapes.paths.size(), 1u);
  EXPECT_NEAR(lengthOf(tapes.paths[0]), 240.0, 0.1);
  for (const SurfacePoint& p : tapes.paths[0].points)
    EXPECT_NEAR(p.position.y(), 0.0, 1e-3);
  EXPECT_GE(tapes.coveredMm2, 0.99 * tapes.regionMm2);
}

TEST(Tapes, TapesBeyondTheNumberDoNotCountAsShort) {
  // A triangle: all but the lines in the middle are too short.
  const layers::Patch patch = test::patchOver({Loop{{-40, -12}, {40, -12}, {0, 12}}}, 1.0);
  EXPECT_GT(tapesOn(patch, {}).shortMm, 0.0);
  const TapePaths one = tapesOn(patch, {.maxCount = 1});
  ASSERT_EQ(one.paths.size(), 1u);
  EXPECT_EQ(one.shortMm, 0.0);
}

TEST(Tapes, ShortOnesAreLeftOutAndTheirLengthIsReturned) {
  const layers::Patch patch = evenPatch(24, 30);
  const TapePaths tapes = tapesOn(patch, {}); // 19 long at most
  EXPECT_TRUE(tapes.paths.empty());
  EXPECT_GE(tapes.shortMm, 5 * 19.0 - 0.1);
  EXPECT_LE(tapes.shortMm, 6 * 19.0 + 0.1);
  EXPECT_EQ(tapes.regionMm2, 0.0);
  EXPECT_EQ(tapesOn(patch, {.directionRad = base::kPi / 2}).paths.size(), 4u);
}

// ---- contours

TEST(Tapes, FollowTheOutlineOfARing) {
  const layers::Patch ring = test::patchOver({test::circle(60), test::circle(30, true)}, 1.0);
  const TapePaths all = tapesOn(ring, {.paths = "contour"});
  ASSERT_EQ(all.paths.size(), 6u);
  EXPECT_NEAR(lengthOfAll(all), 2 * base::kPi * (57.5 + 52.5 + 47.5 + 32.5 + 37.5 + 42.5), 6.0);
  for (const SurfaceCurve& path : all.paths)
    EXPECT_TRUE(path.closed);
  EXPECT_GT(all.coveredMm2, 0.97 * base::kPi * (60.0 * 60 - 30 * 30));

  process::Tape stiff = kTape;
  stiff.minBendRadiusMm = 41.0;
  const TapePaths outer = tapesOn(ring, {.paths = "contour"}, stiff);
  EXPECT_EQ(outer.paths.size(), 4u);
  EXPECT_NEAR(outer.bentMm, 2 * base::kPi * (32.5 + 37.5), 4.0);
}

TEST(Tapes, AreCutAtCornersOfTheOutline) {
  const TapePaths tapes = tapesOn(evenPatch(120, 80), {.paths = "contour"});
  ASSERT_GE(tapes.paths.size(), 4u);
  EXPECT_GT(tapes.bentMm, 0.0);
  for (const SurfaceCurve& path : tapes.paths) {
    EXPECT_FALSE(path.closed);
    const Vector3d along =
        (path.points.back().position - path.points.front().position).normalized();
    EXPECT_GT(std::max(std::abs(along.x()), std::abs(along.y())), 0.999);
  }
}

// ---- curved layers

TEST(Tapes, RunAroundACylinder) {
  // Dai 5.4: a bar of 75 degrees at radius 60, 10 wide.
  const double arc = 60.0 * base::degreesToRadians(75.0);
  const layers::Patch patch = evenPatch(arc, 10, test::onCylinder(60.0));
  const TapePaths tapes = tapesOn(patch, {.maxCount = 1, .endMm = 0.5 * (arc - 68.0)});
  ASSERT_EQ(tapes.paths.size(), 1u);
  EXPECT_NEAR(lengthOf(tapes.paths[0]), 68.0, 0.2);
  const TapePaths two = tapesOn(patch, {});
  ASSERT_EQ(two.paths.size(), 2u);
  EXPECT_NEAR(lengthOfAll(two), 2 * (arc - 5.0), 0.4);
  EXPECT_EQ(two.bentMm, 0.0) << "the surface's own curvature bends no tape";
}

// ---- given curves

TEST(Tapes, FollowGivenCurvesAndGiveWayToEarlierOnes) {
  const layers::Patch patch = evenPatch(120, 120);
  TapeChoice choice{.paths = "curves"};
  choice.curves = tapeCurves("-80,10 80,10; 0,-80,5 0,80,5");
  const TapePaths tapes = tapesOn(patch, choice);
  ASSERT_EQ(tapes.paths.size(), 3u) << "the second curve in two pieces beside the first";
  EXPECT_NEAR(lengthOf(tapes.paths[0]), 115.0, 0.2);
  EXPECT_NEAR(lengthOfAll(tapes), 115.0 + 115.0 - 10.0, 1.5);
  EXPECT_EQ(tapes.overlapMm2, 0.0);
}

TEST(Tapes, CurvesAreReadOrRefused) {
  const auto curves = tapeCurves("0,0 50,10.5 80,-10,3 ; 1,2 3,4;");
  ASSERT_EQ(curves.size(), 2u);
  ASSERT_EQ(curves[0].size(), 3u);
  EXPECT_EQ(curves[0][1], Vector3d(50, 10.5, 0));
  EXPECT_EQ(curves[0][2], Vector3d(80, -10, 3));
  EXPECT_TRUE(tapeCurves("").empty());
  for (const char* bad : {"0,0", "0,0 1", "0,0 a,b", "0,0 1,2,3,4", "0,0 1,nan", "0,0 1,2,", "0 1"})
    EXPECT_THROW(tapeCurves(bad), base::Error) << bad;
  EXPECT_THROW(tapeKind("spiral"), base::Error);
  EXPECT_THROW(tapesOn(evenPatch(60, 30), {.paths = "curves"}), base::Error);
}

// Curves are followed in steps: farther ones would never end, or lose the steps on the part.
TEST(Tapes, PlacesBeyondAKilometreAreRefused) {
  EXPECT_EQ(tapeCurves("-1e6,0 1e6,0").size(), 1u);
  EXPECT_EQ(tapeField("0,0,1e6,1,0,0").size(), 1u);
  for (const char* far : {"-25,0 1e9,0", "-25,0 1e300,0", "0,0 0,-1000001", "0,0,0 0,0,2e6"})
    try {
      tapeCurves(far);
      ADD_FAILURE() << far;
    } catch (const base::Error& error) {
      const std::string line = error.what();
      EXPECT_NE(line.find("fibreCurves"), std::string::npos) << line;
      EXPECT_NE(line.find("kilometre"), std::string::npos) << line;
    }
  for (const char* far : {"1e9,0,0,1,0,0", "0,0,-1e300,1,0,0", "0,0,0,1e300,0,0"})
    EXPECT_THROW(tapeField(far), base::Error) << far;
}

// ---- fields

TEST(Tapes, OfAUniformFieldAreThoseOfItsDirection) {
  TapeChoice choice{.paths = "field"};
  choice.field = tapeField("0,0,0,2,0,0"); // of any length
  const TapePaths tapes = tapesOn(evenPatch(120, 30), choice);
  ASSERT_EQ(tapes.paths.size(), 6u);
  EXPECT_NEAR(lengthOfAll(tapes), 6 * 115.0, 1.0);
  for (const SurfaceCurve& path : tapes.paths)
    for (const SurfacePoint& p : path.points)
      EXPECT_NEAR(p.position.y(), path.points.front().position.y(), 1e-3);
}

TEST(Tapes, FollowAFieldAroundAHole) {
  TapeChoice choice{.paths = "field"};
  for (int i = 0; i < 48; ++i) {
    const double a = 2 * base::kPi * i / 48;
    for (const double r : {30.0, 45.0, 60.0})
      choice.field.push_back({Vector3d(r * std::cos(a), r * std::sin(a), 0.4),
                              Vector3d(-std::sin(a), std::cos(a), 0)});
  }
  const layers::Patch ring = test::patchOver({test::circle(60), test::circle(30, true)}, 1.0);
  process::Tape soft = kTape;
  soft.minBendRadiusMm = 20.0;
  const TapePaths tapes = tapesOn(ring, choice, soft);
  ASSERT_GE(tapes.paths.size(), 4u);
  EXPECT_GT(tapes.coveredMm2, 0.8 * tapes.regionMm2);
  EXPECT_LT(tapes.overlapMm2, 0.01 * tapes.regionMm2);
  for (const SurfaceCurve& path : tapes.paths) {
    const double radius = path.points.front().position.head<2>().norm();
    for (const SurfacePoint& p : path.points)
      EXPECT_NEAR(p.position.head<2>().norm(), radius, 1.5);
  }
}

TEST(Tapes, FieldsAreReadOrRefused) {
  const auto field = tapeField("0,0,0,2,0,0\n1,2,3,0,0,-4; 5,5,5,1,1,1\n");
  ASSERT_EQ(field.size(), 3u);
  EXPECT_EQ(field[1].place, Vector3d(1, 2, 3));
  EXPECT_EQ(field[1].direction, Vector3d(0, 0, -1));
  for (const char* bad : {"0,0,0,1,0", "0,0,0,0,0,0", "0,0,0,1,0,x", "0,0,0,1,0,0,-1"})
    EXPECT_THROW(tapeField(bad), base::Error) << bad;
  EXPECT_THROW(tapesOn(evenPatch(60, 30), {.paths = "field"}), base::Error);
}

// ---- any outline

// Returns a closed outline of `corners` corners about the origin; round or with corners.
Loop randomOutline(std::mt19937& random, double minimum, double maximum) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const int waves = 2 + static_cast<int>(random() % 4);
  std::vector<double> height(static_cast<std::size_t>(waves)), phase(height.size());
  for (std::size_t i = 0; i < height.size(); ++i) {
    height[i] = share(random) / static_cast<double>(i + 1);
    phase[i] = 2 * base::kPi * share(random);
  }
  const bool hasCorners = random() % 2 == 0;
  const int n = hasCorners ? 5 + static_cast<int>(random() % 5) : 200;
  const double size = minimum + (maximum - minimum) * share(random);
  Loop loop;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * base::kPi * i / n;
    double r = 1.0;
    for (std::size_t k = 0; k < height.size(); ++k)
      r += 0.25 * height[k] * std::sin(static_cast<double>(k + 2) * angle + phase[k]);
    loop.emplace_back(size * r * std::cos(angle), size * r * std::sin(angle));
  }
  return loop;
}

bool cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const auto side = [](const Vector2d& p, const Vector2d& q, const Vector2d& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

std::vector<std::pair<Vector2d, Vector2d>> segmentsOf(const SurfaceCurve& path) {
  std::vector<std::pair<Vector2d, Vector2d>> segments;
  for (std::size_t i = 1; i < path.points.size() + (path.closed ? 1 : 0); ++i)
    segments.emplace_back(path.points[i - 1].position.head<2>(),
                          path.points[i % path.points.size()].position.head<2>());
  return segments;
}

// Sides of one triangle only.
std::vector<std::pair<Vector2d, Vector2d>> outlineOf(const layers::Patch& patch) {
  std::vector<std::pair<Vector2d, Vector2d>> outline;
  const auto& v = patch.surface.vertices;
  for (const auto& side : PatchSurface::refine(patch, 1e6).boundary)
    outline.emplace_back(v[static_cast<std::size_t>(side[0])].head<2>(),
                         v[static_cast<std::size_t>(side[1])].head<2>());
  return outline;
}

double distanceTo(const std::vector<std::pair<Vector2d, Vector2d>>& outline, const Vector2d& p) {
  double minimum = 1e9;
  for (const auto& [a, b] : outline) {
    const Vector2d ab = b - a;
    const double t = std::clamp(ab.dot(p - a) / ab.squaredNorm(), 0.0, 1.0);
    minimum = std::min(minimum, (a + t * ab - p).norm());
  }
  return minimum;
}

void expectSound(const TapePaths& tapes, const layers::Patch& patch) {
  const std::vector<std::pair<Vector2d, Vector2d>> outline = outlineOf(patch);
  for (std::size_t i = 0; i < tapes.paths.size(); ++i) {
    const SurfaceCurve& path = tapes.paths[i];
    EXPECT_GE(lengthOf(path), kTape.minLengthMm - 0.05);
    for (const SurfacePoint& p : path.points)
      EXPECT_GE(distanceTo(outline, p.position.head<2>()), 0.48 * kTape.widthMm - 1e-3);
    const auto own = segmentsOf(path);
    for (std::size_t k = 0; k < i; ++k)
      for (const auto& [c, d] : segmentsOf(tapes.paths[k]))
        for (const auto& [a, b] : own)
          EXPECT_FALSE(cross(a, b, c, d)) << "tapes " << i << " and " << k;
    for (std::size_t k = 2; k < path.points.size(); ++k) {
      if (path.points.size() < 5)
        break;
      // over two steps, as tape follows no shorter bends
      const std::size_t last = std::min(k + 2, path.points.size() - 1), middle = (k - 2 + last) / 2;
      const double radius = bendRadius(path.points[k - 2].position, path.points[middle].position,
                                       path.points[last].position, Vector3d::UnitZ());
      EXPECT_GE(radius, 0.8 * kTape.minBendRadiusMm);
    }
  }
}

TEST(Tapes, KeepTheirRulesOnRandomOutlines) {
  const int outlines = test::ofSeeds(25, 100);
  std::mt19937 random(41);
  std::uniform_real_distribution<double> angle(0.0, base::kPi);
  double region = 0.0, covered = 0.0;
  int printed = 0;
  for (int i = 0; i < outlines; ++i) {
    SCOPED_TRACE(i);
    const Loop loop = randomOutline(random, 35.0, 60.0);
    const layers::Patch patch = test::patchOver({loop}, 2.0);
    const TapePaths tapes = tapesOn(patch, {.directionRad = angle(random)});
    expectSound(tapes, patch);
    EXPECT_LE(tapes.overlapMm2, 0.01 * tapes.regionMm2);
    EXPECT_GE(tapes.coveredMm2, 0.8 * tapes.regionMm2);
    region += tapes.regionMm2;
    covered += tapes.coveredMm2;
    printed += static_cast<int>(tapes.paths.size());
    if (i % 3 == 0)
      expectSound(tapesOn(patch, {.paths = "contour"}), patch);
  }
  EXPECT_GT(printed, 10 * outlines);
  EXPECT_GE(covered, 0.9 * region);
}

} // namespace
} // namespace voluta::toolpath
