// The palette: every command and every setting is found by its words, and Enter runs or shows it.
#include "forms/parameter_form.h"
#include "forms/parameter_row.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "window/palette/command_palette.h"

#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>
#include <set>

namespace voluta::test {
namespace {

using project::Stage;
using window::PaletteEntry;

QStringList namesOf(const std::vector<PaletteEntry>& entries, const QStringList& words) {
  QStringList names;
  for (const PaletteEntry* entry : window::found(entries, words))
    names << entry->name;
  return names;
}

TEST(Palette, NamesComeBeforeOtherWordsAndUsableCommandsFirst) {
  const std::vector<PaletteEntry> entries{{"Open", "File", {}, "reads a plan"},
                                          {"Plan until motion", "Run", {}, {}, {}, false},
                                          {"Route", "Run", "plan, path"},
                                          {"Explanation", "Help"},
                                          {"Plan", "Run"}};
  EXPECT_EQ(namesOf(entries, {"plan"}),
            QStringList({"Plan", "Explanation", "Route", "Open", "Plan until motion"}));
  EXPECT_EQ(namesOf(entries, {"PLAN", "run"}), QStringList({"Plan", "Route", "Plan until motion"}));
  EXPECT_EQ(namesOf(entries, {}).size(), 5);
  EXPECT_TRUE(namesOf(entries, {"plan", "nowhere"}).isEmpty());
}

class PaletteTest : public WindowTest {
protected:
  void openFlat() {
    openPart(writePart("plinth.stl", box({0, 0, 0}, {20, 20, 6})));
    chooseFlat();
    ASSERT_TRUE(planned(Stage::Load));
  }
  // By its key, from wherever the focus is.
  void openPalette() {
    window().activateWindow(); // There may be no window manager to do it
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window()));
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus ? focus : &window(), Qt::Key_K, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return palette() && palette()->isVisible(); }, 5000));
    ASSERT_TRUE(waitFor([&] { return search()->hasFocus(); }, 5000));
  }
  window::CommandPalette* palette() { return window().findChild<window::CommandPalette*>(); }
  QLineEdit* search() { return palette()->findChild<QLineEdit*>("paletteSearch"); }
  QTreeWidget* list() { return palette()->findChild<QTreeWidget*>("paletteList"); }
  std::set<QString> listed() {
    std::set<QString> names;
    for (int row = 0; row < list()->topLevelItemCount(); ++row)
      names.insert(list()->topLevelItem(row)->text(0));
    return names;
  }
  // Types the words and presses Enter.
  void use(const char* words) {
    openPalette();
    QTest::keyClicks(search(), words);
    ASSERT_GT(list()->topLevelItemCount(), 0) << words;
    QTest::keyClick(search(), Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return !palette(); }, 5000));
    window().activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window()));
  }
};

TEST_F(PaletteTest, ListsEveryCommandAndEverySetting) {
  openFlat();
  openPalette();
  const std::set<QString> names = listed();
  int commands = 0;
  for (const QMenu* menu : window().findChildren<QMenu*>())
    for (const QAction* action : menu->actions())
      if (action->property("defaultShortcut").isValid()) {
        ++commands;
        EXPECT_TRUE(names.contains(action->text().remove('&')))
            << action->objectName().toStdString();
      }
  EXPECT_GT(commands, 45);
  auto* form = find<forms::ParameterForm>("parameters");
  int settings = 0;
  for (const auto* row : form->findChildren<forms::ParameterRow*>())
    if (form->offers(*row)) {
      ++settings;
      EXPECT_TRUE(names.contains(row->editor()->accessibleName())) << row->spec().key;
    } else {
      EXPECT_NE(row->spec().key, "layerHeightMm");
    }
  EXPECT_GT(settings, 60);
  for (const char* choice : {"Mode", "Platform", "Cell", "Process", "Material", "Seed"})
    EXPECT_TRUE(names.contains(choice)) << choice;
  EXPECT_FALSE(names.contains("Growth scheme")) << "flat layers have none";
  keepPicture(window(), "palette");
  QTest::keyClick(search(), Qt::Key_Escape);
  ASSERT_TRUE(waitFor([&] { return !palette(); }, 5000));
}

