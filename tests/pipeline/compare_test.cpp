// Several ways of building one part, side by side.
#include "pipeline/compare_figures.h"
#include "plan/finding_kinds.h"

#include "base/error.h"
#include "modes/mode_table.h"
#include "pipeline/box_request.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;
using voluta::curved::GrowthScheme;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;
using ::testing::ElementsAre;

namespace {

base::RunContext context() {
  return base::RunContext(base::CancelToken(), 2);
}

CompareOptions boxOptions(Stage until) {
  CompareOptions options;
  options.plan = test::boxRequest();
  options.plan.until = until;
  return options;
}

CompareRow row(double missed, double printTimeS, bool blocked = false) {
  CompareRow made;
  made.combination = {"curved", GrowthScheme(), {}};
  made.reached = Stage::Replay;
  made.report.item().decomposition.voxels = 1000;
  made.report.item().decomposition.missedVoxels = static_cast<std::size_t>(missed);
  made.report.motion.waypoints = 100;
  made.report.motion.durationS = printTimeS;
  if (blocked)
    made.report.findings.push_back(
        plan::verbatimFinding(plan::Stage::Motion, "unreachable", "out of reach", ""));
  return made;
}

constexpr std::size_t kModesOnAPlate = 3; // curved, planar, flat

CompareRow failedRow() {
  CompareRow made;
  made.combination = {"planar", std::nullopt, Platform("fit:0")};
  made.error = "the part is not closed"_text;
  return made;
}

// Advice by reach alone may name another cell than the plans show to be best.
TEST(Compare, TheSentenceNamesTheCellOfTheBestRow) {
  std::vector<CompareRow> rows{row(9, 100), row(0, 100)};
  rows[0].combination.cell = "ur5-fixed";
  rows[1].combination.cell = "ur10e-moving";
  const base::Message advice =
      base::message("{why}"_text, "ur5-fixed: its nozzle stays upright"_name);
  const Ranking ranking = rank(rows, defaultWeights());
  EXPECT_EQ(base::english(cellSentence(rows, ranking, advice)),
            "ur10e-moving: best of the planned rows (row 2)");
  std::vector<CompareRow> blocked{row(0, 1, true), row(0, 1, true)};
  EXPECT_EQ(cellSentence(blocked, rank(blocked, defaultWeights()), advice), advice);
  EXPECT_TRUE(cellSentence(rows, ranking, {}).empty());
}

TEST(Compare, GrowthSchemesVaryOnlyTheModeThatGrows) {
  CompareOptions options = boxOptions(Stage::Decompose);
  options.growths = {GrowthScheme("reverse"), GrowthScheme("greedy"), GrowthScheme("reverse")};
  options.platforms = {Platform::madeForPart(0), Platform::madeForPart(20)};
  const std::vector<Combination> all = combinations(options);
  EXPECT_EQ(all.size(), 2u * 2u + 2u * (kModesOnAPlate - 1));
  for (const Combination& c : all)
    EXPECT_EQ(!c.growth, c.mode != "curved") << c.mode;
  EXPECT_EQ(all[0], (Combination{"curved", GrowthScheme("reverse"), {}}));
  EXPECT_EQ(all[3], (Combination{"curved", GrowthScheme("greedy"), Platform::madeForPart(20)}));
  // Without lists: every mode as the choices have it.
  const std::vector<Combination> own = combinations(boxOptions(Stage::Decompose));
  ASSERT_EQ(own.size(), kModesOnAPlate);
  EXPECT_EQ(own[0], (Combination{"curved", GrowthScheme(), {}}));
}

TEST(Compare, CellsVaryEveryWay) {
  CompareOptions options = boxOptions(Stage::Decompose);
  options.modes = {"flat", "planar"};
  options.cells = {"ur5-fixed", "t3", "five-axis"};
  const std::vector<Combination> all = combinations(options);
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[0].cell, "ur5-fixed");
  EXPECT_EQ(all[1].mode, "planar");
  EXPECT_EQ(all[2].cell, "t3");
  EXPECT_EQ(choicesOf(all[5], options.plan.choices).cell, "five-axis");
  EXPECT_EQ(rowFolder(4, all[4]), "5-flat-five-axis");
  // Without a list the cell of the choices stays.
  options.cells.clear();
  for (const Combination& c : combinations(options)) {
    EXPECT_TRUE(c.cell.empty());
    EXPECT_EQ(choicesOf(c, options.plan.choices).cell, options.plan.choices.cell);
  }
}

TEST(Compare, UnknownNamesAreRefusedBeforePlanning) {
  CompareOptions options = boxOptions(Stage::Decompose);
  options.modes = {"nonsense"};
  EXPECT_THROW(compare(options, context()), base::Error);
}

