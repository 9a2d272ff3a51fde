// The shell: every page has its place in flow bar, menu and dock, every command in a menu and in
// the list of keys.
#include "forms/parameter_form.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "plan/finding_kinds.h"
#include "robot/cell_draft.h"
#include "timeline/timeline_bar.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QUndoStack>

namespace voluta::test {
namespace {

using project::Stage;

constexpr const char* kPages[] = {Page::Prepare, Page::Layers, Page::Simulate, Page::Export,
                                  Page::Compare};

TEST_F(WindowTest, EveryPageHasItsPlaceInFlowMenuAndDock) {
  auto* flow = find<window::FlowBar>("flowBar");
  auto* dock = find<QDockWidget>("pageDock");
  int key = Qt::Key_F5;
  for (const char* id : kPages) {
    window::Page* one = window().pages().find(id);
    ASSERT_NE(one, nullptr) << id;
    EXPECT_FALSE(flow->segment(id).isEmpty()) << id;
    EXPECT_FALSE(one->isShown() && one->id() != page());
    auto* action = find<QAction>((QString("page_") + id).toUtf8().constData());
    EXPECT_EQ(action->shortcut(), QKeySequence(key++)) << id;
    action->trigger();
    EXPECT_EQ(page(), id);
    EXPECT_TRUE(one->isShown());
    EXPECT_TRUE(one->side()->isVisible()) << id;
    EXPECT_EQ(dock->windowTitle(), one->title());
    EXPECT_FALSE(one->title().contains('&'));
    EXPECT_EQ(window().viewport().isVisible(), one->centre() == nullptr) << id;
  }
}

TEST_F(WindowTest, EveryCommandIsInAMenuAndInTheListOfKeys) {
  QSet<QString> listed;
  QTimer::singleShot(200, &window(), [&] {
    auto* dialog = window().findChild<QDialog*>("shortcutsDialog");
    ASSERT_NE(dialog, nullptr);
    const auto* table = dialog->findChild<QTableWidget*>();
    for (int row = 0; row < table->rowCount(); ++row)
      listed.insert(table->item(row, 0)->text());
    dialog->reject();
  });
  find<QAction>("shortcuts")->trigger();
  int commands = 0;
  for (const QMenu* menu : window().findChildren<QMenu*>())
    for (const QAction* action : menu->actions()) {
      if (!action->property("defaultShortcut").isValid())
        continue; // a line, a menu, a dock
      ++commands;
      EXPECT_TRUE(listed.contains(action->text().remove('&')))
          << action->objectName().toStdString();
    }
  EXPECT_GT(commands, 45);
  EXPECT_EQ(listed.contains("Undo"), true);
}

TEST_F(WindowTest, AScreenReaderNamesEveryFieldAndButton) {
  const auto expectNames = [&](const char* where) {
    EXPECT_EQ(withoutName(window()).join("\n").toStdString(), "") << where;
  };
  expectNames("empty");
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  find<forms::ParameterForm>("parameters")->setShowAll(true);
  for (const char* id : kPages) {
    window().pages().show(*window().pages().find(id));
    QTest::qWait(50);
    expectNames(id);
    for (auto* tabs : window().findChildren<QTabWidget*>())
      for (int tab = 0; tabs->isVisible() && tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        QTest::qWait(20);
        expectNames(id);
      }
  }
}

TEST_F(WindowTest, HelpShowsTheLog) {
  clickMenu("helpMenu", "showLog");
  QDialog* dialog = nullptr;
  ASSERT_TRUE(waitFor(
      [&] { return (dialog = window().findChild<QDialog*>("logDialog")) != nullptr; }, 5000));
  ASSERT_TRUE(dialog->isVisible());
  const QString text = dialog->findChild<QPlainTextEdit*>("logText")->toPlainText();
  EXPECT_TRUE(text.contains("voluta ")) << text.toStdString();
  QTest::mouseClick(dialog->findChild<QPushButton*>("logFolder"), Qt::LeftButton);
  EXPECT_EQ(given_.files(), QStringList(QFileInfo(path("voluta.log")).absolutePath()));
  keepPicture(*dialog, "log");
  dialog->reject();
}

// Keys that commands share with widgets: after a click they go to the command, text fields always
// keep them, and a widget reached by Tab has them itself.
TEST_F(WindowTest, SpacePlaysAndHomeShowsEverythingAfterAClickOnAnything) {
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  choosePage(Page::Simulate);
  auto* bar = find<timeline::TimelineBar>("timeline");
  auto* solids = find<QCheckBox>("simulateSolids");
  auto* tree = find<QTreeWidget>("tree");
  const auto clickTree = [&] {
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                      tree->visualItemRect(tree->topLevelItem(1)).center());
  };
  const auto clickBox = [&] {
    QTest::mouseClick(solids, Qt::LeftButton, {}, QPoint(8, solids->height() / 2));
  };
  int frames = 0;
  QObject::connect(&window().viewport(), &viewer::Viewport::cameraMoved, &window(),
                   [&] { ++frames; });
  for (const std::function<void()>& click : {std::function<void()>(clickTree), {clickBox}}) {
    click();
    QWidget* focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr);
    ASSERT_NE(focus, &window().viewport());
    const bool ticked = solids->isChecked();
    QTest::keyClick(focus, Qt::Key_Space);
    EXPECT_TRUE(bar->playing()) << focus->metaObject()->className();
    QTest::keyClick(focus, Qt::Key_Space);
    EXPECT_FALSE(bar->playing());
    EXPECT_EQ(solids->isChecked(), ticked);
    frames = 0;
    QTest::keyClick(focus, Qt::Key_Home);
    EXPECT_GT(frames, 0) << focus->metaObject()->className();
  }
  // By the keyboard alone a box is ticked.
  QTest::keyClick(tree, Qt::Key_Tab);
  solids->setFocus(Qt::TabFocusReason);
  const bool ticked = solids->isChecked();
  QTest::keyClick(solids, Qt::Key_Space);
  EXPECT_NE(solids->isChecked(), ticked);
  EXPECT_FALSE(bar->playing());
  // Text fields take the keys typed into them.
  choosePage(Page::Export);
  auto* folder = find<QWidget>("export")->findChild<QLineEdit*>("folder");
  QTest::mouseClick(folder, Qt::LeftButton);
  folder->clear();
  QTest::keyClicks(folder, "a b");
  QTest::keyClick(folder, Qt::Key_Home);
  EXPECT_EQ(folder->text(), "a b");
  EXPECT_EQ(folder->cursorPosition(), 0);
  EXPECT_FALSE(bar->playing());
}

