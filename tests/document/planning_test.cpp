#include "document/planning.h"

#include "document/opening.h"
#include "document/parts.h"
#include "pipeline/remedies.h"
#include "plan/finding_kinds.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>

namespace voluta::document {
namespace {

using project::Stage;

class PlanningTest : public testing::Test {
protected:
  void open() { document_.openPart(test::boxPart(), {}, true); }
  // Runs to its end.
  void plan(Stage until) {
    QSignalSpy finished(&planning_, &Planning::finished);
    planning_.plan(until);
    ASSERT_TRUE(finished.wait(120000));
  }
  StageState state(Stage stage) { return document_.state(stage); }
  // A box of 9 mm as text, without its lid except for the given triangles.
  static QString writeBox(const QTemporaryDir& folder, const QByteArrayList& lid) {
    QFile file(folder.filePath("box.off"));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("OFF\n8 " + QByteArray::number(10 + lid.size()) +
               " 0\n0 0 0\n9 0 0\n9 9 0\n0 9 0\n0 0 9\n9 0 9\n9 9 9\n0 9 9\n"
               "3 0 2 1\n3 0 3 2\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
               "3 3 0 4\n3 3 4 7\n");
    for (const QByteArray& triangle : lid)
      file.write("3 " + triangle + "\n");
    return file.fileName();
  }

