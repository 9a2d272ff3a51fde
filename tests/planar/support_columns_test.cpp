// Columns under unsupported parts of layers.
#include "helpers/all_seeds.h"
#include "layers/layer_checks.h"
#include "layers/walled_support.h"
#include "plan/finding_kinds.h"
#include "sliced_parts.h"

#include "base/units.h"
#include "helpers/shapes.h"

#include "plan/tool_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;
using geometry::TriangleMesh;

SliceOptions supported(double plateTo) {
  SliceOptions options;
  options.supports = layers::SupportRule::Auto;
  options.plate = {{-5, -5}, {plateTo, -5}, {plateTo, 15}, {-5, 15}};
  return options;
}

std::vector<const layers::Patch*> supportsOf(const SliceResult& sliced) {
  std::vector<const layers::Patch*> out;
  for (const layers::Patch& patch : sliced.stack.patches)
    if (patch.group == layers::kSupportGroup)
      out.push_back(&patch);
  return out;
}

// A box of 30 mm with a hollow of 20 mm: the columns under its roof stay in it.
TEST(Supports, ColumnsInAClosedHollowGiveAFinding) {
  TriangleMesh closed = test::box({0, 0, 0}, {30, 30, 30});
  TriangleMesh open = closed;
  test::append(closed, test::box({5, 5, 5}, {25, 25, 25}), true);
  SliceOptions options = supported(40);
  options.plate = {{-5, -5}, {40, -5}, {40, 40}, {-5, 40}};
  const SliceResult sliced = slicePieces({pieceOf(closed)}, options, {});
  ASSERT_GT(sliced.supportVolumeMm3, 100.0);
  const auto walled = layers::walledSupport(sliced.stack, closed);
  ASSERT_TRUE(walled);
  EXPECT_FALSE(walled->blocking);
  EXPECT_LT((*walled->where - Vector3d(15, 15, 15)).norm(), 1e-9);
  ASSERT_TRUE(walled->value("volume"));
  EXPECT_NE(plan::englishReason(*walled).find("cannot be removed"), std::string::npos);
  // The same columns are free where the part is no hollow around them.
  EXPECT_FALSE(layers::walledSupport(sliced.stack, open));
  EXPECT_FALSE(layers::walledSupport(slicePieces({pieceOf(closed)}, {}, {}).stack, closed));
}

// A bead of support under a bead of the part's own layers.
TEST(Supports, BeadsInAClosedHollowGiveAFinding) {
  TriangleMesh closed = test::box({0, 0, 0}, {30, 30, 30});
  const TriangleMesh open = closed;
  test::append(closed, test::box({5, 5, 5}, {25, 25, 25}), true);
  layers::LayerStack stack;
  stack.patches.resize(2);
  stack.patches[1].group = layers::kSupportGroup;
  plan::ToolPlan plan;
  for (const auto& [x, patch] : {std::pair{10.0, 0}, {40.0, 0}, {15.0, 1}}) {
    plan::ToolPath path;
    path.kind = plan::PathKind::Support;
    path.patch = patch;
    path.first = plan.position.size();
    path.count = 3;
    plan.paths.push_back(path);
    for (const double y : {10.0, 14.0, 20.0}) {
      plan.position.emplace_back(x, y, 10.0);
      plan.widthMm.push_back(1.2F);
      plan.heightMm.push_back(0.5F);
    }
  }
  const auto walled = layers::walledSupport(plan, stack, closed);
  ASSERT_TRUE(walled);
  EXPECT_NEAR(std::get<base::Quantity>(walled->value("volume")->data()).number, 10.0 * 1.2 * 0.5,
              1e-5)
      << "only the first is in it";
  EXPECT_FALSE(layers::walledSupport(plan, stack, open));
  plan.paths.erase(plan.paths.begin());
  EXPECT_FALSE(layers::walledSupport(plan, stack, closed));
}

TEST(Supports, ColumnsUnderAnArmStartOnThePlate) {
  const std::vector<Piece> pieces{pieceOf(gallows())};
  const SliceResult sliced = slicePieces(pieces, supported(25), {});
  const auto supports = supportsOf(sliced);
  EXPECT_EQ(supports.size(), 20u); // one a layer under the arm
  // As wide as the arm at its top, with a gap to the post; narrower downwards by half of what a
  // layer may reach out, down to a trunk of four beads.
  Eigen::AlignedBox3d above;
  for (auto patch = supports.rbegin(); patch != supports.rend(); ++patch) {
    const Eigen::AlignedBox3d box = geometry::bounds((*patch)->surface);
    if (above.isEmpty()) {
      EXPECT_NEAR(box.min().x(), 10.3, 0.02);
      EXPECT_NEAR(box.max().x(), 20.0, 0.02);
      EXPECT_NEAR(geometry::area((*patch)->surface), 97.0, 1.0); // round corners
    } else {
      EXPECT_GE(box.min().x(), above.min().x() - 0.02);
      EXPECT_LE(box.min().x(), above.min().x() + 0.42);
      EXPECT_LE(box.max().x(), above.max().x() + 0.02);
    }
    EXPECT_GE(box.max().x() - box.min().x(), 4 * 1.2);
    above = box;
  }
  EXPECT_LT(above.max().x() - above.min().x(), 6.0);
  EXPECT_LT(sliced.supportVolumeMm3, 0.5 * 16.0 * 97.0);
  EXPECT_NEAR(volumeOf(sliced), 2400.0, 1e-6);
  const auto held = layers::checkSupport(sliced.stack, 1.25, {});
  for (const layers::SupportCheck& check : held)
    EXPECT_GT(check.supportedFraction, 0.95);
  EXPECT_TRUE(sliced.findings.empty());
  EXPECT_TRUE(supportsOf(slicePieces(pieces, {}, {})).empty());
}

