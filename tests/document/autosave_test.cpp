#include "document/autosave.h"

#include "document/opening.h"
#include "document/parts.h"
#include "document/planning.h"
#include "document/saving.h"
#include "pipeline/stage_options.h"
#include "project/job.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>
#include <memory>

namespace voluta::document {
namespace {

class AutosaveTest : public testing::Test {
protected:
  AutosaveTest() {
    AutosaveOptions options;
    options.folder = folder_.path();
    options.pauseMs = 60;
    options.atLatestMs = 250;
    autosave_ = std::make_unique<Autosave>(document_, options);
  }
  QStringList files() { return QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden); }

  QTemporaryDir folder_;
  Document document_;
  std::unique_ptr<Autosave> autosave_;
};

TEST_F(AutosaveTest, WritesAfterAPause) {
  QSignalSpy written(autosave_.get(), &Autosave::written);
  document_.openPart(test::boxPart(), {}, true);
  test::setSeed(document_, 42);
  ASSERT_TRUE(written.wait(3000));
  EXPECT_EQ(
      project::readJob(autosave_->file().toStdString(), pipeline::allParameters()).choices.seed,
      42);
  QTest::qWait(200);
  EXPECT_EQ(written.size(), 1) << "two edits, one copy";
}

TEST_F(AutosaveTest, EditsWithoutPauseAreWrittenAtLatest) {
  QSignalSpy written(autosave_.get(), &Autosave::written);
  document_.openPart(test::boxPart(), {}, true);
  for (int i = 2; i < 50 && written.isEmpty(); ++i) {
    test::setSeed(document_, i);
    QTest::qWait(30);
  }
  EXPECT_GE(written.size(), 1);
}

TEST_F(AutosaveTest, ACleanDocumentLeavesNothing) {
  QSignalSpy written(autosave_.get(), &Autosave::written);
  document_.openPart(test::boxPart(), {}, true);
  ASSERT_TRUE(written.wait(3000));
  EXPECT_EQ(files().size(), 2);
  Saving saving(document_);
  QSignalSpy saved(&saving, &Saving::saved);
  const QTemporaryDir elsewhere;
  saving.saveAs(elsewhere.filePath("a"));
  ASSERT_TRUE(saved.wait(3000));
  EXPECT_TRUE(files().isEmpty());
}

TEST_F(AutosaveTest, ClosingInGoodOrderLeavesNothing) {
  QSignalSpy written(autosave_.get(), &Autosave::written);
  document_.openPart(test::boxPart(), {}, true);
  ASSERT_TRUE(written.wait(3000));
  test::setSeed(document_, 9);
  QTest::qWait(61); // a write may just have begun
  autosave_.reset();
  QTest::qWait(300);
  EXPECT_TRUE(files().isEmpty());
}

TEST_F(AutosaveTest, UnwritableFolderEmitsFailedOnce) {
  QFile file(folder_.filePath("plain"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  AutosaveOptions options;
  options.folder = folder_.filePath("plain/below");
  options.pauseMs = 10;
  Autosave autosave(document_, options);
  QSignalSpy failed(&autosave, &Autosave::failed);
  document_.openPart(test::boxPart(), {}, true);
  ASSERT_TRUE(failed.wait(3000));
  test::setSeed(document_, 5);
  QTest::qWait(200);
  EXPECT_EQ(failed.size(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains("cannot be written"));
}

TEST_F(AutosaveTest, RecoveredProjectIsUnsavedAndItsOldCopyIsRemoved) {
  document_.openPart(test::boxPart(), {}, true);
  test::setSeed(document_, 77);
  const QString orphan = folder_.filePath("orphan.voluta");
  project::writeJob(orphan.toStdString(), document_.snapshot());
  const auto found = recoverable(folder_.path());
  ASSERT_EQ(found.size(), 1u);
  Recovered recovered = found[0];
  recovered.originalPath = "/home/me/vase.voluta";

  Document fresh;
  Planning planning(fresh);
  Opening opening(fresh, planning);
  AutosaveOptions options;
  options.folder = folder_.path();
  options.pauseMs = 50;
  Autosave autosave(fresh, options);
  QSignalSpy opened(&opening, &Opening::opened), written(&autosave, &Autosave::written);
  opening.openRecovered(recovered);
  ASSERT_TRUE(opened.wait(5000));
  autosave.adopt(recovered);
  EXPECT_TRUE(fresh.dirty());
  EXPECT_EQ(fresh.projectFile(), "/home/me/vase.voluta");
  EXPECT_EQ(fresh.name(), "vase");
  EXPECT_EQ(test::seedOf(fresh), 77);
  EXPECT_TRUE(QFile::exists(orphan));
  ASSERT_TRUE(written.wait(5000));
  EXPECT_FALSE(QFile::exists(orphan));
  EXPECT_TRUE(QFile::exists(autosave.file()));
}

} // namespace
} // namespace voluta::document
