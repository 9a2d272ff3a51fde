#include "base/units.h"
#include "toolpath/coverage/coverage.h"
#include "toolpath/coverage/plane_samples.h"
#include "toolpath/coverage/voronoi_shares.h"
#include "toolpath/patch_shapes.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <random>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;
using toolpath::PatchSurface;
using toolpath::PlaneSamples;
using toolpath::SurfaceCurve;

// An inclined plane, so that nothing depends on z.
const Eigen::Isometry3d kLeaning =
    Eigen::Translation3d(3, -7, 11) * Eigen::AngleAxisd(0.7, Vector3d(2, 1, -3).normalized());
Vector3d leaning(const Vector2d& p) {
  return kLeaning * Vector3d(p.x(), p.y(), 0.0);
}
Vector2d flat(const Vector3d& p) {
  return (kLeaning.inverse() * p).head<2>();
}

PatchSurface surfaceOver(const std::vector<test::Loop>& loops) {
  const auto height = [](const Vector3d& p) { return 0.6 + 0.01 * flat(p).x(); };
  return PatchSurface::refine(test::patchOver(loops, 0.8, leaning, height), 0.6);
}

double squaredDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double t = std::clamp((b - a).dot(p - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).squaredNorm();
}

// Wavy lines from side to side, and some that end anywhere.
std::vector<SurfaceCurve> lines(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<SurfaceCurve> curves;
  for (int c = 0; c < 9; ++c) {
    SurfaceCurve curve;
    const double phase = 3.0 * number(random);
    for (double x = -9.0 + 4.0 * (1.0 + number(random)); x < 9.0; x += 0.7)
      curve.points.push_back({leaning({x, 2.0 * c - 8.0 + std::sin(x + phase)}), 0});
    curves.push_back(std::move(curve));
  }
  return curves;
}

TEST(PlaneSamples, RepresentASquareWithAHole) {
  const std::vector<test::Loop> loops{test::rectangle(30, 30), test::circle(8, true)};
  const PatchSurface s = surfaceOver(loops);
  ASSERT_TRUE(s.planeNormal);
  const auto samples = PlaneSamples::of(s, 0.04);
  ASSERT_TRUE(samples);
  double area = 0.0, volume = 0.0, left = 0.0;
  for (std::size_t c = 0; c < samples->count(); ++c) {
    if (!samples->isInside(c))
      continue;
    const toolpath::SurfaceSample sample = samples->sample(c);
    const Vector2d p = flat(sample.position);
    EXPECT_NEAR((kLeaning.inverse() * sample.position).z(), 0.0, 1e-6);
    EXPECT_GT(p.norm(), 7.9);
    EXPECT_LT(p.cwiseAbs().maxCoeff(), 15.001);
    EXPECT_NEAR(sample.thicknessMm, 0.6 + 0.01 * p.x(), 1e-5);
    area += sample.areaMm2;
    volume += sample.areaMm2 * sample.thicknessMm;
    left += p.x() < -12.0 ? sample.areaMm2 : 0.0;
  }
  EXPECT_NEAR(area, s.areaMm2, 1e-6 * area);
  EXPECT_NEAR(area, 900.0 - base::kPi * 64.0, 0.01 * area);
  EXPECT_NEAR(volume, s.volumeMm3, 1e-3 * volume);
  EXPECT_NEAR(left, 90.0, 1.0);
}