// A plate that ends under the column's inner third: it starts there, and grows out over the edge by
// half a bead a layer.
TEST(Supports, ColumnGrowsOutFromItsFootOnThePlate) {
  const SliceResult sliced = slicePieces({pieceOf(gallows())}, supported(14), {});
  const auto supports = supportsOf(sliced);
  ASSERT_EQ(supports.size(), 20u);
  double before = 14.0;
  for (const layers::Patch* patch : supports) {
    const Eigen::AlignedBox3d box = geometry::bounds(patch->surface);
    const double edge = box.max().x();
    EXPECT_LE(edge, before + 0.6 + 0.02);
    before = edge;
  }
  EXPECT_LE(geometry::bounds(supports.front()->surface).max().x(), 14.62);
  EXPECT_NEAR(before, 20.0, 0.02);
}

TEST(Supports, ColumnCarriesATipBelowAnArm) {
  // An arm with a point under it, steeper than any overhang: its first sections are too narrow for
  // a bead, and those that follow reach out over them by little.
  const TriangleMesh fang = prism(
      {{0, 0}, {10, 0}, {10, 16}, {18, 16}, {20, 8}, {22, 16}, {30, 16}, {30, 20}, {0, 20}}, 10.0);
  const SliceResult sliced = slicePieces({pieceOf(fang)}, supported(35), {});
  double lowest = 20.0;
  for (const layers::Patch* patch : supportsOf(sliced)) {
    const Eigen::AlignedBox3d box = geometry::bounds(patch->surface);
    if (box.min().z() < 7.0) {
      EXPECT_GT(box.sizes().x(), 1.2);
      lowest = std::min(lowest, box.min().z());
    }
  }
  EXPECT_LT(lowest, 0.5);
  EXPECT_EQ(sliced.unsupportedPatches, 0u);
  EXPECT_LT(sliced.sliverVolumeMm3, 10.0 * 0.8 * (0.2 + 0.6) + 0.1); // the point itself
  for (const plan::Finding& f : sliced.findings)
    EXPECT_FALSE(f.blocking) << voluta::plan::englishReason(f);
}

TEST(Supports, ColumnsWithoutAFootingGiveAFinding) {
  const SliceResult sliced = slicePieces({pieceOf(gallows())}, supported(12), {});
  EXPECT_TRUE(supportsOf(sliced).empty());
  ASSERT_EQ(sliced.findings.size(), 1u);
  EXPECT_EQ(plan::reportId(sliced.findings.front()), "unheldOverhang");
  EXPECT_NEAR(sliced.findings.front().where->z(), 16.4, 0.41);
}

TEST(Supports, ColumnStartsOnThePartItself) {
  // The arm is over a step of the part, 4 high.
  const TriangleMesh step =
      prism({{0, 0}, {30, 0}, {30, 4}, {10, 4}, {10, 16}, {20, 16}, {20, 20}, {0, 20}}, 10.0);
  const SliceResult sliced = slicePieces({pieceOf(step)}, supported(12), {});
  EXPECT_EQ(supportsOf(sliced).size(), 15u);
  EXPECT_TRUE(sliced.findings.empty());
}

// Where each step of a slope is hardly wider than half a bead, a column begins at the wall, and no
// level of it exceeds the one below by more than half a bead.
TEST(Supports, ColumnStartsOnASteepSlope) {
  const TriangleMesh crane =
      prism({{0, 0}, {28, 0}, {10, 25}, {10, 36}, {30, 36}, {30, 40}, {0, 40}}, 10.0);
  const SliceResult sliced = slicePieces({pieceOf(crane)}, supported(29), {});
  const auto supports = supportsOf(sliced);
  ASSERT_GT(supports.size(), 40u);
  for (const plan::Finding& f : sliced.findings)
    EXPECT_NE(plan::reportId(f), "unheldOverhang");
  const auto slopeAt = [](double z) { return z < 25.0 ? 28.0 - 18.0 * z / 25.0 : 10.0; };
  for (const layers::Patch* patch : supports) {
    const Eigen::AlignedBox3d box = geometry::bounds(patch->surface);
    const double z = box.min().z(); // in the middle of its level
    double beneath = z < 0.8 ? 29.0 : slopeAt(z - 0.8);
    for (const layers::Patch* under : supports)
      if (const Eigen::AlignedBox3d u = geometry::bounds(under->surface);
          std::abs(u.min().z() + 0.8 - z) < 0.01)
        beneath = std::max(beneath, u.max().x());
    EXPECT_LE(box.max().x(), beneath + 0.6 + 0.02) << z;
  }
  EXPECT_NEAR(geometry::bounds(supports.back()->surface).max().x(), 30.0, 0.02);
}