TEST(Compare, RowsEqualSinglePlansAndTheTableShowsThem) {
  const CompareOptions options = boxOptions(Stage::Replay);
  std::size_t begun = 0;
  std::vector<std::shared_ptr<PlanResult>> results;
  CompareWatch watch;
  watch.begins = [&](std::size_t i) { EXPECT_EQ(i, begun++); };
  watch.ended = [&](std::size_t i, const CompareRow&, const auto& result) {
    EXPECT_EQ(i + 1, begun);
    results.push_back(result);
  };
  const Comparison comparison = compare(options, context(), watch);
  ASSERT_EQ(comparison.rows.size(), kModesOnAPlate);
  ASSERT_EQ(results.size(), comparison.rows.size());
  std::vector<RowFiles> files(comparison.rows.size());
  files[0] = {"1-curved-auto", {"a.png"}};
  const auto json = nlohmann::json::parse(compareJson(comparison, defaultWeights(), files));
  for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
    const CompareRow& compared = comparison.rows[i];
    PlanRequest alone = options.plan;
    alone.choices = choicesOf(compared.combination, alone.choices);
    Report expected = planPart(alone, context()).job.report;
    Report found = compared.report;
    EXPECT_EQ(compared.reached, Stage::Replay);
    expected.timings = found.timings = {};
    EXPECT_EQ(reportJson(found), reportJson(expected)) << compared.combination.mode;
    EXPECT_EQ(results[i]->job.choices.item().mode, compared.combination.mode);
    EXPECT_EQ(compared.state(), nothingBlocks(expected) ? RowState::Clear : RowState::Blocked);

    const auto& line = json["rows"][i];
    EXPECT_EQ(line["number"], i + 1);
    EXPECT_EQ(line["mode"], expected.item().decomposition.mode);
    if (expected.item().decomposition.voxels > 0)
      EXPECT_EQ(line["missedVoxels"], expected.item().decomposition.missedVoxels);
    else
      EXPECT_TRUE(line["missedVoxels"].is_null()) << "means nothing to the mode";
    if (line["mode"] == "curved")
      EXPECT_TRUE(line["riskyAreaMm2"].is_null()) << "means nothing to the mode";
    else
      EXPECT_EQ(line["riskyAreaMm2"], expected.item().decomposition.riskyAreaMm2);
    EXPECT_EQ(line["uniformMisses"].is_null(), line["mode"] != "flat");
    EXPECT_EQ(line["growth"].is_null(), line["mode"] != "curved");
    EXPECT_EQ(line["supportVolumeMm3"], expected.item().decomposition.supportVolumeMm3);
    EXPECT_EQ(line["pieces"], expected.item().decomposition.pieces);
    EXPECT_EQ(line["layers"], expected.item().layers.count);
    EXPECT_EQ(line["printTimeS"], expected.motion.durationS);
    EXPECT_EQ(line["collisions"], expected.motion.collisions);
    EXPECT_EQ(line["reachableFraction"], 1.0);
    EXPECT_EQ(line["replayPassed"], expected.replay.passed);
    EXPECT_EQ(line["reached"], "replay");
    EXPECT_EQ(line["state"], "clear");
  }
  EXPECT_EQ(json["rows"][0]["pictures"][0], "a.png");
  EXPECT_EQ(json["ranking"].size(), comparison.rows.size());
  EXPECT_EQ(json["rule"]["weights"].size(), figures().size());
}

TEST(Compare, OneThatCannotBePlannedIsARowWithItsReason) {
  CompareOptions options = boxOptions(Stage::Layers);
  options.modes = {"flat", "curved"};
  options.plan.choices.item().parameters["layerPlanes"] = "[{}]"; // is mode flat's alone
  const Comparison comparison = compare(options, context());
  ASSERT_EQ(comparison.rows.size(), 2u);
  EXPECT_EQ(comparison.rows[0].state(), RowState::Failed);
  EXPECT_FALSE(comparison.rows[0].error.empty());
  EXPECT_EQ(comparison.rows[1].state(), RowState::Clear);
  EXPECT_GT(comparison.rows[1].report.item().layers.count, 0);
  const Ranking ranking = rank(comparison.rows, defaultWeights());
  EXPECT_EQ(ranking.best, 1u);
  const auto json =
      nlohmann::json::parse(compareJson(comparison, defaultWeights(), {{}, {"2-curved-auto", {}}}));
  EXPECT_EQ(json["rows"][0]["state"], "failed");
  EXPECT_EQ(json["rows"][0]["reason"], base::english(comparison.rows[0].error));
  EXPECT_TRUE(json["rows"][0]["score"].is_null());
}

TEST(Compare, ItStopsWhenItIsCancelled) {
  const base::CancelToken cancel;
  CompareOptions options = boxOptions(Stage::Decompose);
  std::size_t ended = 0;
  CompareWatch watch;
  watch.ended = [&](std::size_t, const CompareRow&, const auto&) {
    ++ended;
    cancel.cancel();
  };
  EXPECT_THROW(compare(options, base::RunContext(cancel, 1), watch), base::Cancelled);
  EXPECT_EQ(ended, 1u);
}