// Points in triangles and between them are inside: a raster has as many points over many small
// triangles as over few large ones.
TEST(PlaneSamples, LoseNoneBetweenTriangles) {
  const auto thickness = [](const Vector3d&) { return 0.8; };
  const std::vector<std::vector<test::Loop>> outlines{
      {test::rectangle(30, 30), test::circle(8, true)}, {test::star(5, 9, 4)}};
  for (const std::vector<test::Loop>& loops : outlines) {
    const layers::Patch patch = test::patchOver(loops, 4.0, leaning, thickness);
    const auto few = PlaneSamples::of(PatchSurface::refine(patch, 50.0), 0.004),
               many = PlaneSamples::of(PatchSurface::refine(patch, 0.3), 0.004);
    ASSERT_TRUE(few && many);
    ASSERT_EQ(few->count(), many->count());
    std::size_t inside = 0, differ = 0;
    for (std::size_t c = 0; c < few->count(); ++c) {
      inside += few->isInside(c) ? 1 : 0;
      differ += few->isInside(c) != many->isInside(c) ? 1 : 0;
    }
    EXPECT_GT(inside, 20'000u);
    EXPECT_LE(differ, 2u); // on the boundary itself, by rounding
  }
}

// Beads beside each other get the same, in every direction, along the raster too: points in rows
// would give one of them a row more than the next.
TEST(PlaneSamples, GiveStripsOfAnyDirectionTheSame) {
  const auto samples = PlaneSamples::of(surfaceOver({test::rectangle(40, 40)}), 0.02);
  ASSERT_TRUE(samples);
  constexpr double kHatch = 1.03;
  const Vector3d across = samples->normal(0).unitOrthogonal(),
                 up = samples->normal(0).cross(across);
  const Vector3d middle = leaning({0, 0});
  for (int angle = 0; angle < 180; angle += 3) {
    const double rotation = base::degreesToRadians(angle);
    const Vector3d along = std::cos(rotation) * across + std::sin(rotation) * up;
    const Vector3d lateral = samples->normal(0).cross(along);
    std::map<int, double> area;
    for (std::size_t c = 0; c < samples->count(); ++c) {
      if (!samples->isInside(c))
        continue;
      const Vector3d p = samples->sample(c).position - middle;
      const int strip = static_cast<int>(std::floor(lateral.dot(p) / kHatch));
      if (std::abs(along.dot(p)) < 10.0 && std::abs(strip + 0.5) < 10.0)
        area[strip] += samples->areaMm2();
    }
    ASSERT_EQ(area.size(), 20U);
    for (const auto& [strip, sum] : area)
      EXPECT_NEAR(sum, 20.0 * kHatch, 0.035 * 20.0 * kHatch) << angle << " " << strip;
  }
}

TEST(PlaneSamples, FindNearSamplesAsBruteForceDoes) {
  const auto samples = PlaneSamples::of(surfaceOver({test::star(5, 9, 4)}), 0.09);
  ASSERT_TRUE(samples);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-9.0, 9.0);
  for (int n = 0; n < 60; ++n) {
    const Vector3d a = leaning({number(random), number(random)}),
                   b = n % 6 == 0 ? a : leaning({number(random), number(random)});
    const double radius = 0.2 + 0.15 * (9.0 + number(random));
    std::vector<char> near(samples->count(), 0);
    const auto take = [&](std::size_t cell, float squared, float t) {
      EXPECT_EQ(near[cell], 0);
      near[cell] = 1;
      if (!samples->isInside(cell))
        return;
      const Vector3d foot = a + static_cast<double>(t) * (b - a);
      EXPECT_NEAR((samples->sample(cell).position - foot).squaredNorm(), squared, 1e-3);
    };
    samples->forEachNear(a, b, radius, {radius, radius}, take);
    for (std::size_t c = 0; c < samples->count(); ++c) {
      if (!samples->isInside(c))
        continue;
      const Vector3d p = samples->sample(c).position;
      const double distance = std::sqrt(a == b ? (p - a).squaredNorm() : squaredDistance(p, a, b));
      if (std::abs(distance - radius) > 1e-3) {
        EXPECT_EQ(near[c] != 0, distance < radius);
      }
    }
  }
}

TEST(PlaneSamples, AreNotMadeForABentSurface) {
  const auto cap =
      PatchSurface::refine(test::patchOver({test::circle(8)}, 0.8, test::onSphere(200)), 0.6);
  EXPECT_FALSE(cap.planeNormal);
  EXPECT_FALSE(PlaneSamples::of(cap, 0.04));
}

// The samples of every segment, against the nearest of all for each sample alone.
TEST(PlaneSamples, AreSharedOutToTheNearestCurve) {
  const PatchSurface s = surfaceOver({test::circle(9), test::circle(2, true, {3, 2})});
  const auto samples = PlaneSamples::of(s, 0.04);
  ASSERT_TRUE(samples);
  for (const bool wide : {false, true}) {
    const std::vector<SurfaceCurve> curves = lines(3);
    std::vector<std::vector<double>> extras;
    for (std::size_t k = 0; wide && k < curves.size(); ++k)
      extras.emplace_back(k % 3 == 0 ? curves[k].points.size() : 0, 0.3);
    constexpr double kReach = 1.8;
    const toolpath::VoronoiShares cells = assignToNearestCurve(*samples, curves, kReach, extras);
    std::vector<std::vector<double>> expected;
    for (const SurfaceCurve& c : curves)
      expected.emplace_back(c.points.size() - 1, 0.0);
    double orphan = 0.0;
    for (std::size_t cell = 0; cell < samples->count(); ++cell) {
      if (!samples->isInside(cell))
        continue;
      const Vector3d p = samples->sample(cell).position;
      double minimum = INFINITY, nearest = INFINITY;
      std::size_t curve = 0, segment = 0;
      for (std::size_t k = 0; k < curves.size(); ++k)
        for (std::size_t i = 0; i + 1 < curves[k].points.size(); ++i) {
          const double d = std::sqrt(
              squaredDistance(p, curves[k].points[i].position, curves[k].points[i + 1].position));
          const double rim = d - (wide && k % 3 == 0 ? 0.3 : 0.0);
          nearest = std::min(nearest, d);
          if (d < kReach && rim < minimum) {
            minimum = rim;
            curve = k;
            segment = i;
          }
        }
      (nearest < kReach ? expected[curve][segment] : orphan) += samples->areaMm2();
    }
    // At a curve's corners two of its segments are equally near; between curves none are.
    double off = 0.0, between = 0.0;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      double more = 0.0;
      for (std::size_t i = 0; i < expected[k].size(); ++i) {
        off += std::abs(cells.share[k].areaMm2[i] - expected[k][i]);
        more += cells.share[k].areaMm2[i] - expected[k][i];
      }
      between += std::abs(more);
    }
    EXPECT_LT(off, 0.05 * s.areaMm2);
    EXPECT_LT(between, 0.002 * s.areaMm2);
    EXPECT_NEAR(cells.orphanMm2, orphan, 0.2);
    EXPECT_GT(orphan, 1.0);
  }
}

