// A print that is taken up again: a project of its own, or the document as it was.
#include "document/opening.h"
#include "pipeline/checked_program.h"

#include "document/document.h"
#include "document/parts.h"
#include "document/planning.h"
#include "motion/resumed_motion.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

namespace voluta::document {
namespace {

using project::Stage;

class ResumingTest : public testing::Test {
protected:
  void SetUp() override {
    document_.openPart(test::boxPart(), {}, true);
    plan();
    ASSERT_TRUE(document_.upToDate(Stage::Replay));
  }
  void plan() {
    QSignalSpy finished(&planning_, &Planning::finished);
    planning_.plan();
    ASSERT_TRUE(finished.wait(120000));
  }
  std::size_t middle() const {
    const plan::Trajectory& t = *document_.result(Stage::Motion)->job.trajectory;
    return motion::resumePointOfBead(t, t.pointCount() / 2).value();
  }
  void resume() {
    QSignalSpy opened(&opening_, &Opening::opened);
    opening_.resume(middle());
    ASSERT_TRUE(opened.wait(120000));
  }

  Document document_;
  Planning planning_{document_};
  Opening opening_{document_, planning_};
};

TEST_F(ResumingTest, OpensAsAProjectOfItsOwn) {
  const std::size_t point = middle();
  const double deposited = document_.result(Stage::Motion)->job.trajectory->extrudedMm3[point];
  resume();
  EXPECT_TRUE(document_.isRest());
  EXPECT_TRUE(document_.projectFile().isEmpty());
  EXPECT_TRUE(document_.name().endsWith("-rest"));
  EXPECT_TRUE(document_.dirty());
  EXPECT_FALSE(document_.undoStack()->canUndo());
  for (const Stage stage : {Stage::Load, Stage::Toolpath, Stage::Motion, Stage::Replay})
    EXPECT_TRUE(document_.upToDate(stage));
  const project::Job& job = document_.result(Stage::Motion)->job;
  EXPECT_DOUBLE_EQ(job.trajectory->extrudedMm3[job.resumedAt], deposited);
}

TEST_F(ResumingTest, CancelledTheDocumentIsAsItWas) {
  const auto before = document_.result(Stage::Replay);
  QSignalSpy cancelled(&opening_, &Opening::cancelled);
  opening_.resume(middle());
  opening_.cancel();
  if (cancelled.isEmpty()) {
    ASSERT_TRUE(cancelled.wait(20000));
  }
  EXPECT_EQ(document_.result(Stage::Replay), before);
  EXPECT_FALSE(document_.isRest());
  EXPECT_FALSE(document_.name().endsWith("-rest"));
}

TEST_F(ResumingTest, PlanWritesProgramsAgainAndUndoRestoresIt) {
  resume();
  const auto motion = document_.result(Stage::Motion)->job.trajectory;
  const std::size_t at = document_.result(Stage::Motion)->job.resumedAt;
  const auto before = document_.result(Stage::Replay)->checked.at(0);
  document_.setParameter("urscriptForm", "port");
  EXPECT_TRUE(document_.isRest());
  EXPECT_FALSE(document_.upToDate(Stage::Replay));
  plan();
  const auto result = document_.result(Stage::Replay);
  EXPECT_TRUE(document_.upToDate(Stage::Replay));
  EXPECT_EQ(document_.result(Stage::Motion)->job.trajectory, motion);
  EXPECT_EQ(result->job.resumedAt, at);
  ASSERT_FALSE(result->checked.empty());
  // Another text of the same motion: the same verdict.
  EXPECT_EQ(result->checked[0]->verdict.passed, before->verdict.passed);
  EXPECT_EQ(result->checked[0]->verdict.coveredFraction, before->verdict.coveredFraction);
  EXPECT_EQ(result->checked[0]->verdict.controllerDurationS, before->verdict.controllerDurationS);
  EXPECT_NE(result->checked[0]->program.files[0].text, before->program.files[0].text);
  EXPECT_TRUE(result->checked[0]->program.files[0].text.ends_with("\nend\n"));
  // Another motion is not this rest's.
  document_.setParameter("liftMm", "7");
  EXPECT_FALSE(document_.isRest());
  EXPECT_FALSE(document_.upToDate(Stage::Motion));
  document_.undoStack()->undo();
  EXPECT_TRUE(document_.isRest());
}

TEST_F(ResumingTest, SavedAndReopenedItIsTheRestStill) {
  resume();
  const std::size_t at = document_.result(Stage::Motion)->job.resumedAt;
  const QTemporaryDir folder;
  const QString file = folder.filePath("rest.voluta");
  project::writeJob(file.toStdString(), document_.snapshot());
  QSignalSpy opened(&opening_, &Opening::opened);
  opening_.openProject(file);
  ASSERT_TRUE(opened.wait(20000));
  EXPECT_TRUE(document_.isRest());
  EXPECT_TRUE(document_.upToDate(Stage::Replay));
  plan(); // the programs, which a project does not keep
  EXPECT_TRUE(document_.isRest());
  EXPECT_EQ(document_.result(Stage::Replay)->job.resumedAt, at);
  EXPECT_FALSE(document_.result(Stage::Replay)->checked.empty());
}

} // namespace
} // namespace voluta::document
