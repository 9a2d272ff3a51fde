#include "helpers/kept_source.h"

#include <QGuiApplication>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <gtest/gtest.h>

// Nothing is shown: no display is needed. Settings and copies go to a folder of their own.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (!voluta::test::keepCasesOfSource(argc, argv))
    return 1;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir state;
  qputenv("XDG_CONFIG_HOME", state.path().toLocal8Bit());
  qputenv("VOLUTA_STATE_DIR", state.path().toLocal8Bit());
  QGuiApplication application(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("voluta-test"));
  QCoreApplication::setApplicationName(QStringLiteral("voluta-test"));
  QLocale::setDefault(QLocale::c());
  return RUN_ALL_TESTS();
}
