#include "gui/watchdog.h"
#include "viewer/vtk_view.h"
#include "window/theme.h"

#include <QSettings>
#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>

namespace {
std::string sourceOf(const testing::TestInfo& test) {
  return std::filesystem::path(test.file()).filename().string();
}

// Keeps the cases of one source file, of which ctest has an entry each. Returns whether there are
// any; no case may be in a file that has no entry.
bool keepCasesOf(const std::string& source) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  std::string filter;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k) {
      const testing::TestInfo& test = *suite.GetTestInfo(k);
      if (!sourceOf(test).ends_with("_test.cpp")) {
        std::cerr << sourceOf(test) << ": cases belong in a file named ..._test.cpp\n";
        return false;
      }
      if (sourceOf(test) == source)
        filter += std::string(suite.name()) + "." + test.name() + ":";
    }
  }
  if (filter.empty())
    std::cerr << source << " has no cases\n";
  GTEST_FLAG_SET(filter, filter);
  return !filter.empty();
}
} // namespace

// test_gui [--source=export_test.cpp]: all cases, or those of one file.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const std::string option = "--source=";
  if (argc > 1 && std::string_view(argv[1]).starts_with(option) &&
      !keepCasesOf(argv[1] + option.size()))
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
