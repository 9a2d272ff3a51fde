#include "base/units.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/infill.h"
#include "toolpath/patch_shapes.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(SurfaceFields, DistanceToTheRimOfACapIsThatOfTheSphere) {
  const double r = 20, rim = r * base::kPi / 3;
  const auto s = toolpath::PatchSurface::refine(
      test::patchOver({test::circle(rim)}, 0.8, test::onSphere(r)), 0.5);
  const auto d = toolpath::distanceToSegments(s, toolpath::boundarySegments(s), 1e9);
  for (std::size_t v = 0; v < d.size(); ++v) {
    const double expected = rim - r * std::acos(std::clamp(s.position[v].z() / r, -1.0, 1.0));
    // The mesh's rim is a polygon cut from a lattice: not the circle itself.
    EXPECT_NEAR(d[v], expected, 0.1 + 0.01 * expected);
  }
}

TEST(SurfaceFields, DistanceToASectionHasUnitGradientOnACap) {
  const double r = 20;
  const auto s = toolpath::PatchSurface::refine(
      test::patchOver({test::circle(r * base::kPi / 3)}, 0.8, test::onSphere(r)), 0.5);
  const auto u = toolpath::distanceToSection(s, Vector3d::UnitX(), 0.0);
  ASSERT_EQ(u.size(), s.position.size());
  for (std::size_t v = 0; v < u.size(); ++v)
    EXPECT_NEAR(u[v], r * std::asin(std::clamp(s.position[v].x() / r, -1.0, 1.0)), 0.12);
}

TEST(SurfaceFields, IsolinesOfALinearFieldAreStraightAndWhole) {
  const auto s = toolpath::PatchSurface::refine(test::patchOver({test::rectangle(20, 10)}), 0.5);
  std::vector<double> x(s.position.size());
  for (std::size_t v = 0; v < x.size(); ++v)
    x[v] = s.position[v].x();
  const auto lines = toolpath::isolines(s, x, 3.21);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].closed);
  EXPECT_NEAR(toolpath::lengthOf(lines[0]), 10.0, 1e-9);
  for (const auto& p : lines[0].points)
    EXPECT_NEAR(p.position.x(), 3.21, 1e-9);
}

TEST(Infill, LinesOnACapAreEvenlySpacedOnTheSphere) {
  const double r = 20, hatch = 1.0;
  const auto s = toolpath::PatchSurface::refine(
      test::patchOver({test::circle(r * base::kPi / 3)}, 0.8, test::onSphere(r)), 0.5);
  const std::vector<double> depth =
      toolpath::distanceToSegments(s, toolpath::boundarySegments(s), 1e9);
  const std::vector<double> hatches(depth.size(), hatch);
  const auto curves =
      toolpath::zigzagInfill({s, depth, hatches, 2.0, 0, -0.25 * base::kPi}, {}).curves;
  // Angle over the great circle through the guide's middle: u / r of every point far from an end.
  const Vector3d normal = Vector3d(1, 1, 0).normalized();
  std::vector<double> u;
  for (const auto& c : curves)
    for (const auto& p : c.points) {
      const Vector3d q = p.position;
      if (std::abs(q.dot(Vector3d(-1, 1, 0).normalized())) < 3)
        u.push_back(r * std::asin(q.dot(normal) / r));
    }
  std::ranges::sort(u);
  std::vector<double> lines; // means of clusters
  for (std::size_t i = 0; i < u.size();) {
    std::size_t j = i;
    double sum = 0;
    while (j < u.size() && u[j] - u[i] < 0.4)
      sum += u[j++];
    lines.push_back(sum / static_cast<double>(j - i));
    i = j;
  }
  ASSERT_GT(lines.size(), 30u);
  const double mean = (lines.back() - lines.front()) / static_cast<double>(lines.size() - 1);
  EXPECT_NEAR(mean, hatch, 0.02 * hatch);
  for (std::size_t i = 2; i + 1 < lines.size(); ++i)
    EXPECT_NEAR(lines[i] - lines[i - 1], mean, 0.03);
}

