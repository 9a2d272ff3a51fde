// Advice on cells for a part: the rules of Boge 2019 (table 6.7) and Castelli 2020 (6.6) over six
// cells, and the sentence with the reason.
#include "base/text.h"
#include "pipeline/cell_advice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gmock/gmock.h>

namespace voluta::pipeline {
namespace {

using cells::CellForm;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<std::string> kSix = {"ur5-fixed",        "five-axis",   "ur5e-moving",
                                       "kr10-r1100-track", "rv2f-moving", "irb6700-moving"};

class CellAdviser : public ::testing::Test {
protected:
  void SetUp() override { setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1); }

  // A solid block on the plate.
  static CellNeeds block(double width, double depth, double height, double tiltRad,
                         double gPerCm3 = 1.24) {
    CellNeeds needs;
    const double x = 0.5 * width, y = 0.5 * depth;
    needs.foot = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    needs.radiusMm = std::hypot(x, y);
    needs.highMm = height;
    needs.kg = 1e-6 * gPerCm3 * width * depth * height;
    needs.centreMm = 0.5 * height;
    needs.tiltRad = tiltRad;
    return needs;
  }
  static CellComparison over(const std::vector<std::string>& ids, const CellNeeds& needs,
                             const std::string& process = "fdm-1.0") {
    std::vector<CellAdvice> rows;
    for (const std::string& id : ids)
      rows.push_back(adviceOn(id, needs, process::loadProcess(process), {}));
    return compared(needs, std::move(rows));
  }
  static std::string best(const CellComparison& comparison) {
    return comparison.best ? comparison.rows[*comparison.best].cell : "";
  }
  static CellAdvice row(const CellComparison& comparison, const std::string& id) {
    return *std::ranges::find(comparison.rows, id, &CellAdvice::cell);
  }
  static CellAdvice made(const std::string& id, CellForm form, double reach) {
    CellAdvice advice;
    advice.cell = id;
    advice.form = form;
    advice.reach = reach;
    advice.uprightReach = 1.0;
    return advice;
  }
  static constexpr double kTilt = 1.0471975511965976;
};

TEST_F(CellAdviser, formsAreTheThesissHardware) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const auto formOf = [&](const std::string& id) {
    return cells::formOf(robot::loadCell(id, process, {{-9, -9}, {9, -9}, {0, 9}}), process);
  };
  EXPECT_EQ(formOf("ur5-fixed"), CellForm::FixedNozzle);
  EXPECT_EQ(formOf("ur3-fixed"), CellForm::FixedNozzle);
  EXPECT_EQ(formOf("five-axis"), CellForm::TiltingTable);
  EXPECT_EQ(formOf("irb1200-irbp"), CellForm::TiltingTable);
  EXPECT_EQ(formOf("ur5e-moving"), CellForm::RaisedPlate);
  EXPECT_EQ(formOf("kr10-r1100-track"), CellForm::TableOnFloor);
  const process::Process large = process::loadProcess("large-7.6");
  EXPECT_EQ(
      cells::formOf(robot::loadCell("irb6700-moving", large, {{-9, -9}, {9, -9}, {0, 9}}), large),
      CellForm::TableOnFloor);
  // Table 6.7, with the row of the small platform as its text has it.
  EXPECT_FALSE(cells::traitsOf(CellForm::FixedNozzle).largeParts);
  EXPECT_TRUE(cells::traitsOf(CellForm::FixedNozzle).smallPlatform);
  EXPECT_TRUE(cells::traitsOf(CellForm::FixedNozzle).gravityHelps);
  EXPECT_TRUE(cells::traitsOf(CellForm::TableOnFloor).largeParts);
  EXPECT_FALSE(cells::traitsOf(CellForm::TableOnFloor).smallPlatform);
  EXPECT_FALSE(cells::traitsOf(CellForm::TableOnFloor).gravityHelps);
  EXPECT_TRUE(cells::traitsOf(CellForm::RaisedPlate).largeParts);
  EXPECT_TRUE(cells::traitsOf(CellForm::RaisedPlate).smallPlatform);
  EXPECT_FALSE(cells::traitsOf(CellForm::RaisedPlate).gravityHelps);
}

