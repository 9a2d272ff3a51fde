// Supports for voxels that growth misses, judged by the checker of ranks, which is independent of
// growth.
#include "plan/finding_kinds.h"
#include "support/supports.h"

#include "base/error.h"
#include "curved/decompose.h"
#include "curved/platform_polygon.h"
#include "curved/rank_checker.h"
#include "curved/voxel_shapes.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/models.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace voluta::support {
namespace {

const base::RunContext kQuiet;

Supports supported(const voxel::SolidVoxels& part, const base::RunContext& ctx = kQuiet) {
  return supportsFor(part, curved::platformFit(part, 0.0), {}, ctx);
}

// Two posts, a beam, and a tooth from the beam far down between the posts: inside the front of
// every path that leads to it.
voxel::SolidVoxels toothPart() {
  return test::voxelPart(24, 6, 19, [](int i, int j, int k) {
    const bool post = i < 4 || i >= 20, beam = k >= 16;
    const bool tooth = (i == 11 || i == 12) && (j == 2 || j == 3) && k >= 8;
    return post || beam || tooth;
  });
}

// Both constraints hold for part and support together, and nothing is left out.
void expectWhole(const Supports& s, const std::vector<Eigen::Vector2d>& platform) {
  curved::CurvedOptions ranksOnly;
  ranksOnly.rounds = 0;
  const curved::Decomposition d = curved::decompose(s.solid, platform, ranksOnly, kQuiet);
  EXPECT_EQ(d.missedVoxels, 0u);
  const test::RankVerdict verdict = test::checkRanks(d, s.solid.solid);
  EXPECT_EQ(verdict.missed, 0u);
  EXPECT_EQ(verdict.unsupported, 0u);
  EXPECT_EQ(verdict.wrongCells, 0u);
  EXPECT_LE(verdict.deepest, d.epsilonMm / d.grid.pitch + 1e-7);
}

void expectMaskIsColumns(const Supports& s, const voxel::SolidVoxels& part) {
  std::vector<std::uint8_t> mask(part.solid.size(), 0);
  std::size_t voxels = 0;
  for (const Column& column : s.columns)
    for (const std::size_t c : column.cells) {
      EXPECT_EQ(mask[c], 0);
      EXPECT_EQ(part.solid[c], 0);
      mask[c] = 1;
      ++voxels;
    }
  EXPECT_EQ(mask, s.support);
  EXPECT_EQ(voxels, s.voxels);
  EXPECT_EQ(s.solid.count, part.count + voxels);
  for (std::size_t c = 0; c < mask.size(); ++c)
    EXPECT_EQ(s.solid.solid[c] != 0, part.solid[c] != 0 || mask[c] != 0);
}

TEST(Supports, APartThatNeedsNoneGetsNone) {
  for (const voxel::SolidVoxels& part :
       {test::mushroomPart(), test::archPart(), test::blobPart(3)}) {
    const Supports s = supported(part);
    EXPECT_EQ(s.missedBefore, 0u);
    EXPECT_TRUE(s.columns.empty());
    EXPECT_TRUE(s.support.empty());
    EXPECT_TRUE(s.findings.empty());
    EXPECT_EQ(s.growths, 1);
    EXPECT_EQ(s.solid.solid, part.solid);
  }
}

TEST(Supports, AShadowedToothGetsOneStraightColumn) {
  const voxel::SolidVoxels part = toothPart();
  const Supports s = supported(part);
  EXPECT_GT(s.missedBefore, 0u);
  EXPECT_EQ(s.missedAfter, 0u);
  ASSERT_EQ(s.columns.size(), 1u);
  const Column& column = s.columns[0];
  EXPECT_EQ(column.standsOn, Column::Foot::Platform);
  EXPECT_EQ(column.cells.size(), 8u);
  EXPECT_EQ(column.foot.head<2>(), column.top.head<2>());
  EXPECT_EQ(column.foot.z(), part.plateLayer());
  EXPECT_EQ(column.sideFaces, 0u);
  EXPECT_TRUE(part.solid[part.grid.index(column.top.x(), column.top.y(), column.top.z() + 1)]);
  expectMaskIsColumns(s, part);
  expectWhole(s, curved::platformFit(part, 0.0));
  ASSERT_EQ(s.findings.size(), 1u);
  EXPECT_EQ(voluta::plan::reportId(s.findings[0]), "supportColumn");
  EXPECT_FALSE(s.findings[0].blocking);
}

TEST(Supports, ColumnCarriesAFloatingPiece) {
  const voxel::SolidVoxels part = test::voxelPart(16, 16, 14, [](int i, int j, int k) {
    const bool rim = i < 3 || i >= 13 || j < 3 || j >= 13;
    const bool piece = i >= 6 && i < 10 && j >= 6 && j < 10 && k >= 9;
    return (rim && k < 6) || piece;
  });
  const Supports s = supported(part);
  EXPECT_EQ(s.missedBefore, 4u * 4u * 5u);
  ASSERT_EQ(s.columns.size(), 1u);
  EXPECT_EQ(s.columns[0].cells.size(), 9u);
  EXPECT_EQ(s.columns[0].standsOn, Column::Foot::Platform);
  expectMaskIsColumns(s, part);
  expectWhole(s, curved::platformFit(part, 0.0));
}

TEST(Supports, ColumnSlantsToReachThePlatform) {
  // The piece floats beside the only foot there is.
  const voxel::SolidVoxels part = test::voxelPart(
      18, 5, 20, [](int i, int, int k) { return (i < 8 && k < 2) || (i >= 13 && k >= 12); });
  const Supports s = supported(part);
  ASSERT_EQ(s.columns.size(), 1u);
  EXPECT_NE(s.columns[0].foot.x(), s.columns[0].top.x());
  EXPECT_NE(s.columns[0].standsOn, Column::Foot::Support);
  EXPECT_EQ(s.missedAfter, 0u);
  expectWhole(s, curved::platformFit(part, 0.0));
}

// Steps aside without one down: no more than the limit where there is room, any number where not.
TEST(Supports, AColumnsArmsAreShortWhereTheyCanBe) {
  const auto longestArm = [](int height, int away, int maxLateralSteps) {
    voxel::VoxelGrid grid;
    grid.size = {away + 4, 5, height + 2};
    std::vector<support::Cell> cells(grid.cellCount(), support::Cell::Empty);
    const std::size_t carried = grid.index(1, 2, height);
    cells[carried] = support::Cell::Part;
    for (int i = 0; i < grid.size.x(); ++i)
      for (int j = 0; j < grid.size.y(); ++j)
        cells[grid.index(i, j, 0)] = i >= away + 1 ? support::Cell::Plate : support::Cell::Closed;
    const auto column = support::cheapestColumn(grid, cells, {carried}, maxLateralSteps, kQuiet);
    if (!column)
      return -1;
    int arm = 0, longest = 0;
    for (std::size_t n = 1; n < column->cells.size(); ++n) {
      arm = grid.cell(column->cells[n]).z() == grid.cell(column->cells[n - 1]).z() ? arm + 1 : 0;
      longest = std::max(longest, arm);
    }
    return longest;
  };
  for (const int maximum : {1, 2, 3})
    for (const int away : {2, 5, 9}) {
      SCOPED_TRACE(testing::Message() << maximum << " " << away);
      const int arm = longestArm(14, away, maximum);
      EXPECT_GT(arm, 0);
      EXPECT_LE(arm, maximum);
    }
  EXPECT_EQ(longestArm(2, 9, 2), 9);
}

TEST(Supports, VoxelsThatNoColumnReachesGiveAFinding) {
  const voxel::SolidVoxels part =
      test::voxelPart(20, 6, 8, [](int i, int, int k) { return (i < 8 && k < 6) || i >= 14; });
  const std::vector<Eigen::Vector2d> platform{{0, 0}, {8, 0}, {8, 6}, {0, 6}};
  const Supports s = supportsFor(part, platform, {}, kQuiet);
  EXPECT_EQ(s.missedBefore, 6u * 6u * 8u);
  EXPECT_EQ(s.missedAfter, s.missedBefore);
  EXPECT_TRUE(s.columns.empty());
  ASSERT_EQ(s.findings.size(), 1u);
  EXPECT_EQ(voluta::plan::reportId(s.findings[0]), "noSupport");
  EXPECT_TRUE(s.findings[0].blocking);
  EXPECT_EQ(s.findings[0].count, s.missedBefore);
}

TEST(Supports, OtherSchemesAreSupportedToo) {
  const voxel::SolidVoxels part = toothPart();
  SupportOptions options;
  options.growth = curved::GrowthScheme("greedy");
  const Supports s = supportsFor(part, curved::platformFit(part, 0.0), options, kQuiet);
  EXPECT_GT(s.missedBefore, 0u);
  EXPECT_LT(s.missedAfter, s.missedBefore);
  EXPECT_FALSE(s.columns.empty());
  expectMaskIsColumns(s, part);
}

// Of the cells from i0 to i1 along x, the others are Auto.
SupportOptions ruled(const voxel::SolidVoxels& part, layers::SupportRule rule, int i0, int i1) {
  SupportOptions options;
  options.rules.assign(part.solid.size(), layers::SupportRule::Auto);
  for (std::size_t c = 0; c < part.solid.size(); ++c)
    if (const int i = part.grid.cell(c).x(); i >= i0 && i < i1)
      options.rules[c] = rule;
  return options;
}

TEST(Supports, ABlockedToothGetsNoColumn) {
  const voxel::SolidVoxels part = toothPart();
  const auto platform = curved::platformFit(part, 0.0);
  const std::size_t missed = supported(part).missedBefore;
  const Supports s =
      supportsFor(part, platform, ruled(part, layers::SupportRule::None, 4, 20), kQuiet);
  EXPECT_TRUE(s.columns.empty());
  EXPECT_EQ(s.missedAfter, missed);
  EXPECT_EQ(s.solid.solid, part.solid);
  // Blocked elsewhere, the tooth is carried as before.
  const Supports other =
      supportsFor(part, platform, ruled(part, layers::SupportRule::None, 0, 4), kQuiet);
  EXPECT_EQ(other.columns.size(), 1u);
  EXPECT_EQ(other.missedAfter, 0u);
}

// An arch that growth prints without any: columns stand where they are asked for, at most a bridge
// apart, and the ranks still fulfil both constraints.
TEST(Supports, ColumnsStandWhereARegionAsksForThem) {
  const voxel::SolidVoxels part = test::archPart();
  const auto platform = curved::platformFit(part, 0.0);
  SupportOptions options = ruled(part, layers::SupportRule::Always, 0, part.grid.size.x());
  options.bridgeMm = 4.0 * part.grid.pitch;
  const Supports s = supportsFor(part, platform, options, kQuiet);
  EXPECT_EQ(s.missedBefore, 0u);
  ASSERT_GT(s.columns.size(), 1u);
  EXPECT_EQ(s.missedAfter, 0u);
  expectMaskIsColumns(s, part);
  // By an own count: every cell of the part over an empty one is near the top of a column.
  for (std::size_t c = 0; c < part.solid.size(); ++c) {
    const Eigen::Vector3i at = part.grid.cell(c);
    if (!part.solid[c] || at.z() <= part.plateLayer() ||
        part.solid[part.grid.index(at.x(), at.y(), at.z() - 1)])
      continue;
    const bool isNear = std::ranges::any_of(s.columns, [&](const Column& column) {
      const Eigen::Vector3i apart = column.top + Eigen::Vector3i::UnitZ() - at;
      return apart.z() == 0 && apart.cast<double>().norm() < 4.0;
    });
    EXPECT_TRUE(isNear) << at.transpose();
  }
  // Below half of it alone.
  const Supports half = supportsFor(
      part, platform,
      [&] {
        SupportOptions own = ruled(part, layers::SupportRule::Always, 0, part.grid.size.x() / 2);
        own.bridgeMm = options.bridgeMm;
        return own;
      }(),
      kQuiet);
  ASSERT_FALSE(half.columns.empty());
  for (const Column& column : half.columns)
    EXPECT_LT(column.top.x(), part.grid.size.x() / 2);
  EXPECT_LT(half.columns.size(), s.columns.size());
}

// A region printed later lies below the tooth: its cells stay empty.
TEST(Supports, ColumnsKeepOutOfClosedCells) {
  const voxel::SolidVoxels part = toothPart();
  SupportOptions options;
  options.closed.assign(part.solid.size(), 0);
  for (std::size_t c = 0; c < part.solid.size(); ++c)
    if (const Eigen::Vector3i at = part.grid.cell(c); at.x() >= 9 && at.x() < 15 && at.z() < 4)
      options.closed[c] = 1;
  const Supports s = supportsFor(part, curved::platformFit(part, 0.0), options, kQuiet);
  ASSERT_FALSE(s.columns.empty());
  for (const Column& column : s.columns)
    for (const std::size_t c : column.cells)
      EXPECT_EQ(options.closed[c], 0);
  EXPECT_EQ(s.missedAfter, 0u);
}

TEST(Supports, AreTheSameForAnyNumberOfThreads) {
  const voxel::SolidVoxels part = toothPart();
  const Supports one = supported(part),
                 two = supported(part, base::RunContext(base::CancelToken{}, 2));
  EXPECT_EQ(one.support, two.support);
  EXPECT_EQ(one.growths, two.growths);
}

TEST(Supports, ProgressNeverFalls) {
  for (const char* growth : {"auto", "greedy"}) {
    double last = 0.0;
    const base::RunContext ctx(base::CancelToken{}, 2,
                               [&](double fraction, const voluta::base::Message&) {
                                 EXPECT_GE(fraction, last - 1e-12) << growth;
                                 last = fraction;
                               });
    SupportOptions options;
    options.growth = curved::GrowthScheme(growth);
    const voxel::SolidVoxels part = toothPart();
    supportsFor(part, curved::platformFit(part, 0.0), options, ctx);
    EXPECT_EQ(last, 1.0);
  }
}

// A platform far wider than the part shadows more (Boge 2019, table 6.2).
TEST(Supports, CureAPlatformThatIsTooLarge) {
  VOLUTA_MODEL_OR_SKIP(file, "synthetic_candelabra.stl");
  const voxel::SolidVoxels part = voxel::solidVoxels(geometry::readMesh(file).mesh, 1.6, kQuiet);
  const std::vector<Eigen::Vector2d> platform = curved::platformFit(part, 40.0);
  const Supports s = supportsFor(part, platform, {}, kQuiet);
  EXPECT_GT(s.missedBefore, 0u);
  EXPECT_EQ(s.missedAfter, 0u);
  EXPECT_LE(static_cast<double>(s.voxels), 0.006 * static_cast<double>(part.count));
  expectMaskIsColumns(s, part);
  expectWhole(s, platform);
}

TEST(Supports, CanBeCancelled) {
  const base::CancelToken token;
  token.cancel();
  EXPECT_THROW(supported(toothPart(), base::RunContext(token, 1)), base::Cancelled);
}

TEST(Supports, SpotIsWholeWithLessThanAThousandth) {
  VOLUTA_MODEL_OR_SKIP(file, "spot.stl");
  const geometry::TriangleMesh mesh = geometry::readMesh(file).mesh;
  const voxel::SolidVoxels part = voxel::solidVoxels(mesh, 1.99, kQuiet);
  const Supports s = supported(part);
  EXPECT_GT(s.missedBefore, 0u);
  EXPECT_EQ(s.missedAfter, 0u);
  EXPECT_LE(static_cast<double>(s.voxels), 0.001 * static_cast<double>(part.count));
  expectMaskIsColumns(s, part);
  expectWhole(s, curved::platformFit(part, 0.0));
}

} // namespace
} // namespace voluta::support