TEST(Compare, ProgressNeverDecreases) {
  double last = 0.0;
  bool back = false;
  const base::RunContext ctx(base::CancelToken(), 1,
                             [&](double fraction, const voluta::base::Message&) {
                               back = back || fraction < last - 1e-12;
                               last = fraction;
                             });
  compare(boxOptions(Stage::Layers), ctx);
  EXPECT_FALSE(back);
  EXPECT_LE(last, 1.0);
}

TEST(CompareRule, BlockedRowsRankBehindAllOthers) {
  const std::vector<CompareRow> rows{failedRow(), row(0, 10, true), row(5, 900), row(5, 800)};
  const Ranking ranking = rank(rows, defaultWeights());
  EXPECT_THAT(ranking.order, ElementsAre(3, 2, 1, 0));
  EXPECT_EQ(ranking.best, 3u);
  EXPECT_TRUE(ranking.tied.empty());
  EXPECT_FALSE(ranking.score[0].has_value());
}

TEST(CompareRule, WeightsDecide) {
  // Few misses and slow, or many and fast.
  const std::vector<CompareRow> rows{row(10, 1000), row(100, 500)};
  Weights weights = defaultWeights();
  EXPECT_EQ(rank(rows, weights).best, 0u);
  EXPECT_NEAR(*rank(rows, weights).score[1], 4.0 * 1.0 + 1.0 * 0.5, 1e-12);
  setWeight(weights, "missedVoxels=0.1");
  EXPECT_EQ(rank(rows, weights).best, 1u);
  for (const char* wrong :
       {"missedVoxel=1", "missedVoxels", "missedVoxels=-1", "pieces=x", "pieces=nan", "pieces=1x"})
    EXPECT_THROW(setWeight(weights, wrong), base::Error) << wrong;
}

TEST(CompareRule, WeightIsNamedByItsLoss) {
  for (const Figure& figure : figures())
    EXPECT_EQ(figure.loss == figure.label, !figure.moreIsBetter) << figure.key;
}

TEST(CompareRule, TheFirstOfEqualsIsBestAndTheOthersAreNamed) {
  const std::vector<CompareRow> rows{row(9, 100), row(5, 100), row(5, 100)};
  const Ranking ranking = rank(rows, defaultWeights());
  EXPECT_EQ(ranking.best, 1u);
  EXPECT_THAT(ranking.tied, ElementsAre(2));
}

TEST(CompareRule, NoneIsBestWhereAllAreBlocked) {
  const std::vector<CompareRow> rows{row(9, 100, true), row(5, 100, true), failedRow()};
  const Ranking ranking = rank(rows, defaultWeights());
  EXPECT_FALSE(ranking.best.has_value());
  EXPECT_THAT(ranking.order, ElementsAre(1, 0, 2));
  EXPECT_FALSE(rank({}, defaultWeights()).best.has_value());
}

// A stiffness that is unknown is no better than any other.
TEST(CompareRule, AnUnknownFigureOfALoadCountsAsTheWorst) {
  CompareRow known = row(0, 100), unknown = row(0, 100);
  for (CompareRow* one : {&known, &unknown})
    one->report.toolpath.load = {.forceN = 20.0,
                                 .infillAlignedFraction = 0.5,
                                 .stiffnessNPerMm = 100.0,
                                 .acrossLayersMPa = 0.2};
  unknown.report.toolpath.load.stiffnessNPerMm = std::nan("");
  unknown.report.toolpath.load.acrossLayersMPa = std::nan("");
  const Ranking ranking = rank({unknown, known, unknown}, defaultWeights());
  EXPECT_EQ(*ranking.score[0], *ranking.score[1]) << "the worst that any has";
  known.report.toolpath.load.stiffnessNPerMm = 200.0;
  CompareRow soft = known;
  soft.report.toolpath.load.stiffnessNPerMm = 50.0;
  EXPECT_EQ(rank({unknown, known, soft}, defaultWeights()).best, 1u);
  for (const Figure& figure : figures())
    if (figure.key == "deflectionMm" || figure.key == "acrossLayersMPa") {
      EXPECT_TRUE(figure.of(known)) << figure.key;
      EXPECT_FALSE(figure.of(unknown)) << figure.key;
    }
}

TEST(CompareRule, AWayThatDidNotComeToMovesIsNoFasterThanOneThatDid) {
  CompareRow stopped = row(0, 0);
  stopped.reached = Stage::Toolpath;
  EXPECT_EQ(rank({stopped, row(0, 5000)}, defaultWeights()).best, 1u);
}

} // namespace
