#include "helpers/kept_source.h"

#include <QApplication>
#include <gtest/gtest.h>

// These widgets need no OpenGL: without a display they are tried without one.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (!voluta::test::keepCasesOfSource(argc, argv))
    return 1;
  if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QApplication::setStyle(QStringLiteral("Fusion"));
  QLocale::setDefault(QLocale::c());
  return RUN_ALL_TESTS();
}
