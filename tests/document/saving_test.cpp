#include "document/saving.h"
#include "plan/tool_plan.h"

#include "document/opening.h"
#include "document/parts.h"
#include "document/planning.h"
#include "document/recent_files.h"
#include "document/recovery.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace voluta::document {
namespace {

using project::Stage;

class SavingTest : public testing::Test {
protected:
  void SetUp() override { document_.openPart(test::boxPart(), {}, true); }
  void plan(Stage until) {
    QSignalSpy finished(&planning_, &Planning::finished);
    planning_.plan(until);
    ASSERT_TRUE(finished.wait(120000));
  }
  QString saveAs(const QString& file) {
    QSignalSpy saved(&saving_, &Saving::saved);
    saving_.saveAs(file);
    EXPECT_TRUE(saved.wait(10000));
    return saved.isEmpty() ? QString() : saved[0][0].toString();
  }

  QTemporaryDir folder_;
  Document document_;
  Planning planning_{document_};
  Saving saving_{document_};
};

TEST_F(SavingTest, ProjectIsReadBackWithItsResults) {
  document_.setParameter("walls", "3");
  plan(Stage::Toolpath);
  const QString file = saveAs(folder_.filePath("first"));
  EXPECT_EQ(file, folder_.filePath("first.voluta"));
  EXPECT_FALSE(document_.dirty());

  Document again;
  Planning planning(again);
  Opening opening(again, planning);
  QSignalSpy opened(&opening, &Opening::opened);
  opening.open(file);
  ASSERT_TRUE(opened.wait(10000));
  EXPECT_FALSE(again.dirty());
  EXPECT_EQ(again.name(), "first");
  EXPECT_EQ(again.choices().item().parameters.at("walls"), "3");
  EXPECT_EQ(again.state(Stage::Toolpath), StageState::Done);
  EXPECT_EQ(again.state(Stage::Motion), StageState::Nothing);
  EXPECT_EQ(again.result(Stage::Toolpath)->job.toolPlan->position,
            document_.result(Stage::Toolpath)->job.toolPlan->position);
  EXPECT_EQ(again.undoStack()->count(), 0);

  // Results in the file are not computed again.
  const auto layers = again.result(Stage::Layers)->job.item().layers;
  QSignalSpy finished(&planning, &Planning::finished);
  planning.plan(Stage::Toolpath);
  ASSERT_TRUE(finished.wait(60000));
  EXPECT_EQ(again.result(Stage::Layers)->job.item().layers, layers);
}

TEST_F(SavingTest, AReopenedProjectHasNoProgramsToHandOver) {
  plan(Stage::Replay);
  EXPECT_NE(document_.state(Stage::Replay), StageState::Nothing);
  const bool blocked = document_.state(Stage::Replay) == StageState::Blocked;
  Document again;
  Planning planning(again);
  Opening opening(again, planning);
  QSignalSpy opened(&opening, &Opening::opened);
  opening.open(saveAs(folder_.filePath("whole")));
  ASSERT_TRUE(opened.wait(10000));
  EXPECT_TRUE(again.upToDate(Stage::Replay)) << "its verdict is there";
  EXPECT_EQ(again.state(Stage::Replay), blocked ? StageState::Blocked : StageState::Nothing);
  EXPECT_EQ(again.state(Stage::Motion), document_.state(Stage::Motion));
}

TEST_F(SavingTest, RecoveredProjectOpensUnderItsOriginalName) {
  const QString copy = saveAs(folder_.filePath("0a1b2c3d.voluta"));
  Document again;
  Planning planning(again);
  Opening opening(again, planning);
  QSignalSpy started(&opening, &Opening::started), opened(&opening, &Opening::opened);
  opening.openRecovered({copy, "vase", {}, {}});
  ASSERT_TRUE(opened.wait(10000));
  EXPECT_EQ(started[0][0].toString(), "vase");
  EXPECT_TRUE(opened[0][0].toString().isEmpty()) << "no file of its own";
  opening.openRecovered({copy, "vase", "/home/vase.voluta", {}});
  ASSERT_TRUE(opened.wait(10000));
  EXPECT_EQ(opened[1][0].toString(), "/home/vase.voluta");
  EXPECT_EQ(again.projectFile(), "/home/vase.voluta");
}

TEST_F(SavingTest, ResultsThatAreOutOfDateAreLeftOut) {
  plan(Stage::Toolpath);
  document_.setParameter("walls", "3");
  const project::Job job = document_.snapshot();
  EXPECT_EQ(job.reached, Stage::Layers);
  EXPECT_TRUE(job.item().layers);
  EXPECT_FALSE(job.toolPlan);
  EXPECT_EQ(job.choices.item().parameters.at("walls"), "3");
}

TEST_F(SavingTest, AFolderThatIsNotThereLosesNothing) {
  QSignalSpy failed(&saving_, &Saving::failed);
  saving_.saveAs(folder_.filePath("no/such/place.voluta"));
  ASSERT_TRUE(failed.wait(5000));
  EXPECT_TRUE(failed[0][1].toString().contains("place.voluta"));
  EXPECT_FALSE(failed[0][1].toString().contains('\n'));
  EXPECT_TRUE(document_.dirty());
  EXPECT_TRUE(document_.projectFile().isEmpty());
}

// Every write to it fails as on a full disk.
TEST_F(SavingTest, AFailedSaveLeavesTheOldFile) {
  const QString file = saveAs(folder_.filePath("kept.voluta"));
  QFile before(file);
  ASSERT_TRUE(before.open(QIODevice::ReadOnly));
  const QByteArray bytes = before.readAll();
  test::setSeed(document_, 8);
  struct rlimit limit {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const struct rlimit small { 100, limit.rlim_max };
  const auto oldHandler = ::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  QSignalSpy failed(&saving_, &Saving::failed);
  saving_.save();
  const bool reported = failed.wait(5000);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  ::signal(SIGXFSZ, oldHandler);
  ASSERT_TRUE(reported);
  EXPECT_TRUE(document_.dirty());
  QFile after(file);
  ASSERT_TRUE(after.open(QIODevice::ReadOnly));
  EXPECT_EQ(after.readAll(), bytes);
  EXPECT_EQ(QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
  saveAs(file);
  EXPECT_FALSE(document_.dirty());
}

TEST_F(SavingTest, SavesInARowAllCount) {
  QSignalSpy saved(&saving_, &Saving::saved);
  saving_.saveAs(folder_.filePath("one"));
  saving_.saveAs(folder_.filePath("two"));
  saving_.saveAs(folder_.filePath("three"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return saved.size() == 2; }, 5000));
  EXPECT_EQ(document_.name(), "three");
}

TEST_F(SavingTest, ProjectOfANewerVersionGivesAnErrorThatNamesIt) {
  const QString file = saveAs(folder_.filePath("newer.voluta"));
  QFile edit(file);
  ASSERT_TRUE(edit.open(QIODevice::ReadWrite));
  ASSERT_EQ(edit.read(8), "VOLUTA 3");
  edit.seek(7);
  edit.write("9");
  edit.close();
  Opening opening(document_, planning_);
  QSignalSpy failed(&opening, &Opening::failed);
  opening.open(file);
  ASSERT_TRUE(failed.wait(5000));
  EXPECT_TRUE(failed[0][1].toString().contains("newer version"))
      << qPrintable(failed[0][1].toString());
  EXPECT_EQ(document_.name(), "newer") << "the document is as it was";
}

TEST_F(SavingTest, WithoutAPartThereIsNothingToSave) {
  Document empty;
  Saving saving(empty);
  QSignalSpy failed(&saving, &Saving::failed);
  saving.saveAs(folder_.filePath("empty"));
  EXPECT_EQ(failed.size(), 1);
}

TEST(RecentFiles, CopiesForRecoveryAreNone) {
  RecentFiles recent;
  recent.clear();
  recent.add("/no/part.stl");
  recent.add(recoveryFolder() + "/5f0c.voluta");
  recent.add({});
  EXPECT_EQ(recent.files(), QStringList{"/no/part.stl"});
}

TEST(RecentFiles, KeepsTheLastTenAndDropsDeadOnes) {
  RecentFiles recent;
  recent.clear();
  for (int i = 0; i < 13; ++i)
    recent.add(QStringLiteral("/no/part%1.stl").arg(i));
  recent.add("/no/part5.stl");
  recent.add("sample:vase");
  QStringList files = recent.files();
  ASSERT_EQ(files.size(), 10);
  EXPECT_EQ(files[0], "/no/part5.stl");
  EXPECT_EQ(files[1], "/no/part12.stl");
  QSignalSpy dead(&recent, &RecentFiles::dead);
  EXPECT_FALSE(recent.check("/no/part12.stl"));
  ASSERT_EQ(dead.size(), 1);
  EXPECT_FALSE(recent.files().contains("/no/part12.stl"));
  EXPECT_EQ(RecentFiles().files().size(), 9) << "kept in the settings";
}

} // namespace
} // namespace voluta::document
