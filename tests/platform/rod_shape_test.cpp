// Rods, and parts with rods taken out of them.
#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "geometry/subtract.h"
#include "helpers/lathe_parts.h"
#include "helpers/shapes.h"
#include "platform/rod_shape.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta {
namespace {

using platform::RodShape;

TEST(RodShape, RadiusOfRoundPrismAndStep) {
  const RodShape round = platform::straightRod(5, 200);
  EXPECT_DOUBLE_EQ(platform::radiusAt(round, 0, 1.1), 2.5);
  EXPECT_DOUBLE_EQ(platform::radiusAt(round, 100.1, 1.1), 0.0);
  const RodShape hex = platform::straightRod(6, 100, 6);
  EXPECT_NEAR(platform::radiusAt(hex, 0, 0), 3.0, 1e-12);
  EXPECT_NEAR(platform::radiusAt(hex, 0, base::kPi / 6), 3.0 * std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(platform::radiusAt(hex, 0, -base::kPi / 2), 3.0 * std::sqrt(0.75), 1e-12);
  const RodShape stepped{{{-50, 2}, {0, 2}, {0, 4}, {50, 5}}, 0};
  EXPECT_DOUBLE_EQ(platform::radiusAt(stepped, -1e-9, 0), 2.0);
  EXPECT_DOUBLE_EQ(platform::radiusAt(stepped, 0, 0), 4.0);
  EXPECT_DOUBLE_EQ(platform::radiusAt(stepped, 25, 0), 4.5);
  const auto range = platform::radiiBetween(stepped, -10, 25);
  EXPECT_DOUBLE_EQ(range.minMm, 2.0);
  EXPECT_DOUBLE_EQ(range.maxMm, 4.5);
  EXPECT_NEAR(platform::radiiBetween(hex, -1, 1).minMm, 3.0 * std::sqrt(0.75), 1e-12);
}

TEST(RodShape, MeshIsClosedAndAsLargeAsTheRod) {
  const RodShape rods[] = {platform::straightRod(5, 200),
                           platform::straightRod(6, 100, 6),
                           {{{-50, 2}, {0, 2}, {0, 4}, {50, 5}}, 0}};
  const double volumes[] = {base::kPi * 6.25 * 200, 1.5 * std::sqrt(3.0) * 9 * 100,
                            base::kPi * (4 * 50 + 50 * (16 + 20 + 25) / 3.0)};
  for (int i = 0; i < 3; ++i) {
    const auto mesh = platform::meshOf(rods[i], 1e-4);
    const auto diagnosis = geometry::diagnose(mesh);
    EXPECT_TRUE(diagnosis.clean()) << i;
    EXPECT_NEAR(diagnosis.volumeMm3 / volumes[i], 1.0, 1e-3) << i;
    EXPECT_LE(diagnosis.volumeMm3, volumes[i] * (1 + 1e-12));
    for (const auto& p : mesh.vertices)
      EXPECT_LE(p.tail<2>().norm(),
                platform::radiusAt(rods[i], p.x(), std::atan2(p.z(), p.y())) + 1e-9);
  }
}

TEST(RodShape, BadProfilesAreRefusedWithAReason) {
  const std::pair<RodShape, const char*> bad[] = {
      {{{{0, 1}}, 0}, "at least two points"},
      {{{{0, 1}, {5, 0}}, 0}, "the radius at point 2 is not positive"},
      {{{{0, 1}, {5, NAN}}, 0}, "the radius at point 2 is not positive"},
      {{{{0, 1}, {5, 1}, {4, 1}}, 0}, "x decreases at point 3"},
      {{{{0, 1}, {5, 1}, {5, 2}, {5, 3}, {9, 1}}, 0}, "point 4 is the third one at x = 5 mm"},
      {{{{0, 1}, {0, 2}}, 0}, "a step at the end"},
      {{{{0, 1}, {5, 1}}, 2}, "round or has at least three"}};
  for (const auto& [rod, what] : bad)
    try {
      platform::checkRod(rod);
      ADD_FAILURE() << what;
    } catch (const base::Error& e) {
      EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
      EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
    }
  EXPECT_NO_THROW(platform::checkRod({{{-50, 2}, {0, 2}, {0, 4}, {50, 5}}, 0}));
}

TEST(Subtract, BoxLessARodThroughIt) {
  const auto rod = platform::meshOf(platform::straightRod(5, 60, 24), 1e-3);
  const auto left = geometry::subtract(test::box({-10, -8, -8}, {10, 8, 8}), rod);
  ASSERT_TRUE(left);
  const auto diagnosis = geometry::diagnose(*left);
  EXPECT_TRUE(diagnosis.watertight);
  const double section = 12 * 6.25 * std::sin(2 * base::kPi / 24);
  EXPECT_NEAR(diagnosis.volumeMm3, 20 * (256 - section), 1e-6);
  EXPECT_EQ(diagnosis.genus, std::optional<int>(1));
}

TEST(Subtract, BoreJustAsLargeAsTheRod) {
  // Facets on facets: of a hexagonal rod in its own bore nothing is cut, of a larger one a shell.
  const auto part = test::hexagonalTube(5, 10, 50);
  for (const double over : {5.0, 6.0}) {
    const auto left =
        geometry::subtract(part, platform::meshOf(platform::straightRod(over, 80, 6), 1e-3));
    ASSERT_TRUE(left);
    EXPECT_TRUE(geometry::diagnose(*left).watertight);
    EXPECT_NEAR(geometry::volume(*left) / test::hexagonalTubeVolume(over, 10, 50), 1.0, 5e-4);
  }
}

TEST(Subtract, NothingIsLeftOrNothingIsTaken) {
  const auto box = test::box({-1, -1, -1}, {1, 1, 1});
  const auto inside = geometry::subtract(box, test::box({-2, -2, -2}, {2, 2, 2}));
  ASSERT_TRUE(inside);
  EXPECT_TRUE(inside->empty());
  const auto apart = geometry::subtract(box, test::box({5, 5, 5}, {6, 6, 6}));
  ASSERT_TRUE(apart);
  EXPECT_NEAR(geometry::volume(*apart), 8.0, 1e-12);
}

TEST(Subtract, APartThatIsNotClosedIsNotCut) {
  auto open = test::box({-10, -8, -8}, {10, 8, 8});
  open.triangles.pop_back();
  EXPECT_FALSE(geometry::subtract(open, test::box({-2, -2, -2}, {2, 2, 20})));
}

TEST(LatheParts, HaveTheVolumesOfTheirSolids) {
  using geometry::volume;
  for (const auto& section : {test::tubeSection(), test::shoulderSection(), test::taperedSection()})
    EXPECT_NEAR(volume(test::revolved(section, 256)) / test::revolvedVolume(section), 1.0, 2e-4);
  EXPECT_NEAR(test::revolvedVolume(test::tubeSection()), base::kPi * (25 - 5.76) * 50, 1e-9);
  EXPECT_NEAR(volume(test::hexagonalTube(5, 10, 50)) / test::hexagonalTubeVolume(5, 10, 50), 1.0,
              2e-4);
  EXPECT_NEAR(volume(test::halfTube(4.8, 10, 50)) / (0.5 * base::kPi * (25 - 5.76) * 50), 1.0,
              2e-4);
  EXPECT_NEAR(volume(test::gableRoof(40, 60)), 0.25 * std::sqrt(3.0) * 1600 * 60, 1e-6);
  EXPECT_NEAR(volume(test::gableRib(40, 6.57, 2.05, 10)) / test::gableRibVolume(40, 6.57, 2.05, 10),
              1.0, 2e-4);
  EXPECT_NEAR(volume(test::halfCylinder(40, 60)) / (0.5 * base::kPi * 400 * 60), 1.0, 2e-4);
  for (const auto& mesh :
       {test::revolved(test::shoulderSection(), 64), test::hexagonalTube(5, 10, 50),
        test::halfTube(4.8, 10, 50), test::gableRoof(40, 60), test::gableRib(40, 6.57, 2.05, 10),
        test::halfCylinder(40, 60), test::halfCylinderRib(40, 6.57, 2.0, 0.7)}) {
    const auto diagnosis = geometry::diagnose(mesh);
    EXPECT_TRUE(diagnosis.clean())
        << (diagnosis.clean() ? "" : base::english(diagnosis.sentences().front()));
  }
}

} // namespace
} // namespace voluta