TEST_F(WindowTest, CommandsCanBeUsedWhereTheyMeanSomething) {
  auto* move = find<QAction>("toolMove");
  EXPECT_FALSE(move->isEnabled()) << "no part";
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  EXPECT_TRUE(move->isEnabled());
  move->trigger();
  EXPECT_TRUE(move->isChecked());
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::Move);
  find<QAction>("toolTurn")->trigger();
  EXPECT_FALSE(move->isChecked());
  choosePage(Page::Layers);
  EXPECT_FALSE(move->isEnabled());
  EXPECT_FALSE(find<QAction>("toolTurn")->isChecked()) << "left with its page";
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::None);
}

// Keys of a hidden time-line must not work it.
TEST_F(WindowTest, TheTimeLineIsWorkedWhereItIsSeen) {
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  auto* bar = find<timeline::TimelineBar>("timeline");
  const auto usable = [&](const char* id) {
    choosePage(id);
    const bool play = find<QAction>("play")->isEnabled();
    for (const char* step : {"nextMove", "previousMove", "nextLayer", "previousLayer"})
      EXPECT_EQ(find<QAction>(step)->isEnabled(), play) << step;
    EXPECT_EQ(bar->isVisible(), play) << id;
    return play;
  };
  EXPECT_FALSE(usable(Page::Prepare));
  window().viewport().setFocus();
  QTest::keyClick(&window().viewport(), Qt::Key_Space);
  EXPECT_FALSE(bar->playing());
  EXPECT_TRUE(usable(Page::Layers));
  EXPECT_TRUE(usable(Page::Export));
  EXPECT_FALSE(usable(Page::Compare));
  EXPECT_TRUE(usable(Page::Simulate));
  bar->setTimeS(0.0);
  window().viewport().setFocus();
  QTest::keyClick(&window().viewport(), Qt::Key_Space);
  EXPECT_TRUE(bar->playing());
  choosePage(Page::Prepare);
  EXPECT_FALSE(bar->playing()) << "nothing stops it there";
}