TEST(CurveTools, ResampledStepsAreEvenAndKeepCorners) {
  const auto s = toolpath::PatchSurface::refine(test::patchOver({test::rectangle(20, 20)}), 0.5);
  toolpath::SurfaceCurve square;
  square.closed = true;
  for (const Vector2d& c : {Vector2d(-6, -6), Vector2d(6, -6), Vector2d(6, 6), Vector2d(-6, 6)})
    square.points.push_back(s.project(Vector3d(c.x(), c.y(), 0.4), 0));
  toolpath::SurfaceCurve fine;
  fine.closed = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (int k = 0; k < 40; ++k)
      fine.points.push_back(
          s.project(square.points[i].position +
                        (square.points[(i + 1) % 4].position - square.points[i].position) * k / 40,
                    square.points[i].triangle));
  toolpath::ResampleOptions o;
  o.stepMm = 0.9;
  const auto r = toolpath::resample(s, fine, o);
  EXPECT_NEAR(toolpath::lengthOf(r.curve), 48.0, 1e-6);
  EXPECT_EQ(std::ranges::count(r.corner, 1), 4);
  for (std::size_t i = 0; i < r.curve.points.size(); ++i) {
    const double step =
        (r.curve.points[(i + 1) % r.curve.points.size()].position - r.curve.points[i].position)
            .norm();
    EXPECT_NEAR(step, 12.0 / 14, 1e-6);
  }
}

TEST(CurveTools, ALoopShorterThanAStepStaysALoop) {
  const auto s = toolpath::PatchSurface::refine(test::patchOver({test::rectangle(20, 20)}), 0.5);
  toolpath::SurfaceCurve tiny;
  tiny.closed = true;
  for (const Vector2d& c : {Vector2d(0, 0), Vector2d(0.05, 0), Vector2d(0.05, 0.05)})
    tiny.points.push_back(s.project(Vector3d(c.x(), c.y(), 0.4), 0));
  toolpath::ResampleOptions o;
  o.stepMm = 0.9;
  const auto r = toolpath::resample(s, tiny, o);
  EXPECT_TRUE(r.curve.closed);
  EXPECT_GE(r.curve.points.size(), 3u);
  EXPECT_EQ(r.corner.size(), r.curve.points.size());
}

// A search of the triangles that a level may cross gives the same as a search of all of them, to
// the bit; levels beyond the values are empty.
TEST(SurfaceFields, EvenIsolinesAreThoseOfEachLevel) {
  const auto s = toolpath::PatchSurface::refine(
      test::patchOver({test::star(5, 18, 9)}, 0.8, test::onSaddle(30)), 0.7);
  std::vector<double> values;
  for (const Vector3d& p : s.position)
    values.push_back(p.x() + 0.3 * p.y() * p.y());
  const auto [low, high] = std::ranges::minmax(values);
  const int count = 23;
  const double spacing = 1.3 * (high - low) / count, from = low - 0.1 * (high - low);
  const toolpath::EvenIsolines even(s, values, from, spacing, count);
  std::size_t found = 0;
  for (int k = 0; k < count; ++k) {
    const auto one = toolpath::isolines(s, values, from + (k + 0.5) * spacing);
    const auto same = even.curvesAt(k);
    ASSERT_EQ(same.size(), one.size()) << k;
    for (std::size_t c = 0; c < one.size(); ++c) {
      EXPECT_EQ(same[c].closed, one[c].closed);
      ASSERT_EQ(same[c].points.size(), one[c].points.size());
      for (std::size_t i = 0; i < one[c].points.size(); ++i)
        EXPECT_EQ(same[c].points[i].position, one[c].points[i].position);
    }
    found += one.size();
  }
  EXPECT_GT(found, 15u);
}

// Walking downhill and stopping early where the foot is well inside a triangle finds the point that
// a search through all triangles finds.
TEST(PatchSurface, ProjectsToTheNearestPointAround) {
  const auto s = toolpath::PatchSurface::refine(
      test::patchOver({test::circle(7)}, 0.8, test::onSphere(25)), 0.6);
  for (std::size_t t = 0; t < s.triangles.size(); t += 7) {
    const auto corner = [&](std::size_t k) {
      return s.position[static_cast<std::size_t>(s.triangles[t][k])];
    };
    const Vector3d from = (corner(0) + corner(1) + corner(2)) / 3;
    const Vector3d point = from + Vector3d(0.31, -0.22, 0.05 * std::sin(static_cast<double>(t)));
    const auto found = s.project(point, static_cast<int>(t));
    double minimum = INFINITY;
    for (std::size_t k = 0; k < s.triangles.size(); ++k)
      minimum = std::min(minimum, (s.project(point, static_cast<int>(k)).position - point).norm());
    EXPECT_LE((found.position - point).norm(), minimum + 1e-6);
  }
}

} // namespace
