// Properties of every growth scheme.
#include "curved/growth_rows.h"

#include "base/error.h"
#include "curved/grow.h"
#include "curved/platform_polygon.h"
#include "curved/rank_checker.h"
#include "curved/voxel_shapes.h"

#include <gtest/gtest.h>
#include <set>

namespace voluta::curved {
namespace {

const base::RunContext kQuiet;

TEST(GrowthRows, HaveNamesAndTexts) {
  std::set<std::string_view> ids;
  for (const GrowthRow& row : growthRows()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.label.empty());
    EXPECT_FALSE(row.help.empty());
    EXPECT_EQ(GrowthScheme(row.id).id(), row.id);
    EXPECT_EQ(&GrowthScheme(row.id).row(), &row);
    try {
      GrowthScheme(std::string(row.id) + "q");
      ADD_FAILURE() << "a scheme that is none";
    } catch (const base::Error& error) {
      EXPECT_NE(std::string(error.what()).find(row.id), std::string::npos);
    }
  }
  EXPECT_EQ(GrowthScheme(), GrowthScheme(growthRows().front()));
  EXPECT_EQ(growthSchemes().size(), growthRows().size());
}

// Both constraints hold for all printed voxels, on parts that a flat front meets at once, reaches
// under, and closes.
TEST(GrowthRows, RanksKeepBothConstraints) {
  for (const voxel::SolidVoxels& part :
       {test::boxPart(7, 5, 6), test::mushroomPart(), test::archPart()})
    for (const GrowthScheme& scheme : growthSchemes()) {
      const auto platform = platformFit(part, 0.0);
      const VoxelGraph graph = voxelGraph(part.grid, part.solid, part.plateLayer(), platform);
      const Growth growth = grow(graph, scheme, {}, kQuiet);
      Decomposition d;
      d.grid = part.grid;
      d.platform = platform;
      d.rank.assign(part.grid.cellCount(), 0);
      for (std::size_t c = 0; c < d.rank.size(); ++c)
        d.rank[c] = part.solid[c] ? -1 : 0;
      std::size_t printed = 0;
      for (std::size_t v = 0; v < graph.size(); ++v)
        if (growth.rank[v] > 0) {
          d.rank[graph.cellOf(v)] = growth.rank[v];
          ++printed;
        }
      EXPECT_EQ(growth.printed, printed) << scheme.id();
      EXPECT_FALSE(growth.scheme.empty());
      const test::RankVerdict verdict = test::checkRanks(d, part.solid);
      EXPECT_GT(verdict.printed, part.count / 2) << scheme.id();
      EXPECT_EQ(verdict.unsupported, 0u) << scheme.id();
      EXPECT_EQ(verdict.wrongCells, 0u) << scheme.id();
      EXPECT_LE(verdict.deepest, growth.epsilon + 1e-7) << scheme.id();
    }
}

TEST(GrowthRows, CanBeCancelled) {
  const voxel::SolidVoxels part = test::boxPart(30, 30, 30);
  const VoxelGraph graph =
      voxelGraph(part.grid, part.solid, part.plateLayer(), platformFit(part, 0.0));
  base::CancelToken token;
  token.cancel();
  for (const GrowthScheme& scheme : growthSchemes())
    EXPECT_THROW(grow(graph, scheme, {}, base::RunContext(token, 1)), base::Cancelled)
        << scheme.id();
}

} // namespace
} // namespace voluta::curved
