#include "document/dated_findings.h"

#include "document/parts.h"
#include "document/planning.h"
#include "plan/finding_kinds.h"

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>

namespace voluta::document {
namespace {

using project::Stage;

class DatedFindingsTest : public testing::Test {
protected:
  // A box that is too small for its beads: the replay refuses the programs.
  void SetUp() override { document_.openPart(test::boxPart(5.0), {}, true); }
  void plan(Stage until) {
    QSignalSpy finished(&planning_, &Planning::finished);
    planning_.plan(until);
    ASSERT_TRUE(finished.wait(120000));
  }

  Document document_;
  Planning planning_{document_};
};

TEST_F(DatedFindingsTest, NothingIsCheckedBeforeItIsPlanned) {
  EXPECT_EQ(uncheckedStages(document_).size(), project::kStageCount);
  plan(Stage::Layers);
  EXPECT_EQ(uncheckedStages(document_),
            (std::vector{Stage::Toolpath, Stage::Motion, Stage::Replay}));
}

TEST_F(DatedFindingsTest, FindingsStayAndAreOutOfDateAfterAChange) {
  plan(Stage::Replay);
  EXPECT_TRUE(uncheckedStages(document_).empty());
  const std::vector<DatedFinding> found = datedFindings(document_);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.size(), document_.lastResult()->job.report.findings.size());
  EXPECT_TRUE(std::none_of(found.begin(), found.end(), [](const auto& f) { return f.outOfDate; }));

  document_.setParameter("walls", "3");
  EXPECT_EQ(uncheckedStages(document_),
            (std::vector{Stage::Toolpath, Stage::Motion, Stage::Replay}));
  const std::vector<DatedFinding> older = datedFindings(document_);
  ASSERT_EQ(older.size(), found.size());
  EXPECT_TRUE(older.back().outOfDate);
  document_.undoStack()->undo();
  EXPECT_FALSE(datedFindings(document_).back().outOfDate);
}

// Newly planned layers have current findings; the programs are still those from before.
TEST_F(DatedFindingsTest, OnlyFindingsOfReplannedStagesAreCurrent) {
  plan(Stage::Replay);
  const std::size_t before = datedFindings(document_).size();
  document_.setParameter("voxelMm", "0.7");
  plan(Stage::Decompose);
  for (const DatedFinding& dated : datedFindings(document_))
    EXPECT_EQ(dated.outOfDate, plan::stageOf(dated.finding) > Stage::Decompose)
        << plan::englishReason(dated.finding);
  EXPECT_GE(datedFindings(document_).size() + 1, before);
}

} // namespace
} // namespace voluta::document
