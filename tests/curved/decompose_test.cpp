// Growth and field as a whole, judged by checkers that share nothing with them.
#include "curved/decompose.h"

#include "base/error.h"
#include "curved/platform_polygon.h"
#include "curved/rank_checker.h"
#include "curved/voxel_shapes.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/models.h"
#include "plan/finding_kinds.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>

namespace voluta::curved {
namespace {

const base::RunContext kQuiet;

Decomposition grown(const voxel::SolidVoxels& part, const std::string& growth = "auto",
                    const base::RunContext& ctx = kQuiet) {
  CurvedOptions options;
  options.growth = GrowthScheme(growth);
  return decompose(part, platformFit(part, 0.0), options, ctx);
}

void expectValid(const Decomposition& d, const voxel::SolidVoxels& part) {
  const test::RankVerdict verdict = test::checkRanks(d, part.solid);
  EXPECT_EQ(verdict.unsupported, 0u);
  EXPECT_LE(verdict.deepest, d.epsilonMm / d.grid.pitch + 1e-7);
  EXPECT_LE(d.epsilonMm, 0.5 * d.grid.pitch);
  EXPECT_EQ(verdict.wrongCells, 0u);
  EXPECT_EQ(verdict.missed, d.missedVoxels);
  EXPECT_EQ(verdict.printed + verdict.missed, d.voxels);
  EXPECT_EQ(d.missedVoxels, d.shadowedVoxels + d.unreachedVoxels);
  std::size_t reported = 0;
  for (const plan::Finding& f : d.findings)
    reported += f.count;
  EXPECT_EQ(reported, d.missedVoxels);
}

TEST(Decompose, BoxGrowsInFlatLayers) {
  const voxel::SolidVoxels part = test::boxPart(12, 9, 10);
  for (const char* growth : {"auto", "greedy"}) {
    const Decomposition d = grown(part, growth);
    expectValid(d, part);
    EXPECT_EQ(d.missedVoxels, 0u);
    EXPECT_EQ(d.layers, 10);
    for (std::size_t c = 0; c < d.rank.size(); ++c)
      if (part.solid[c]) {
        EXPECT_EQ(d.rank[c], d.grid.cell(c).z()) << growth;
        EXPECT_NEAR(static_cast<double>(d.frontNormal[c].z()), 1.0, 1e-6);
      }
  }
}

TEST(Decompose, FieldOfABoxIsItsHeight) {
  const voxel::SolidVoxels part = test::boxPart(12, 9, 20, 0.5);
  const Decomposition d = grown(part);
  for (std::size_t c = 0; c < d.rank.size(); ++c) {
    if (!part.solid[c]) {
      EXPECT_TRUE(std::isnan(d.field[c]));
      continue;
    }
    EXPECT_NEAR(static_cast<double>(d.field[c]), 0.5 * (d.grid.cell(c).z() - 0.5), 0.01);
  }
}

TEST(Decompose, OverhangsAndLoopsLoseNothing) {
  for (const voxel::SolidVoxels& part :
       {test::mushroomPart(), test::archPart(), test::conePart()}) {
    const Decomposition d = grown(part);
    expectValid(d, part);
    EXPECT_EQ(d.missedVoxels, 0u);
    const test::FieldVerdict field = test::checkField(d, 0.8, 0.4, 1.0);
    EXPECT_EQ(field.islands, 0u);
    // Where two fronts close a loop the field has a crease, whose cells count as too thick: a tenth
    // of so small an arch.
    EXPECT_GT(field.within, 0.85) << part.count;
    EXPECT_LT(field.inaccessible, 0.03);
  }
}

TEST(Decompose, RandomBlobsKeepBothConstraints) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const voxel::SolidVoxels part = test::blobPart(seed);
    expectValid(grown(part), part);
    expectValid(grown(part, "greedy"), part);
  }
}