// Slopes of 20 to 80 degrees under an arm: a column that meets one starts on it, continues round
// it, or both.
TEST(Supports, ColumnsStartOnRandomSlopes) {
  for (unsigned seed = 0; seed < test::ofSeeds(15u, 60u); ++seed) {
    std::mt19937 random(seed);
    const auto number = [&](double from, double to) {
      return std::uniform_real_distribution<>(from, to)(random);
    };
    const double rise = number(6.0, 25.0),
                 run = rise / std::tan(base::degreesToRadians(number(20, 80)));
    const double arm = 10.0 + number(3.0, 25.0), under = rise + number(2.0, 8.0);
    const TriangleMesh crane = prism({{0, 0},
                                      {10 + run, 0},
                                      {10, rise},
                                      {10, under},
                                      {arm, under},
                                      {arm, under + 4},
                                      {0, under + 4}},
                                     10.0);
    const SliceResult sliced = slicePieces({pieceOf(crane)}, supported(110), {});
    for (const plan::Finding& f : sliced.findings)
      EXPECT_NE(plan::reportId(f), "unheldOverhang")
          << seed << ": " << voluta::plan::englishReason(f);
    double top = 0.0, reach = 0.0;
    for (const layers::Patch* patch : supportsOf(sliced)) {
      const Eigen::AlignedBox3d box = geometry::bounds(patch->surface);
      reach = box.min().z() > top + 0.01 ? box.max().x() : std::max(reach, box.max().x());
      top = std::max(top, box.min().z());
    }
    EXPECT_NEAR(reach, arm, 0.02) << seed;
  }
}

TriangleMesh together(const std::vector<TriangleMesh>& parts) {
  TriangleMesh sum;
  for (const TriangleMesh& part : parts)
    test::append(sum, part);
  return sum;
}

// Under a wide roof with a narrow tongue the column gets narrower downwards, but under the tongue
// it stays as wide as that.
TEST(Supports, NarrowColumnsKeepTheirWidthWideOnesTaper) {
  const TriangleMesh roof =
      together({test::box({0, 0, 0}, {10, 10, 20}), test::box({9, 0, 16}, {21, 10, 20}),
                test::box({20, 4, 16}, {35, 5.5, 20})});
  const SliceResult sliced = slicePieces({pieceOf(roof)}, supported(40), {});
  EXPECT_TRUE(sliced.findings.empty());
  std::map<int, Eigen::AlignedBox3d> trunk, all; // by level
  for (const layers::Patch* patch : supportsOf(sliced)) {
    const Eigen::AlignedBox3d box = geometry::bounds(patch->surface);
    const int level = static_cast<int>(std::floor(box.min().z() / 0.8));
    all[level].extend(box);
    if (box.min().x() < 15.0)
      trunk[level].extend(box);
  }
  ASSERT_EQ(all.size(), 20u);
  for (const auto& [level, box] : all)
    EXPECT_NEAR(box.max().x(), 35.0, 0.02) << level;
  EXPECT_NEAR(trunk.at(19).sizes().y(), 10.0, 0.02);
  EXPECT_LT(trunk.at(0).sizes().y(), 6.0);
  EXPECT_GE(trunk.at(0).sizes().y(), 4.7);
}

// A fin on the post, too narrow for a bead: layers over it need a column like those beside it.
TEST(Supports, UnprintedFinCarriesNothing) {
  const TriangleMesh roof =
      together({test::box({0, 0, 0}, {10, 10, 20}), test::box({9, 0, 0}, {30, 0.4, 17}),
                test::box({9, 0, 16}, {30, 10, 20})});
  const SliceResult sliced = slicePieces({pieceOf(roof)}, supported(40), {});
  Eigen::AlignedBox3d above;
  for (const layers::Patch* patch : supportsOf(sliced))
    if (const Eigen::AlignedBox3d box = geometry::bounds(patch->surface);
        above.isEmpty() || box.min().z() > above.min().z())
      above = box;
  ASSERT_FALSE(above.isEmpty());
  EXPECT_NEAR(above.min().y(), 0.0, 0.02);
}

TEST(Supports, ColumnsKeepOutOfPiecesPrintedLater) {
  // The later piece fills the place under the arm: nothing can be carried there.
  Piece later = pieceOf(test::box({10, 0, 0}, {20, 10, 16}));
  later.base = {-Vector3d::UnitX(), -20.0};
  later.baseTag = 0;
  const SliceResult sliced = slicePieces({pieceOf(gallows()), later}, supported(25), {});
  for (const layers::Patch* patch : supportsOf(sliced))
    EXPECT_TRUE(patch->direction.front().isApprox(-Vector3d::UnitX()));
}

} // namespace
} // namespace voluta::planar
