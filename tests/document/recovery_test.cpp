#include "document/recovery.h"

#include "document/autosave.h"
#include "document/parts.h"
#include "helpers/all_seeds.h"
#include "pipeline/stage_options.h"
#include "project/job.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <signal.h>

namespace voluta::document {
namespace {

struct EditLog {
  std::map<int, qint64> times;
  int last = 0;
};

EditLog readLog(const QString& file) {
  EditLog log;
  QFile in(file);
  if (!in.open(QIODevice::ReadOnly))
    return log;
  for (const QByteArray& line : in.readAll().split('\n')) {
    const QList<QByteArray> fields = line.split(' ');
    if (fields.size() == 2) {
      log.last = fields[0].toInt();
      log.times[log.last] = fields[1].toLongLong();
    }
  }
  return log;
}

// Edits for `runMs`, dies, and returns the age of the copy that it leaves; -1: it leaves none.
qint64 ageOfCopyAfterKill(int runMs, int pauseMs, int latestMs) {
  const QTemporaryDir state;
  const QString folder = state.filePath(QStringLiteral("recovery")),
                log = state.filePath(QStringLiteral("log"));
  QProcess editor;
  editor.start(QStringLiteral(ENDLESS_EDITOR),
               {folder, log, QString::number(pauseMs), QString::number(latestMs)});
  EXPECT_TRUE(editor.waitForStarted());
  EXPECT_TRUE(QTest::qWaitFor([&] { return QFile::exists(log); }, 10000));
  QTest::qWait(runMs);
  const auto alive = recoverable(folder);
  EXPECT_TRUE(alive.empty()) << "its program still runs";
  ::kill(static_cast<pid_t>(editor.processId()), SIGKILL);
  editor.waitForFinished();

  const EditLog edits = readLog(log);
  const auto left = recoverable(folder);
  if (left.empty())
    return -1;
  EXPECT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].name, "ball");
  EXPECT_TRUE(left[0].originalPath.isEmpty());
  const project::Job job = project::readJob(left[0].file.toStdString(),
                                            pipeline::allParameters()); // throws if it is half
  EXPECT_TRUE(job.item().loaded && !job.item().loaded->mesh->empty());
  const auto next = edits.times.find(job.choices.seed + 1); // the first edit that is lost
  const qint64 age = next == edits.times.end() ? 0 : edits.times.at(edits.last) - next->second;
  discardRecovered(left[0]);
  EXPECT_TRUE(QDir(folder).entryList(QDir::Files | QDir::Hidden).isEmpty());
  return age;
}

TEST(Recovery, KillAtAnyTimeLeavesACompleteRecentProject) {
  constexpr int kLatestMs = 150, kSlackMs = 1500; // writing, on a busy machine
  std::mt19937 random(20);
  int copies = 0;
  for (int i = 0; i < 20; ++i) {
    const int runMs = 100 + static_cast<int>(random() % 900);
    const qint64 age = ageOfCopyAfterKill(runMs, 40, kLatestMs);
    EXPECT_TRUE(age >= 0 || runMs < kLatestMs + kSlackMs) << runMs;
    EXPECT_LE(age, kLatestMs + kSlackMs);
    copies += age >= 0;
  }
  EXPECT_GE(copies, 12);
}

// Edits never pause, so the copy comes when it is due at the latest.
TEST(Recovery, WithTheIntervalsOfTheProgramAtMostThirtySecondsAreLost) {
  const AutosaveOptions real;
  EXPECT_LE(real.atLatestMs, 20000);
  EXPECT_LE(real.pauseMs, real.atLatestMs);
  if (!test::allSeeds())
    GTEST_SKIP() << "takes 35 s: set VOLUTA_ALL_SEEDS";
  const qint64 age = ageOfCopyAfterKill(32000, real.pauseMs, real.atLatestMs);
  EXPECT_GE(age, 0);
  EXPECT_LE(age, 30000);
}

TEST(Recovery, TheFolderCanBeChosen) {
  const QByteArray before = qgetenv("VOLUTA_STATE_DIR");
  qputenv("VOLUTA_STATE_DIR", "/somewhere");
  EXPECT_EQ(recoveryFolder(), "/somewhere/recovery");
  qputenv("VOLUTA_STATE_DIR", before);
}

TEST(Recovery, PartialFilesOfADeadProcessAreRemoved) {
  const QTemporaryDir folder;
  for (const char* name : {"one.json", ".one.voluta.Ab12Cd", ".two.json.Ab12Cd"}) {
    QFile file(folder.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"pid\": 1, \"began\": \"never\"}");
  }
  EXPECT_TRUE(recoverable(folder.path()).empty());
  EXPECT_TRUE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

TEST(Recovery, NoFolderIsNothingToRecover) {
  EXPECT_TRUE(recoverable(QStringLiteral("/no/such/folder")).empty());
}

} // namespace
} // namespace voluta::document