TEST(Decompose, FrontNormalsClearEarlierLevels) {
  const voxel::SolidVoxels part = test::mushroomPart();
  const Decomposition d = grown(part);
  std::size_t printed = 0, clear = 0;
  for (std::size_t c = 0; c < d.rank.size(); ++c) {
    if (d.rank[c] <= 0)
      continue;
    ++printed;
    const Eigen::Vector3d n = d.frontNormal[c].cast<double>();
    EXPECT_NEAR(n.norm(), 1.0, 1e-5);
    const auto level = [&](std::size_t at) { return std::floor(d.field[at] / 0.8f); };
    double above = 0.0;
    const Eigen::Vector3d here = d.grid.cell(c).cast<double>();
    for (std::size_t w = 0; w < d.rank.size(); ++w)
      if (d.rank[w] > 0 && level(w) < level(c))
        above = std::max(above, n.dot(d.grid.cell(w).cast<double>() - here));
    clear += above <= 0.51;
  }
  EXPECT_GT(static_cast<double>(clear), 0.98 * static_cast<double>(printed));
}

TEST(RankChecker, SeesFaults) {
  const voxel::SolidVoxels part = test::mushroomPart();
  const Decomposition good = grown(part);
  ASSERT_EQ(test::checkRanks(good, part.solid).unsupported, 0u);
  const auto cellAt = [&](int i, int j, int k) { return part.grid.index(i + 1, j + 1, k + 1); };

  Decomposition early = good; // a voxel of the rim first of all: nothing carries it
  early.rank[cellAt(1, 10, 12)] = 1;
  EXPECT_GT(test::checkRanks(early, part.solid).unsupported, 0u);

  Decomposition late = good; // the stem's middle last: deep inside
  late.rank[cellAt(10, 10, 5)] = 10000;
  EXPECT_GT(test::checkRanks(late, part.solid).deepest, 1.0);

  Decomposition lost = good;
  lost.rank[cellAt(10, 10, 12)] = 0;
  EXPECT_EQ(test::checkRanks(lost, part.solid).wrongCells, 1u);

  Decomposition floating = good; // a level of its own in the cap's rim
  floating.field[cellAt(1, 10, 10)] = 0.1f;
  EXPECT_GT(test::checkField(floating, 0.8, 0.4, 1.0).islands, 0u);
}

TEST(Decompose, FindsPiecesWithoutContact) {
  const voxel::SolidVoxels part =
      test::voxelPart(12, 6, 10, [](int i, int, int k) { return i < 5 || (i >= 8 && k >= 4); });
  for (const char* growth : {"auto", "greedy"}) {
    const Decomposition d = grown(part, growth);
    expectValid(d, part);
    EXPECT_EQ(d.unreachedVoxels, 4u * 6u * 6u);
    EXPECT_EQ(d.shadowedVoxels, 0u);
    ASSERT_EQ(d.findings.size(), 1u);
    EXPECT_EQ(voluta::plan::reportId(d.findings[0]), "unreachedVoxels");
    ASSERT_TRUE(d.findings[0].where.has_value());
    EXPECT_NEAR(d.findings[0].where->x(), 10.0, 1.0);
    EXPECT_FALSE(voluta::plan::englishRemedy(d.findings[0]).empty());
  }
}

TEST(Decompose, HookTipBelowItsArmIsShadowed) {
  // Post, arm, and a hanging tip that reaches lower than the arm, between two posts: inside the
  // hull of all that must come before it.
  const voxel::SolidVoxels part = test::voxelPart(31, 7, 24, [](int i, int, int k) {
    return i < 5 || i >= 26 || k >= 19 || (i >= 13 && i < 18 && k >= 4);
  });
  const Decomposition d = grown(part);
  expectValid(d, part);
  EXPECT_GT(d.shadowedVoxels, 0u);
  ASSERT_FALSE(d.findings.empty());
  EXPECT_EQ(voluta::plan::reportId(d.findings[0]), "shadowedVoxels");
  EXPECT_NE(voluta::plan::englishReason(d.findings[0]).find("facet between"), std::string::npos);
  std::size_t shadowed = 0, cascade = 0;
  for (std::size_t c = 0; c < d.rank.size(); ++c) {
    EXPECT_EQ(d.loss[c] != Loss::None, d.rank[c] < 0);
    shadowed += d.loss[c] == Loss::Shadowed;
    cascade += d.loss[c] == Loss::Cascade;
  }
  EXPECT_EQ(shadowed + cascade, d.shadowedVoxels);
  EXPECT_EQ(cascade, d.cascadeVoxels);
  EXPECT_GT(shadowed, 0u);
}

