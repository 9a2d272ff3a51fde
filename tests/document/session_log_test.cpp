#include "document/session_log.h"

#include "document/opening.h"
#include "document/parts.h"
#include "document/planning.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

namespace voluta::document {
namespace {

TEST(SessionLog, LogsStagesAndFailuresWithoutFolderNames) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("voluta.log"));
  Document document;
  Planning planning(document);
  Opening opening(document, planning);
  const SessionLog log(file, document, planning, opening);

  QSignalSpy failed(&opening, &Opening::failed);
  opening.open(folder.filePath(QStringLiteral("none.stl")));
  ASSERT_TRUE(failed.wait(60000));
  document.openPart(test::boxPart(), {}, true);
  QSignalSpy finished(&planning, &Planning::finished);
  planning.plan(project::Stage::Layers);
  ASSERT_TRUE(finished.wait(120000));

  QFile read(file);
  ASSERT_TRUE(read.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(read.readAll());
  for (const char* part : {"voluta ", "Qt ", "error: cannot open none.stl: ", "plans up to layers",
                           "decompose: ", "layers: ", "planned in ", " findings, "})
    EXPECT_TRUE(text.contains(QLatin1String(part))) << part << "\n" << text.toStdString();
}

TEST(SessionLog, WithoutAFileNothingIsWritten) {
  Document document;
  Planning planning(document);
  Opening opening(document, planning);
  const SessionLog log(QStringLiteral("/proc/no/such/voluta.log"), document, planning, opening);
  EXPECT_NO_THROW(log.note(QStringLiteral("lost")));
}

} // namespace
} // namespace voluta::document