TEST_F(WindowTest, HomeShowsEverythingWhereThereIsAPicture) {
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  int frames = 0;
  QObject::connect(&window().viewport(), &viewer::Viewport::cameraMoved, &window(),
                   [&] { ++frames; });
  choosePage(Page::Compare);
  frames = 0;
  for (const char* id : {"frameAll", "viewTop", "toggleSection"})
    EXPECT_FALSE(find<QAction>(id)->isEnabled()) << id;
  QTest::keyClick(&window(), Qt::Key_Home);
  EXPECT_EQ(frames, 0);
  choosePage(Page::Prepare);
  EXPECT_TRUE(find<QAction>("frameAll")->isEnabled());
  frames = 0;
  QTest::keyClick(&window(), Qt::Key_Home);
  EXPECT_GT(frames, 0);
  // Home is the way to the first entry of a list.
  auto* processes = find<QComboBox>("process");
  ASSERT_GT(processes->count(), 1);
  processes->setCurrentIndex(processes->count() - 1);
  processes->setFocus(Qt::MouseFocusReason);
  frames = 0;
  QTest::keyClick(processes, Qt::Key_Home);
  EXPECT_EQ(processes->currentIndex(), 0);
  EXPECT_EQ(frames, 0);
}

TEST_F(WindowTest, AFindingIsShownByThePageThatShowsItBest) {
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  const auto shownFor = [&](const char* stage, std::optional<double> whenS) {
    plan::Finding finding = plan::verbatimFinding(*plan::stageNamed(stage), "sample", "here", "");
    finding.whenS = whenS;
    window().pages().goTo(finding);
    return page().toStdString();
  };
  EXPECT_EQ(shownFor("motion", 1.0), Page::Layers) << "there is no motion yet";
  EXPECT_EQ(shownFor("load", {}), Page::Prepare);
  EXPECT_EQ(shownFor("toolpath", {}), Page::Layers);
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_EQ(shownFor("motion", {}), Page::Simulate);
  EXPECT_EQ(shownFor("replay", 1.5), Page::Simulate);
  EXPECT_EQ(shownFor("decompose", {}), Page::Layers);
  EXPECT_EQ(shownFor("load", {}), Page::Prepare);
}

// A project that was made with `--cell FILE.json` holds the file's whole text.
TEST_F(WindowTest, CellStoredInTheProjectIsShownByItsName) {
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  project::Choices choices = document().choices();
  choices.cell = robot::draftOfCell("ur5-fixed").named("bench-two", "Bench two").text();
  document().setChoices(choices, "cell");
  ASSERT_TRUE(planned(Stage::Load));
  EXPECT_EQ(find<QLabel>("statusCell")->text(), "Bench two");
  const auto expectWords = [](const QString& shown) {
    EXPECT_FALSE(shown.contains('{')) << shown.left(80).toStdString();
  };
  bool named = false;
  for (QTreeWidgetItemIterator at(find<QTreeWidget>("tree")); *at; ++at)
    for (int column = 0; column < (*at)->columnCount(); ++column) {
      named |= (*at)->text(column) == "Bench two";
      expectWords((*at)->text(column));
      expectWords((*at)->toolTip(column));
    }
  EXPECT_TRUE(named);
  for (const QLabel* label : window().findChildren<QLabel*>())
    expectWords(label->text());
  EXPECT_EQ(find<QComboBox>("cell")->currentText(), "Bench two");
  document().undoStack()->undo();
  EXPECT_EQ(find<QLabel>("statusCell")->text(), "UR5, nozzle fixed, plate on the flange");
}

} // namespace
} // namespace voluta::test