  Document document_;
  Planning planning_{document_};
};

TEST_F(PlanningTest, StagesFinishOneByOne) {
  open();
  std::vector<Stage> seen;
  QObject::connect(&planning_, &Planning::stageDone, &document_,
                   [&](Stage stage) { seen.push_back(stage); });
  plan(Stage::Layers);
  EXPECT_EQ(seen, (std::vector{Stage::Load, Stage::Decompose, Stage::Layers}));
  EXPECT_EQ(state(Stage::Load), StageState::Done);
  EXPECT_EQ(state(Stage::Layers), StageState::Done);
  EXPECT_EQ(state(Stage::Toolpath), StageState::Nothing);
  ASSERT_TRUE(document_.result(Stage::Layers));
  EXPECT_TRUE(document_.result(Stage::Layers)->job.item().layers);
}

TEST_F(PlanningTest, ChangeOutdatesOnlyTheStagesThatUseIt) {
  open();
  plan(Stage::Toolpath);
  document_.setParameter("walls", "3");
  EXPECT_EQ(state(Stage::Layers), StageState::Done);
  EXPECT_EQ(state(Stage::Toolpath), StageState::OutOfDate);
  EXPECT_TRUE(document_.result(Stage::Toolpath)) << "stays on show";
  document_.undoStack()->undo();
  EXPECT_EQ(state(Stage::Toolpath), StageState::Done);
  document_.setParameter("voxelMm", "1.2");
  EXPECT_EQ(state(Stage::Load), StageState::Done);
  EXPECT_EQ(state(Stage::Decompose), StageState::OutOfDate);
}

TEST_F(PlanningTest, PlanRecomputesOnlyOutOfDateStages) {
  open();
  plan(Stage::Toolpath);
  const auto layers = document_.result(Stage::Layers)->job.item().layers;
  QSignalSpy changed(&document_, &Document::resultChanged);
  document_.setParameter("walls", "3");
  plan(Stage::Toolpath);
  EXPECT_EQ(document_.result(Stage::Layers)->job.item().layers, layers);
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(changed[0][0].value<Stage>(), Stage::Toolpath);
}

TEST_F(PlanningTest, AnotherPartDropsTheResults) {
  open();
  plan(Stage::Decompose);
  document_.openPart(test::boxPart(6.0, "small.stl"), {}, true);
  EXPECT_EQ(state(Stage::Decompose), StageState::Nothing);
  EXPECT_FALSE(document_.lastResult());
}

TEST_F(PlanningTest, UndoBringsBackThePlanOfThePartBefore) {
  open();
  plan(Stage::Layers);
  const auto layers = document_.result(Stage::Layers);
  EXPECT_TRUE(document_.hasUnsavedWork());
  document_.openPart(test::boxPart(6.0, "small.stl"), {}, true);
  plan(Stage::Decompose);
  const auto voxels = document_.result(Stage::Decompose);
  document_.undoStack()->undo();
  EXPECT_EQ(document_.result(Stage::Layers), layers);
  EXPECT_TRUE(document_.upToDate(Stage::Layers));
  document_.undoStack()->redo();
  EXPECT_EQ(document_.result(Stage::Decompose), voxels);
  EXPECT_FALSE(document_.result(Stage::Layers));
}

TEST_F(PlanningTest, StagesOfAPartThatUndoHasTakenAwayAreIgnored) {
  open();
  plan(Stage::Layers);
  const auto layers = document_.result(Stage::Layers), placed = document_.result(Stage::Load);
  document_.openPart(test::boxPart(6.0, "small.stl"), {}, true);
  planning_.plan(Stage::Layers);
  QSignalSpy finished(&planning_, &Planning::finished),
      changed(&document_, &Document::resultChanged);
  document_.undoStack()->undo();
  changed.clear();
  ASSERT_TRUE(finished.wait(60000));
  EXPECT_TRUE(changed.empty());
  EXPECT_EQ(document_.result(Stage::Layers), layers);
  EXPECT_EQ(document_.result(Stage::Load), placed);
  EXPECT_TRUE(document_.upToDate(Stage::Layers));
}

TEST_F(PlanningTest, APlanAfterASaveIsUnsavedWork) {
  open();
  document_.saved("/tmp/a.voluta", document_.revision(), document_.snapshot());
  EXPECT_FALSE(document_.hasUnsavedWork());
  QSignalSpy dirty(&document_, &Document::dirtyChanged);
  plan(Stage::Layers);
  EXPECT_EQ(dirty.size(), 1);
  EXPECT_TRUE(document_.hasUnsavedWork());
  document_.saved("/tmp/a.voluta", document_.revision(), document_.snapshot());
  EXPECT_FALSE(document_.dirty());
  EXPECT_FALSE(document_.hasUnsavedWork());
  // Results made from settings that were undone are in the file.
  document_.setParameter("walls", "3");
  document_.undoStack()->undo();
  EXPECT_FALSE(document_.dirty());
}

TEST_F(PlanningTest, ACancelFreesTheWindowAndLeavesTheLastResult) {
  open();
  plan(Stage::Load);
  const auto before = document_.lastResult();
  document_.setParameter("voxelMm", "0.5");
  QSignalSpy cancelled(&planning_, &Planning::cancelled);
  planning_.plan(Stage::Replay);
  QSignalSpy stageDone(&planning_, &Planning::stageDone);
  planning_.cancel();
  EXPECT_FALSE(planning_.running());
  EXPECT_EQ(cancelled.size(), 1);
  EXPECT_EQ(document_.lastResult(), before);
  EXPECT_EQ(state(Stage::Load), StageState::Done);
  EXPECT_TRUE(stageDone.empty());
  plan(Stage::Decompose); // a new run is possible, and the only one to deliver
  EXPECT_EQ(stageDone.size(), 2);
  EXPECT_EQ(state(Stage::Decompose), StageState::Done);
}

TEST_F(PlanningTest, CancelDuringAPlanRestoresTheShownResults) {
  open();
  plan(Stage::Toolpath);
  const auto voxels = document_.result(Stage::Decompose), paths = document_.result(Stage::Toolpath);
  document_.setParameter("voxelMm", "1.2");
  QObject::connect(&planning_, &Planning::stageDone, &document_, [&](Stage stage) {
    if (stage == Stage::Decompose)
      planning_.cancel();
  });
  QSignalSpy cancelled(&planning_, &Planning::cancelled);
  planning_.plan(Stage::Replay);
  ASSERT_TRUE(cancelled.wait(60000));
  EXPECT_EQ(document_.result(Stage::Decompose)->job.item().decomposition(),
            voxels->job.item().decomposition());
  EXPECT_EQ(document_.result(Stage::Toolpath), paths);
  EXPECT_EQ(state(Stage::Decompose), StageState::OutOfDate);
  EXPECT_EQ(state(Stage::Toolpath), StageState::OutOfDate);
  EXPECT_FALSE(document_.voxelsAhead());
}

TEST_F(PlanningTest, CancelKeepsTheStagesFinishedInTheFirstRun) {
  open();
  QObject::connect(&planning_, &Planning::stageDone, &document_, [&](Stage stage) {
    if (stage == Stage::Layers)
      planning_.cancel();
  });
  QSignalSpy cancelled(&planning_, &Planning::cancelled);
  planning_.plan(Stage::Replay);
  ASSERT_TRUE(cancelled.wait(60000));
  EXPECT_EQ(state(Stage::Layers), StageState::Done);
  EXPECT_EQ(state(Stage::Toolpath), StageState::Nothing);
}

TEST_F(PlanningTest, AChangeWhileRunningStartsOverWhereWanted) {
  open();
  planning_.setStartsOver(true);
  QSignalSpy started(&planning_, &Planning::started), finished(&planning_, &Planning::finished);
  planning_.plan(Stage::Motion);
  document_.setParameter("walls", "3");
  document_.setParameter("walls", "1");
  ASSERT_TRUE(finished.wait(120000));
  EXPECT_EQ(finished.size(), 1);
  EXPECT_LE(started.size(), 2);
  EXPECT_TRUE(started.size() == 1 || state(Stage::Toolpath) == StageState::Done);
}

TEST_F(PlanningTest, AnEditAsThePlanEndsIsPlannedToo) {
  open();
  planning_.setStartsOver(true);
  bool edited = false;
  QObject::connect(&planning_, &Planning::stageDone, &planning_, [&](Stage stage) {
    if (stage == Stage::Layers && !edited) {
      edited = true; // the plan ends sooner than an edit usually starts one over
      document_.setParameter("voxelMm", "1.2");
    }
  });
  QSignalSpy finished(&planning_, &Planning::finished);
  planning_.plan(Stage::Layers);
  ASSERT_TRUE(finished.wait(120000));
  EXPECT_TRUE(edited);
  EXPECT_EQ(finished.size(), 1);
  EXPECT_EQ(state(Stage::Layers), StageState::Done);
  EXPECT_EQ(document_.result(Stage::Layers)->job.choices.item().parameters.at("voxelMm"), "1.2");
}

TEST_F(PlanningTest, AChangeWhileRunningMakesTheResultOutOfDateWhereNot) {
  open();
  QSignalSpy finished(&planning_, &Planning::finished);
  planning_.plan(Stage::Decompose);
  EXPECT_EQ(state(Stage::Load), StageState::Running);
  document_.setParameter("voxelMm", "1.2");
  ASSERT_TRUE(finished.wait(120000));
  EXPECT_EQ(state(Stage::Decompose), StageState::OutOfDate);
}

TEST_F(PlanningTest, ErrorNamesItsStageUntilTheChoicesChange) {
  open();
  project::Choices choices = document_.choices();
  choices.cell = "ur5-fixd";
  document_.setChoices(choices, "Change the cell");
  QSignalSpy failed(&planning_, &Planning::failed);
  planning_.plan(Stage::Motion);
  ASSERT_TRUE(failed.wait(20000));
  EXPECT_TRUE(failed[0][1].toString().contains("ur5-fixed")) << qPrintable(failed[0][1].toString());
  EXPECT_FALSE(failed[0][1].toString().contains('\n'));
  EXPECT_EQ(state(Stage::Load), StageState::Failed);
  document_.undoStack()->undo();
  EXPECT_EQ(state(Stage::Load), StageState::Nothing);
}

TEST_F(PlanningTest, WithoutAPartThereIsNothingToPlan) {
  planning_.plan();
  EXPECT_FALSE(planning_.running());
}

TEST_F(PlanningTest, PlanningWaitsForTheRepair) {
  const auto asRead = test::boxPart();
  document_.openPart(asRead, {}, false);
  QSignalSpy started(&planning_, &Planning::started), finished(&planning_, &Planning::finished);
  planning_.plan(Stage::Load);
  EXPECT_TRUE(planning_.running());
  EXPECT_EQ(started.size(), 0);
  document_.replaceSource(asRead, test::boxPart());
  EXPECT_EQ(started.size(), 1);
  ASSERT_TRUE(finished.wait(20000));
}

TEST_F(PlanningTest, APartIsShownAsReadAndThenRepaired) {
  // A box with one half of its lid twice.
  const QTemporaryDir folder;
  const QString file = writeBox(folder, {"4 5 6", "4 6 7", "4 6 7"});
  Opening opening(document_, planning_);
  QSignalSpy opened(&opening, &Opening::opened), repaired(&opening, &Opening::repaired);
  std::size_t asRead = 0;
  QObject::connect(&opening, &Opening::opened, &document_,
                   [&] { asRead = document_.source()->mesh->triangles.size(); });
  opening.open(file);
  ASSERT_TRUE(opened.wait(10000));
  EXPECT_EQ(asRead, 13u);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !repaired.isEmpty(); }, 10000));
  EXPECT_EQ(document_.source()->mesh->triangles.size(), 12u);
  EXPECT_FALSE(document_.source()->open);
  EXPECT_TRUE(document_.sourceReady());
  EXPECT_EQ(document_.undoStack()->count(), 1) << "one edit, not two";

  project::Choices choices = document_.choices();
  choices.item().repair = false;
  document_.setChoices(choices, "Do not repair");
  ASSERT_TRUE(repaired.wait(10000));
  EXPECT_EQ(document_.source()->mesh->triangles.size(), 13u);
}