// "A fixed tool has to be preferred unless weight and size cannot be handled."
TEST_F(CellAdviser, aSmallPartIsForTheFixedNozzle) {
  const CellComparison all = over(kSix, block(50, 40, 60, kTilt));
  EXPECT_EQ(best(all), "ur5-fixed");
  EXPECT_THAT(base::english(all.reason), StartsWith("ur5-fixed: its fixed nozzle stays upright"));
  EXPECT_EQ(row(all, "ur5-fixed").leanRad, 0.0);
  EXPECT_EQ(row(all, "five-axis").leanRad, 0.0);
  EXPECT_EQ(row(all, "ur5e-moving").leanRad, kTilt);
}

TEST_F(CellAdviser, aLargePartIsForTheMovingNozzle) {
  const CellComparison all = over(kSix, block(280, 280, 60, kTilt));
  EXPECT_EQ(best(all), "ur5e-moving");
  EXPECT_THAT(base::english(all.reason),
              HasSubstr("ur5-fixed is out: its largest plate is too small for the foot"));
  EXPECT_THAT(base::english(all.reason), HasSubstr("gravity does not help at up to 60"));
}

// A small part on a heavy body.
TEST_F(CellAdviser, aHeavyBodyIsForTheMovingNozzle) {
  CellNeeds needs = block(100, 100, 80, kTilt);
  needs.kg = 6.0;
  const CellComparison all = over({"ur5-fixed", "ur5e-moving", "kr10-r1100-track"}, needs);
  EXPECT_EQ(best(all), "ur5e-moving");
  EXPECT_THAT(base::english(all.reason),
              HasSubstr("ur5-fixed is out: its flange would carry 6.5 kg"));
}

// A wall as of concrete printing: the nozzle moves, over the floor.
TEST_F(CellAdviser, aLargeWallIsForTheFloor) {
  const CellComparison all = over(kSix, block(1400, 200, 600, 0.0), "large-7.6");
  EXPECT_EQ(best(all), "irb6700-moving");
  EXPECT_THAT(base::english(all.reason), HasSubstr("always upright, over a table on the floor"));
}

// "The hopper prevents the tool from any or excessive reorientation."
TEST_F(CellAdviser, aBulkyHeadDoesNotLean) {
  const CellAdvice moving =
      adviceOn("irb6700-moving", block(400, 400, 200, kTilt), process::loadProcess("pellet-4"), {});
  EXPECT_EQ(base::english(moving.out), "its head is too bulky to lean");
  EXPECT_TRUE(
      adviceOn("irb6700-moving", block(400, 400, 200, 0.0), process::loadProcess("pellet-4"), {})
          .out.empty());
}

TEST_F(CellAdviser, noneHasAReasonForEach) {
  const CellComparison all = over({"ur5-fixed", "t3"}, block(280, 280, 60, kTilt));
  EXPECT_FALSE(all.best);
  EXPECT_THAT(base::english(all.reason), StartsWith("none of these cells: ur5-fixed is out: "));
  EXPECT_THAT(base::english(all.reason), HasSubstr("t3 is out: "));
}

// The order of forms is independent of the order of the rows; of equals the first, or the one that
// reaches more.
TEST_F(CellAdviser, formsAreTakenInTheirOrder) {
  const std::vector<CellAdvice> rows = {
      made("floor", CellForm::TableOnFloor, 1.0), made("raised", CellForm::RaisedPlate, 0.9),
      made("further", CellForm::RaisedPlate, 0.95), made("table", CellForm::TiltingTable, 0.9),
      made("fixed", CellForm::FixedNozzle, 0.9)};
  std::vector<std::string> expected = {"fixed", "table", "further", "raised", "floor"};
  std::vector<CellAdvice> left = rows;
  for (const std::string& id : expected) {
    const CellComparison all = compared(block(50, 50, 50, kTilt), left);
    EXPECT_EQ(best(all), id);
    std::erase_if(left, [&](const CellAdvice& advice) { return advice.cell == id; });
  }
  // With all layers horizontal the nozzle is upright everywhere.
  const CellComparison flat = compared(block(50, 50, 50, 0.0), {rows[0], rows[1], rows[3]});
  EXPECT_EQ(best(flat), "floor");
}

} // namespace
} // namespace voluta::pipeline
