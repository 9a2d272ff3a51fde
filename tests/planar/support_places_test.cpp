// Columns where regions say so: enforcers, blockers, and regions that are printed later.
#include "helpers/shapes.h"
#include "plan/finding_kinds.h"
#include "planar/flat.h"
#include "sliced_parts.h"

#include <gtest/gtest.h>

namespace voluta::planar {
namespace {

using geometry::TriangleMesh;
using layers::SupportPlaces, layers::SupportRule;

constexpr double kGapMm = 0.3, kHalfBeadMm = 0.6;

// A gallows 4 mm deep: its columns are too narrow to taper. The arm is from x = 10 to 30, 16 mm
// high.
const TriangleMesh& narrowGallows() {
  static const TriangleMesh kMesh =
      prism({{0, 0}, {10, 0}, {10, 16}, {30, 16}, {30, 20}, {0, 20}}, 4.0);
  return kMesh;
}

SliceResult slicedWith(SupportRule rule, const SupportPlaces& places,
                       const TriangleMesh& part = narrowGallows()) {
  SliceOptions options;
  options.supports = rule;
  options.plate = {{-20, -20}, {60, -20}, {60, 40}, {-20, 40}};
  return slicePieces({pieceOf(part)}, options, {}, places);
}

// Of a column below the arm from x to x.
double columnMm3(double from, double to) {
  return (to - from) * 4.0 * 16.0;
}

Eigen::AlignedBox3d boxOf(const SliceResult& sliced) {
  Eigen::AlignedBox3d box;
  for (const layers::Patch& patch : sliced.stack.patches)
    if (patch.group == layers::kSupportGroup)
      box.extend(geometry::bounds(patch.surface));
  return box;
}

const TriangleMesh kFarHalf = test::box({20, -5, 10}, {40, 10, 30});

TEST(SupportPlaces, ABlockerLeavesItsOverhangFree) {
  const SliceResult whole = slicedWith(SupportRule::Auto, {});
  EXPECT_NEAR(whole.supportVolumeMm3 / columnMm3(10.0 + kGapMm, 30.0), 1.0, 0.015);
  const SliceResult half = slicedWith(SupportRule::Auto, {{{SupportRule::None, kFarHalf}}, {}});
  EXPECT_NEAR(half.supportVolumeMm3 / columnMm3(10.0 + kGapMm, 20.0 + kHalfBeadMm), 1.0, 0.015);
  EXPECT_NEAR(boxOf(half).max().x(), 20.0 + kHalfBeadMm, 0.05);
  EXPECT_TRUE(half.findings.empty()) << "nothing is asked for there";
}

TEST(SupportPlaces, AnEnforcerIsCarriedAlone) {
  for (const SupportRule rule : {SupportRule::Auto, SupportRule::Always}) {
    const SliceResult half = slicedWith(SupportRule::None, {{{rule, kFarHalf}}, {}});
    EXPECT_NEAR(half.supportVolumeMm3 / columnMm3(20.0 - kHalfBeadMm, 30.0), 1.0, 0.015);
    EXPECT_NEAR(boxOf(half).min().x(), 20.0 - kHalfBeadMm, 0.05);
  }
}

TEST(SupportPlaces, TheLaterPlaceHolds) {
  const TriangleMesh all = test::box({-5, -5, -5}, {40, 10, 30});
  const SupportPlaces blockedLast{{{SupportRule::Always, kFarHalf}, {SupportRule::None, all}}, {}};
  EXPECT_EQ(slicedWith(SupportRule::Auto, blockedLast).supportVolumeMm3, 0.0);
  const SupportPlaces enforcedLast{{{SupportRule::None, all}, {SupportRule::Always, kFarHalf}}, {}};
  EXPECT_NEAR(slicedWith(SupportRule::Auto, enforcedLast).supportVolumeMm3 /
                  columnMm3(20.0 - kHalfBeadMm, 30.0),
              1.0, 0.015);
}

// A slope of 30 degrees from the vertical needs no column, unless one is asked for: then columns
// fill the triangle below it. The steps are narrower than a bead, and each has a column half a bead
// wider all round.
TEST(SupportPlaces, AnEnforcerCarriesWhatNeedsNoColumn) {
  const TriangleMesh slope = prism({{0, 0}, {10, 0}, {19.24, 16}, {19.24, 20}, {0, 20}}, 4.0);
  EXPECT_EQ(slicedWith(SupportRule::Auto, {}, slope).supportVolumeMm3, 0.0);
  const TriangleMesh all = test::box({-5, -5, -5}, {40, 10, 30});
  const SliceResult carried =
      slicedWith(SupportRule::Auto, {{{SupportRule::Always, all}}, {}}, slope);
  EXPECT_NEAR(carried.supportVolumeMm3 /
                  ((0.5 * 9.24 + 2.0 * kHalfBeadMm) * 16.0 * (4.0 + 2.0 * kHalfBeadMm)),
              1.0, 0.05);
  EXPECT_EQ(slicedWith(SupportRule::Always, {}, slope).supportVolumeMm3, carried.supportVolumeMm3);
}

// A body between the arm and the plate that is printed later: no column is in it or beside it.
TEST(SupportPlaces, ColumnsKeepClearOfRegionsPrintedLater) {
  const TriangleMesh later = test::box({18, -1, 0}, {22, 5, 6.2});
  const SliceResult sliced = slicedWith(SupportRule::Auto, {{}, {later}});
  Eigen::AlignedBox3d near = geometry::bounds(later);
  near.min().head<2>().array() -= kGapMm - 0.02;
  near.max().head<2>().array() += kGapMm - 0.02;
  std::size_t low = 0;
  for (const layers::Patch& patch : sliced.stack.patches) {
    if (patch.group != layers::kSupportGroup)
      continue;
    for (const Eigen::Vector3d& v : patch.surface.vertices) {
      EXPECT_FALSE(near.contains(v)) << v.transpose();
      low += v.z() < 6.0 ? 1 : 0;
    }
  }
  EXPECT_GT(low, 0u) << "beside it there are columns";
  EXPECT_LT(sliced.supportVolumeMm3, slicedWith(SupportRule::Auto, {}).supportVolumeMm3);
}

plan::Findings openBelow(SupportRule rule, const std::vector<layers::SupportPlace>& places) {
  return openOverhangFindings({pieceOf(narrowGallows())}, {}, Overhangs::Flat,
                              layers::SupportRules(places, rule));
}
std::string reasonsOf(const plan::Findings& findings) {
  std::string all;
  for (const plan::Finding& finding : findings)
    all += plan::englishReason(finding) + "\n";
  return all;
}

// The underside of the arm is one face of 20 mm by 4 mm.
TEST(SupportPlaces, OverhangsThatARegionBlocksAreFound) {
  EXPECT_TRUE(openBelow(SupportRule::Auto, {}).empty());
  const plan::Findings half = openBelow(SupportRule::Auto, {{SupportRule::None, kFarHalf}});
  ASSERT_EQ(half.size(), 1u);
  EXPECT_EQ(half[0].kind, plan::FindingKind::OverhangBlocked);
  EXPECT_FALSE(half[0].blocking);
  EXPECT_EQ(reasonsOf(half),
            "40 mm2 overhangs by more than 45 degrees where regions block supports; "
            "here is most of it\n");
  ASSERT_TRUE(half[0].where);
  EXPECT_GT(half[0].where->x(), 20.0);
  EXPECT_NEAR(half[0].where->z(), 16.0, 1e-9);
  const TriangleMesh all = test::box({-5, -5, -5}, {40, 10, 30});
  EXPECT_TRUE(
      openBelow(SupportRule::Auto, {{SupportRule::None, all}, {SupportRule::Auto, all}}).empty())
      << "the later place holds";
}

TEST(SupportPlaces, OverhangsThatARegionCarriesAreNoFindings) {
  const plan::Findings none = openBelow(SupportRule::None, {}),
                       half = openBelow(SupportRule::None, {{SupportRule::Always, kFarHalf}});
  EXPECT_EQ(reasonsOf(none), "80 mm2 overhangs by more than 45 degrees\n");
  EXPECT_EQ(reasonsOf(half), "40 mm2 overhangs by more than 45 degrees\n");
  ASSERT_EQ(half.size(), 1u);
  EXPECT_EQ(half[0].kind, plan::FindingKind::OverhangOfFlat);
  EXPECT_LT(half[0].where->x(), 20.0);
  const TriangleMesh all = test::box({-5, -5, -5}, {40, 10, 30});
  EXPECT_TRUE(openBelow(SupportRule::None, {{SupportRule::Auto, all}}).empty());
}

} // namespace
} // namespace voluta::planar