// Where wide beads narrow along their way, samples beside them are given to the nearest rim too.
TEST(PlaneSamples, AreSharedOutBetweenBeadsThatNarrow) {
  const PatchSurface s = surfaceOver({test::circle(9)});
  const auto samples = PlaneSamples::of(s, 0.04);
  ASSERT_TRUE(samples);
  std::vector<SurfaceCurve> curves(9); // straight: at corners two segments are equally near
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (double x = -9.0; x < 9.0; x += 0.7)
      curves[k].points.push_back({leaning({x, 2.0 * static_cast<double>(k) - 8.0 + 0.1 * x}), 0});
  std::vector<std::vector<double>> extras(curves.size());
  for (std::size_t k = 0; k < curves.size(); k += 2)
    for (std::size_t i = 0; i < curves[k].points.size(); ++i)
      extras[k].push_back(0.2 + 0.2 * std::sin(0.9 * static_cast<double>(i)));
  constexpr double kReach = 1.8;
  const toolpath::VoronoiShares cells = assignToNearestCurve(*samples, curves, kReach, extras);
  std::vector<std::vector<double>> expected;
  for (const SurfaceCurve& c : curves)
    expected.emplace_back(c.points.size() - 1, 0.0);
  for (std::size_t cell = 0; cell < samples->count(); ++cell) {
    if (!samples->isInside(cell))
      continue;
    const Vector3d p = samples->sample(cell).position;
    double minimum = INFINITY;
    std::pair<std::size_t, std::size_t> best{0, 0};
    for (std::size_t k = 0; k < curves.size(); ++k)
      for (std::size_t i = 0; i + 1 < curves[k].points.size(); ++i) {
        const Vector3d &a = curves[k].points[i].position, &b = curves[k].points[i + 1].position;
        const double t = std::clamp((b - a).dot(p - a) / (b - a).squaredNorm(), 0.0, 1.0);
        const double extra =
            extras[k].empty() ? 0.0 : (1.0 - t) * extras[k][i] + t * extras[k][i + 1];
        const double distance = (a + t * (b - a) - p).norm();
        if (distance < kReach && distance - extra < minimum) {
          minimum = distance - extra;
          best = {k, i};
        }
      }
    if (minimum < INFINITY)
      expected[best.first][best.second] += samples->areaMm2();
  }
  double off = 0.0;
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (std::size_t i = 0; i < expected[k].size(); ++i)
      off += std::abs(cells.share[k].areaMm2[i] - expected[k][i]);
  EXPECT_LT(off, 0.001 * s.areaMm2);
}

// The same as from samples of triangles, which the surface's own way takes.
TEST(PlaneSamples, AreSharedOutAsASurfaceIs) {
  const PatchSurface s = surfaceOver({test::circle(9)});
  const auto samples = PlaneSamples::of(s, 0.01);
  ASSERT_TRUE(samples);
  const std::vector<SurfaceCurve> curves = lines(4);
  const toolpath::VoronoiShares plane = assignToNearestCurve(*samples, curves, 1.8),
                                surface = assignToNearestCurve(toolpath::SampleGrid(s, 0.004),
                                                               curves, 1.8);
  EXPECT_NEAR(plane.orphanMm2, surface.orphanMm2, 0.01 * s.areaMm2);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const auto &a = plane.share[k], &b = surface.share[k];
    const auto sum = [](const std::vector<double>& values) {
      return std::accumulate(values.begin(), values.end(), 0.0);
    };
    const auto moment = [](const toolpath::CellShare& share) {
      return std::inner_product(share.areaMm2.begin(), share.areaMm2.end(), share.lateralMm.begin(),
                                0.0);
    };
    const double area = sum(b.areaMm2);
    EXPECT_NEAR(sum(a.areaMm2), area, 0.02 * area);
    EXPECT_NEAR(sum(a.volumeMm3), sum(b.volumeMm3), 0.02 * sum(b.volumeMm3));
    EXPECT_NEAR(moment(a), moment(b), 0.01 * area);
    EXPECT_NEAR(a.beyondMm2[0], b.beyondMm2[0], 0.15);
    EXPECT_NEAR(a.beyondMm2[1], b.beyondMm2[1], 0.15);
  }
}