TEST(Decompose, SameForAnyNumberOfThreads) {
  const voxel::SolidVoxels part = test::blobPart(21);
  const Decomposition one = grown(part, "auto", base::RunContext(base::CancelToken{}, 1));
  const Decomposition two = grown(part, "auto", base::RunContext(base::CancelToken{}, 2));
  EXPECT_EQ(one.rank, two.rank);
  EXPECT_EQ(one.frontNormal, two.frontNormal);
  for (std::size_t c = 0; c < one.field.size(); ++c)
    EXPECT_TRUE(one.field[c] == two.field[c] ||
                (std::isnan(one.field[c]) && std::isnan(two.field[c])));
}

TEST(Decompose, StopsWhenCancelledAtAnyTime) {
  const voxel::SolidVoxels part = test::mushroomPart();
  for (const double at : {0.0, 0.1, 0.3, 0.6, 0.9}) {
    const base::CancelToken token;
    const base::RunContext ctx(token, 2, [&](double fraction, const voluta::base::Message&) {
      if (fraction >= at)
        token.cancel();
    });
    EXPECT_THROW(grown(part, "auto", ctx), base::Cancelled) << at;
  }
}

TEST(Decompose, ProgressNeverFallsBack) {
  double last = 0.0;
  const base::RunContext ctx(base::CancelToken{}, 1,
                             [&](double fraction, const voluta::base::Message&) {
                               EXPECT_GE(fraction, last - 1e-9);
                               last = fraction;
                             });
  grown(test::mushroomPart(), "auto", ctx);
  EXPECT_NEAR(last, 1.0, 1e-9);
}

TEST(Decompose, RefusesUnknownGrowthAndUnreachablePlatform) {
  const voxel::SolidVoxels part = test::boxPart(4, 4, 4);
  try {
    grown(part, "gredy");
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_NE(voluta::base::english(e.remedy()).find("greedy"), std::string::npos);
  }
  try {
    decompose(part, platformRect(1.0, 1.0, {50.0, 50.0}), {}, kQuiet);
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
  }
  EXPECT_NE(curvedParameters().find("voxelMm"), nullptr);
}

// Small versions of parts to try: the same bars as at full size, with room for coarse cells.
class Models : public testing::TestWithParam<const char*> {};

TEST_P(Models, NothingMissedAndAnEvenField) {
  VOLUTA_MODEL_OR_SKIP(file, GetParam());
  const geometry::TriangleMesh mesh = geometry::readMesh(file).mesh;
  const voxel::SolidVoxels part = voxel::solidVoxels(mesh, 2.2, kQuiet);
  const Decomposition d = grown(part, "auto", base::RunContext(base::CancelToken{}, 2));
  expectValid(d, part);
  EXPECT_EQ(d.missedVoxels, 0u);
  const test::FieldVerdict field = test::checkField(d, 0.8, 0.4, 1.0);
  EXPECT_GT(field.within, 0.99);
  EXPECT_LT(field.inaccessible, 0.004);
  EXPECT_EQ(field.islands, 0u);
}

INSTANTIATE_TEST_SUITE_P(Decompose, Models,
                         testing::Values("kitten.stl", "bunny_7k.stl", "armadillo_29k.stl"));

} // namespace
} // namespace voluta::curved
