// Heads from numbers and from meshes against closed forms.
#include "process/head_shapes.h"

#include "base/error.h"
#include "base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

namespace voluta::process {
namespace {

using Eigen::Vector3d;

// A body of revolution through the sections, as `sides` flat faces around.
geometry::TriangleMesh revolved(const std::vector<HeadSection>& profile, int sides,
                                const Vector3d& at = Vector3d::Zero()) {
  geometry::TriangleMesh mesh;
  for (const HeadSection& section : profile)
    for (int k = 0; k < sides; ++k) {
      const double angle = 2.0 * base::kPi * k / sides;
      mesh.vertices.push_back(at + Vector3d(section.radiusMm * std::cos(angle),
                                            section.radiusMm * std::sin(angle), section.zMm));
    }
  for (int i = 0; i + 1 < static_cast<int>(profile.size()); ++i)
    for (int k = 0; k < sides; ++k) {
      const int a = i * sides + k, b = i * sides + (k + 1) % sides;
      mesh.triangles.push_back({a, b, b + sides});
      mesh.triangles.push_back({a, b + sides, a + sides});
    }
  return mesh;
}

double radiusAt(const HeadShape& head, double zMm) {
  double radius = 0.0;
  for (std::size_t i = 1; i < head.sections.size(); ++i) {
    const HeadSection &a = head.sections[i - 1], &b = head.sections[i];
    if (zMm < a.zMm || zMm > b.zMm)
      continue;
    const double share = b.zMm > a.zMm ? (zMm - a.zMm) / (b.zMm - a.zMm) : 1.0;
    radius = std::max(radius, a.radiusMm + share * (b.radiusMm - a.radiusMm));
  }
  return radius;
}

TEST(HeadShapes, fromNumbersIsAConeBelowABlock) {
  const HeadShape head = headFromNumbers({0.5, 90.0, 6.0, 20.0, 40.0});
  ASSERT_EQ(head.sections.size(), 4u);
  EXPECT_EQ(head.sections[0].radiusMm, 0.5);
  EXPECT_NEAR(head.sections[1].radiusMm, 6.5, 1e-12);
  EXPECT_NEAR(head.sections[2].radiusMm, 20.0 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(head.sections[2].zMm, 6.0);
  EXPECT_EQ(head.sections[3].zMm, 46.0);
}

TEST(HeadShapes, fromNumbersRefusesContradictions) {
  EXPECT_THROW(headFromNumbers({0.0, 60.0, 6.0, 20.0, 40.0}), base::Error);
  EXPECT_THROW(headFromNumbers({0.5, 0.0, 6.0, 20.0, 40.0}), base::Error);
  EXPECT_THROW(headFromNumbers({0.5, 180.0, 6.0, 20.0, 40.0}), base::Error);
  EXPECT_THROW(headFromNumbers({0.5, 60.0, 0.0, 20.0, 40.0}), base::Error);
  EXPECT_THROW(headFromNumbers({0.5, 60.0, 6.0, 2.0, 40.0}), base::Error);
  EXPECT_THROW(headFromNumbers({0.5, 60.0, 6.0, 20.0, 0.0}), base::Error);
}

// Conical nozzle, clamp and block, as the heads of the program: the sections come back.
TEST(HeadShapes, fromMeshGivesTheSectionsBack) {
  const std::vector<HeadSection> profile{{0.0, 0.5},   {12.0, 6.0},  {12.0, 10.0},
                                         {45.0, 10.0}, {45.0, 22.0}, {110.0, 22.0}};
  const HeadShape head = headFromMesh(revolved(profile, 96, {3.0, -7.0, 500.0}));
  ASSERT_EQ(head.sections.size(), profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i) {
    EXPECT_NEAR(head.sections[i].zMm, profile[i].zMm, 0.02) << i;
    EXPECT_NEAR(head.sections[i].radiusMm, profile[i].radiusMm, 1e-6) << i;
  }
}

TEST(HeadShapes, fromMeshTakesTheCornersOfABlock) {
  const HeadShape head = headFromMesh(revolved({{0.0, 10.0}, {40.0, 10.0}}, 4));
  ASSERT_EQ(head.sections.size(), 2u);
  EXPECT_NEAR(head.sections[0].radiusMm, 10.0, 1e-9);
  EXPECT_NEAR(head.sections[1].zMm, 40.0, 0.02);
}

// A ball's radius is sqrt(z (2 R - z)), and few sections are enough.
TEST(HeadShapes, fromMeshContainsABall) {
  constexpr double kRadiusMm = 15.0, kToleranceMm = 0.1;
  std::vector<HeadSection> profile;
  for (int i = 0; i <= 400; ++i) {
    const double angle = base::kPi * i / 400.0;
    profile.push_back({kRadiusMm * (1.0 - std::cos(angle)), kRadiusMm * std::sin(angle)});
  }
  const HeadShape head = headFromMesh(revolved(profile, 64), kToleranceMm);
  EXPECT_LE(head.sections.size(), 48u);
  for (double z = 0.5; z < 2.0 * kRadiusMm - 0.5; z += 0.05) {
    const double exact = std::sqrt(z * (2.0 * kRadiusMm - z));
    EXPECT_GT(radiusAt(head, z), exact - 0.02) << z;
    EXPECT_LT(radiusAt(head, z), exact + 1.5 * kToleranceMm) << z;
  }
}

// Random towers of steps and cones: the head contains every vertex.
TEST(HeadShapes, fromMeshContainsRandomTowers) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int n = 0; n < 200; ++n) {
    std::vector<HeadSection> profile{{0.0, 0.5 + share(random)}};
    for (std::size_t i = 0; i < 1 + random() % 12; ++i) {
      const HeadSection& below = profile.back();
      profile.push_back(
          {below.zMm + (random() % 3 == 0 && i > 0 ? 0.0 : 0.5 + 20.0 * share(random)),
           0.5 + 30.0 * share(random)});
    }
    const HeadShape head = headFromMesh(revolved(profile, 24));
    EXPECT_EQ(head.sections.front().zMm, 0.0);
    for (std::size_t i = 1; i < head.sections.size(); ++i)
      EXPECT_GE(head.sections[i].zMm, head.sections[i - 1].zMm);
    for (std::size_t i = 1; i < profile.size(); ++i) {
      const HeadSection &a = profile[i - 1], &b = profile[i];
      const double z = 0.5 * (a.zMm + b.zMm), r = 0.5 * (a.radiusMm + b.radiusMm);
      if (b.zMm > a.zMm) {
        const double slope = std::abs(b.radiusMm - a.radiusMm) / (b.zMm - a.zMm);
        EXPECT_NEAR(radiusAt(head, z), r, 0.05 + 0.03 * slope) << n << ' ' << i;
      }
    }
  }
}

// A thread of many turns: few sections, all of it within the head.
TEST(HeadShapes, fromMeshKeepsFewSections) {
  std::vector<HeadSection> profile;
  for (int i = 0; i <= 400; ++i)
    profile.push_back({0.25 * i, i % 2 == 0 ? 8.0 : 7.0});
  const HeadShape head = headFromMesh(revolved(profile, 48));
  EXPECT_LE(head.sections.size(), 48u);
  for (const HeadSection& section : profile)
    EXPECT_GE(radiusAt(head, section.zMm), section.radiusMm - 0.02) << section.zMm;
}

// Drawn with the nozzle up, a head is wide at its lowest point; turned over it is the same head.
TEST(HeadShapes, aHeadUpsideDownIsFoundAndTurnedOver) {
  const std::vector<HeadSection> profile{{0.0, 0.5}, {12.0, 6.0}, {12.0, 22.0}, {60.0, 22.0}};
  geometry::TriangleMesh mesh = revolved(profile, 48);
  const HeadShape head = headFromMesh(mesh);
  EXPECT_FALSE(upsideDown(head));
  for (Vector3d& v : mesh.vertices)
    v = Vector3d(v.x() + 7.0, 3.0 - v.y(), 100.0 - v.z());
  const auto reason = upsideDown(headFromMesh(mesh));
  ASSERT_TRUE(reason);
  EXPECT_EQ(base::english(*reason), "the head is 44 mm wide at its tip and 1 mm at its other end: "
                                    "its nozzle seems to point away from the part");
  const HeadShape turned = headFromMesh(mesh, kHeadToleranceMm, NozzlePoints::Up);
  ASSERT_EQ(turned.sections.size(), head.sections.size());
  for (std::size_t i = 0; i < head.sections.size(); ++i) {
    EXPECT_NEAR(turned.sections[i].zMm, head.sections[i].zMm, 0.02);
    EXPECT_NEAR(turned.sections[i].radiusMm, head.sections[i].radiusMm, 0.02);
  }
  EXPECT_FALSE(upsideDown({})) << "no head";
}

TEST(HeadShapes, noShippedHeadIsUpsideDown) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  for (const std::string& id : processIds()) {
    HeadShape head = loadProcess(id).head;
    EXPECT_FALSE(upsideDown(head)) << id;
    const double height = head.sections.back().zMm;
    std::ranges::reverse(head.sections);
    for (HeadSection& section : head.sections)
      section.zMm = height - section.zMm;
    EXPECT_TRUE(upsideDown(head)) << id;
  }
}

TEST(HeadShapes, fromMeshRefusesOtherUnits) {
  EXPECT_THROW(headFromMesh(revolved({{0.0, 0.01}, {0.12, 0.02}}, 12)), base::Error);
}

TEST(HeadShapes, fromMeshRefusesFlatMeshes) {
  EXPECT_THROW(headFromMesh({}), base::Error);
  EXPECT_THROW(headFromMesh(revolved({{0.0, 1.0}, {0.0, 2.0}}, 8)), base::Error);
}

} // namespace
} // namespace voluta::process