TEST_F(PlanningTest, ABoxWithoutItsLidIsClosedOnTheUsersWordOnly) {
  const QTemporaryDir folder;
  Opening opening(document_, planning_);
  QSignalSpy repaired(&opening, &Opening::repaired);
  opening.open(writeBox(folder, {}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !repaired.isEmpty(); }, 10000));
  EXPECT_EQ(document_.source()->mesh->triangles.size(), 10u) << "as it was read";
  document_.setParameter("openSurfaces", "refuse");
  plan(Stage::Replay);
  ASSERT_TRUE(document_.lastResult());
  EXPECT_EQ(document_.lastResult()->job.reached, Stage::Load);
  const plan::Finding asked = document_.lastResult()->job.report.findings.at(0);
  EXPECT_EQ(asked.kind, plan::FindingKind::OpenRims);
  EXPECT_TRUE(asked.blocking);

  const auto offers = pipeline::remediesFor(asked, document_.choices());
  const auto close = std::ranges::find(
      offers, "closeRims", [](const pipeline::RemedyAction& offer) { return offer.remedy->name; });
  ASSERT_NE(close, offers.end());
  document_.setChoices(close->choices, "Close the openings");
  plan(Stage::Load);
  EXPECT_EQ(document_.result(Stage::Load)->job.item().part->triangles.size(), 12u);
  const plan::Finding reported = document_.lastResult()->job.report.findings.at(0);
  EXPECT_EQ(reported.kind, plan::FindingKind::RimsClosed);
  EXPECT_FALSE(reported.blocking);
}