TEST_F(PaletteTest, EnterRunsTheCommand) {
  openFlat();
  auto* legend = find<QAction>("toggleLegend");
  const bool shown = legend->isChecked();
  use("legend");
  ASSERT_TRUE(waitFor([&] { return legend->isChecked() != shown; }, 5000));
  openPalette();
  QTest::keyClicks(search(), "meaning of colours"); // In its tool tip only
  EXPECT_TRUE(listed().contains("Legend"));
  search()->clear();
  QTest::keyClicks(search(), "qqq");
  EXPECT_EQ(list()->topLevelItemCount(), 0);
  QTest::keyClick(search(), Qt::Key_Return);
  EXPECT_TRUE(palette()->isVisible()) << "there is nothing to run";
  search()->clear();
  QTest::keyClicks(search(), "unrolled");
  QTest::keyClick(search(), Qt::Key_Return);
  EXPECT_TRUE(palette()->isVisible()) << "flat layers cannot be unrolled";
  QTest::keyClick(search(), Qt::Key_Escape);
}

TEST_F(PaletteTest, ArrowsAndClicksChoose) {
  openFlat();
  openPalette();
  QTest::keyClicks(search(), "simulate");
  ASSERT_GT(list()->topLevelItemCount(), 0);
  EXPECT_EQ(list()->topLevelItem(0)->text(0), "Simulate");
  search()->clear();
  QTest::keyClick(search(), Qt::Key_Down);
  QTest::keyClick(search(), Qt::Key_Down);
  EXPECT_EQ(list()->indexOfTopLevelItem(list()->currentItem()), 2);
  QTest::keyClicks(search(), "export");
  QTreeWidgetItem* item = nullptr;
  for (int row = 0; row < list()->topLevelItemCount() && !item; ++row)
    if (list()->topLevelItem(row)->text(0) == "Export")
      item = list()->topLevelItem(row);
  ASSERT_NE(item, nullptr);
  QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualItemRect(item).center());
  ASSERT_TRUE(waitFor([&] { return page() == Page::Export; }, 5000));
}

TEST_F(PaletteTest, EnterShowsTheSettingFoundByItsMeaning) {
  openFlat();
  choosePage(Page::Simulate);
  auto* form = find<forms::ParameterForm>("parameters");
  auto* lift = form->findChild<forms::ParameterRow*>("liftMm");
  ASSERT_FALSE(lift->isVisible());
  use("z hop");
  ASSERT_TRUE(waitFor([&] { return page() == Page::Prepare && lift->isVisible(); }, 5000));
  EXPECT_TRUE(lift->isAncestorOf(QApplication::focusWidget()));
  EXPECT_TRUE(waitFor([&] { return lift->visibleRegion().contains(lift->rect().center()); }, 5000));
  keepPicture(window(), "palette_setting");
  use("filament");
  ASSERT_TRUE(waitFor([&] { return find<QComboBox>("material")->hasFocus(); }, 5000));
  use("repeatable"); // In the fold for research
  ASSERT_TRUE(waitFor([&] { return find<QSpinBox>("seed")->hasFocus(); }, 5000));
  use("scale in percent"); // In the other tab
  ASSERT_TRUE(waitFor([&] { return find<QTabWidget>("prepareTabs")->currentIndex() == 1; }, 5000));
  use("build plate");
  ASSERT_TRUE(waitFor([&] { return find<QTabWidget>("prepareTabs")->currentIndex() == 0; }, 5000));
  EXPECT_TRUE(find<QWidget>("platform")->isAncestorOf(QApplication::focusWidget()));
}

TEST_F(PaletteTest, TheSearchOfSettingsGivesTheFocusBack) {
  openFlat();
  auto* line = find<forms::ParameterForm>("parameters")->findChild<QLineEdit*>("search");
  window().viewport().setFocus();
  QTest::mouseClick(line, Qt::LeftButton);
  ASSERT_TRUE(line->hasFocus());
  QTest::keyClicks(line, "brim");
  QTest::keyClick(line, Qt::Key_Escape);
  EXPECT_TRUE(line->text().isEmpty());
  EXPECT_TRUE(window().viewport().hasFocus());
  QTest::mouseClick(line, Qt::LeftButton);
  QTest::keyClicks(line, "brim");
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_EQ(line->text(), "brim");
  auto* brim = find<forms::ParameterForm>("parameters")->findChild<QWidget*>("brimWidthMm");
  EXPECT_TRUE(brim->isAncestorOf(QApplication::focusWidget())) << "the first one found";
  QTest::mouseClick(line, Qt::LeftButton);
  line->clear();
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_FALSE(line->hasFocus());
}

} // namespace
} // namespace voluta::test