toolpath::Bead bead(const Vector2d& from, const Vector2d& to) {
  toolpath::Bead b;
  for (int i = 0; i <= 20; ++i) {
    toolpath::BeadPoint p;
    p.middle = leaning(from + (to - from) * i / 20.0);
    p.direction = p.clearDirection = kLeaning.linear().col(2);
    p.widthMm = 1.2;
    p.heightMm = 0.6;
    b.points.push_back(p);
  }
  return b;
}

TEST(PlaneSamples, ShowTheCoverOfACross) {
  const auto samples = PlaneSamples::of(surfaceOver({test::rectangle(24, 24)}), 0.01);
  ASSERT_TRUE(samples);
  const toolpath::Coverage c =
      measureCoverage(*samples, {bead({-8, -1}, {8, -1}), bead({2, -9}, {2, 9})});
  const double ends = base::kPi * 0.36;
  EXPECT_NEAR(c.areaMm2, 576.0, 0.01 * 576.0);
  EXPECT_NEAR(c.coveredMm2, 1.2 * (16 + 18) + 2 * ends - 1.44, 0.4);
  const double hatch = 1.2 - (1 - base::kPi / 4) * 0.6;
  EXPECT_NEAR(c.overlapMm2, hatch * hatch, 0.08);
}

// On a plane distances are straight, except round areas that are not part of it.
TEST(SurfaceFields, DistanceToTheRimOfAPlaneIsThatOfItsEdges) {
  for (const auto& loops : {std::vector<test::Loop>{test::star(5, 12, 5)},
                            std::vector<test::Loop>{test::rectangle(20, 14), test::circle(4, true)},
                            std::vector<test::Loop>{test::ell(18, 5)}}) {
    const PatchSurface s = surfaceOver(loops);
    const auto rim = toolpath::boundarySegments(s);
    const auto d = toolpath::distanceToSegments(s, rim, 1e9);
    std::size_t off = 0;
    for (std::size_t v = 0; v < d.size(); ++v) {
      double minimum = INFINITY;
      for (const auto& e : rim)
        minimum = std::min(minimum, squaredDistance(s.position[v], e.a, e.b));
      // A segment that is nearest to no neighbour of a vertex does not come to it.
      EXPECT_NEAR(d[v], std::sqrt(minimum), 0.1);
      EXPECT_GE(d[v], std::sqrt(minimum) - 1e-9);
      off += d[v] > std::sqrt(minimum) + 1e-2 ? 1 : 0;
    }
    EXPECT_LT(off, d.size() / 10);
  }
}

TEST(PatchSurface, ProjectsOntoAPlanesTriangles) {
  const PatchSurface s = surfaceOver({test::star(5, 12, 5)});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-12.0, 12.0);
  int inside = 0;
  for (int n = 0; n < 400; ++n) {
    const Vector2d p(number(random), number(random));
    const double off = 0.05 * number(random);
    const Vector3d point = kLeaning * Vector3d(p.x(), p.y(), off);
    // Is it over a triangle? By corners' sides, all of them.
    bool over = false;
    for (const auto& t : s.triangles) {
      const auto corner = [&](std::size_t k) {
        return flat(s.position[static_cast<std::size_t>(t[k % 3])]);
      };
      bool in = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector2d a = corner(k), b = corner(k + 1);
        in = in && (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x() > 1e-9;
      }
      over = over || in;
    }
    if (!over)
      continue;
    ++inside;
    // From nearby, as curves do: from further a bay may be in between.
    int from = 0;
    for (int k = 0; k < static_cast<int>(s.triangles.size()); ++k)
      if (const auto& t = s.triangles[static_cast<std::size_t>(k)];
          (s.position[static_cast<std::size_t>(t[0])] - point).norm() < 1.5)
        from = k;
    const toolpath::SurfacePoint q = s.project(point, from);
    EXPECT_LT((flat(q.position) - p).norm(), 1e-9);
    EXPECT_NEAR((kLeaning.inverse() * q.position).z(), 0.0, 1e-9);
    const Vector3d w = s.barycentric(q);
    const auto& t = s.triangles[static_cast<std::size_t>(q.triangle)];
    Vector3d back = Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      back += w[static_cast<int>(k)] * s.position[static_cast<std::size_t>(t[k])];
    EXPECT_LT((back - q.position).norm(), 1e-9);
  }
  EXPECT_GT(inside, 60);
}

} // namespace