TEST(ProgressOfWay, ShowsRemainingTimeForTheLastWayOnly) {
  jobs::Progress progress;
  progress.stage = "Layers"_text;
  progress.fraction = 0.25;
  progress.secondsLeft = 7.0;
  for (const std::size_t number : {1, 2, 3}) {
    const jobs::Progress reported = progressOfStrategy(progress, {"pieces"_text, number, 3});
    EXPECT_EQ(base::english(reported.stage),
              "Trying pieces (" + std::to_string(number) + " of 3): Layers");
    EXPECT_EQ(reported.fraction, 0.25);
    EXPECT_EQ(reported.secondsLeft, number == 3 ? std::optional(7.0) : std::nullopt) << number;
  }
}

TEST_F(PlanningTest, FileWithoutAMeshGivesAnErrorOfOneLine) {
  const QTemporaryDir folder;
  QFile file(folder.filePath("letter.stl"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("Dear sir or madam");
  file.close();
  Opening opening(document_, planning_);
  QSignalSpy failed(&opening, &Opening::failed);
  opening.open(file.fileName());
  ASSERT_TRUE(failed.wait(10000));
  EXPECT_TRUE(failed[0][1].toString().contains("letter.stl"));
  EXPECT_FALSE(document_.source());
  EXPECT_FALSE(document_.dirty());
}

} // namespace
} // namespace voluta::document
