#include "gui/watchdog.h"
#include "helpers/kept_source.h"
#include "viewer/vtk_view.h"
#include "window/window_theme.h"

#include <QSettings>
#include <gtest/gtest.h>

// test_gui [--source=export_test.cpp]: all cases, or those of one source file.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (!voluta::test::keepCasesOfSource(argc, argv))
    return 1;
  voluta::viewer::VtkView::setDefaultFormat();
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QSettings::setDefaultFormat(QSettings::IniFormat);
  voluta::test::WatchedApplication app(argc, argv);
  QApplication::setApplicationName("voluta");
  QApplication::setOrganizationName("voluta");
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
  voluta::window::applyAppearance(app, voluta::window::Appearance::Light);
  return RUN_ALL_TESTS();
}
