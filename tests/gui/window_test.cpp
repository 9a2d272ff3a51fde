// Drives the window by clicks and keys, and checks its contents.
#include "document/mode_switch.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "helpers/sharp_prism.h"
#include "panels/findings_panel.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/samples.h"
#include "window/view_options.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QTest>
#include <QUndoStack>
#include <algorithm>
#include <vector>

namespace voluta::test {
namespace {

using document::StageState;
using project::Stage;
using window::PageState;

geometry::TriangleMesh smallBox(double side = 9.0) {
  return box({0, 0, 0}, {side, side, 5.0});
}

TEST_F(WindowTest, BeginsWithAnInvitationAndNothingToRun) {
  EXPECT_TRUE(find<QWidget>("welcome")->isVisible());
  EXPECT_FALSE(find<QAction>("plan")->isEnabled());
  EXPECT_FALSE(find<QAction>("cancel")->isEnabled());
  EXPECT_FALSE(find<QAction>("undo")->isEnabled());
  EXPECT_FALSE(document().dirty());
}

TEST_F(WindowTest, EveryCommandHasATextAndEveryIconIsThere) {
  for (const QAction* action : window().findChildren<QAction*>()) {
    if (action->objectName().isEmpty() || action->objectName().startsWith("_q_") ||
        action->isSeparator())
      continue;
    EXPECT_FALSE(action->text().isEmpty()) << action->objectName().toStdString();
  }
  for (const char* name : {"open", "save", "undo", "redo", "plan", "cancel", "toolMove", "toolTurn",
                           "toolScale", "toolLayFlat", "frameAll", "toggleSection"})
    EXPECT_FALSE(find<QAction>(name)->icon().isNull()) << name;
}

TEST_F(WindowTest, NoKeyIsGivenTwice) {
  std::map<QString, QString> owners;
  for (const QAction* action : window().findChildren<QAction*>())
    for (const QKeySequence& keys : action->shortcuts()) {
      const auto [at, fresh] = owners.emplace(keys.toString(), action->objectName());
      EXPECT_TRUE(fresh) << keys.toString().toStdString() << ": "
                         << action->objectName().toStdString() << " and "
                         << at->second.toStdString();
    }
}

TEST_F(WindowTest, OpensThroughTheFileMenuPlansAndShowsTheRoad) {
  const QString file = writePart("plinth.stl", smallBox());
  const QImage empty = picture();
  answerFileDialog(file);
  clickMenu("fileMenu", "open");
  ASSERT_TRUE(planned(Stage::Load));
  EXPECT_EQ(document().name().toStdString(), "plinth");
  EXPECT_FALSE(find<QWidget>("welcome")->isVisible());
  const QImage part = picture();
  EXPECT_GT(differingShare(empty, part), 0.05);

  clickToolBar("plan");
  EXPECT_EQ(page(), Page::Layers);
  EXPECT_TRUE(find<QAction>("cancel")->isEnabled());
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_TRUE(window().presenter().hasVoxels());
  EXPECT_TRUE(window().presenter().hasLayers());
  EXPECT_TRUE(window().presenter().hasPaths());
  EXPECT_FALSE(find<QAction>("cancel")->isEnabled());
  const QImage paths = picture();
  EXPECT_GT(differingShare(part, paths), 0.05);
  // Coloured by layer: the viewport holds more hues than the part's grey-blue.
  int vivid = 0;
  for (int y = 0; y < paths.height(); y += 4)
    for (int x = 0; x < paths.width(); x += 4)
      vivid += QColor(paths.pixel(x, y)).saturation() > 120;
  EXPECT_GT(vivid, 100);

  choosePage(Page::Simulate);
  EXPECT_TRUE(window().viewport().view().cell);
  EXPECT_EQ(window().viewport().view().world, scene::World::Base);
  const QImage before = picture();
  auto* timeline = find<timeline::TimelineBar>("timeline");
  timeline->setTimeS(0.6 * window().presenter().clock()->durationS());
  const QImage later = picture();
  EXPECT_GT(differingShare(before, later), 0.002);
}

TEST_F(WindowTest, ACancelLeavesTheLastResultAndANewRunPossible) {
  openPart(writePart("plinth.stl", smallBox()));
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  const auto kept = document().result(Stage::Layers);
  document().setParameter("voxelMm", "0.6");
  ASSERT_TRUE(planned(Stage::Load));
  EXPECT_EQ(document().state(Stage::Layers), StageState::OutOfDate);
  clickToolBar("plan");
  ASSERT_TRUE(waitFor([&] { return window().planning().running(); }));
  QTest::qWait(50);
  clickToolBar("cancel");
  EXPECT_FALSE(window().planning().running());
  EXPECT_FALSE(find<QAction>("cancel")->isEnabled());
  EXPECT_NE(document().result(Stage::Layers), nullptr);
  clickToolBar("plan");
  EXPECT_TRUE(window().planning().running());
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_NE(document().result(Stage::Layers), kept);
}

TEST_F(WindowTest, AChangeWhileRunningStartsOverAndOnlyTheNewestArrives) {
  openPart(writePart("plinth.stl", smallBox()));
  clickToolBar("plan");
  ASSERT_TRUE(waitFor([&] { return window().planning().running(); }));
  document().setParameter("walls", "1");
  ASSERT_TRUE(planned(Stage::Replay));
  const auto result = document().result(Stage::Replay);
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->job.choices.item().parameters.at("walls"), "1");
}

TEST_F(WindowTest, EditOutdatesDependentPagesAndUndoRestoresThem) {
  openPart(writePart("plinth.stl", smallBox()));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  auto* flow = find<window::FlowBar>("flowBar");
  const PageState before = flow->state(Page::Export);
  document().setParameter("infill", "concentric");
  EXPECT_EQ(document().state(Stage::Decompose), StageState::Done);
  EXPECT_EQ(document().state(Stage::Toolpath), StageState::OutOfDate);
  EXPECT_EQ(flow->state(Page::Export), PageState::OutOfDate);
  EXPECT_TRUE(document().dirty());
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().choices().item().parameters.count("infill"), 0U);
  EXPECT_EQ(flow->state(Page::Export), before);
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().choices().item().parameters.at("infill"), "concentric");
}

TEST_F(WindowTest, SlidersChooseLayersAndMoves) {
  openPart(writePart("plinth.stl", smallBox()));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Toolpath));
  auto* layers = find<timeline::LayerRangeSlider>("layerSlider");
  auto* moves = find<timeline::TimelineBar>("timeline");
  ASSERT_GT(layers->layerCount(), 3);
  EXPECT_EQ(layers->last(), layers->layerCount() - 1);
  const QImage all = picture();
  layers->setFocus();
  for (int i = 0; i < 3; ++i)
    QTest::keyClick(layers, Qt::Key_Down);
  EXPECT_EQ(window().viewport().view().lastLayer, layers->layerCount() - 4);
  const QImage fewer = picture();
  EXPECT_GT(differingShare(all, fewer), 0.01);
  moves->setFocus();
  QTest::keyClick(moves, Qt::Key_Home);
  EXPECT_EQ(window().viewport().view().moves, 0U);
  QTest::keyClick(moves, Qt::Key_Right);
  EXPECT_EQ(window().viewport().view().moves, 1U);
  EXPECT_GT(differingShare(fewer, picture()), 0.005);
}

TEST_F(WindowTest, AFindingTakesCameraSlidersAndRobotThere) {
  // Beads are round and edges are not: too little of so small a box is covered.
  openPart(writePart("small.stl", smallBox(5.0)));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  auto* panel = find<panels::FindingsPanel>("findings");
  auto* list = panel->findChild<QListView*>();
  ASSERT_GT(list->model()->rowCount(), 0);
  choosePage(Page::Prepare);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualRect(list->model()->index(0, 0)).center());
  EXPECT_NE(page(), Page::Prepare);
}

TEST_F(WindowTest, ProgramsOfAnotherPartThanAskedAreWrittenOnlyOnTheUsersWord) {
  openPart(writePart("prism.stl", sharpPrism()));
  document().setParameter("quality", "strict");
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  ASSERT_FALSE(document().result(Stage::Replay)->job.report.replay.passed);
  choosePage(Page::Export);
  QDir().mkpath(path("out"));
  auto* exporting = find<QWidget>("export");
  auto* folder = exporting->findChild<QLineEdit*>();
  folder->setFocus();
  folder->selectAll();
  QTest::keyClicks(folder, path("out"));
  QTest::keyClick(folder, Qt::Key_Tab);
  QPushButton* button = nullptr;
  for (auto* candidate : exporting->findChildren<QPushButton*>())
    if (candidate->text() == "Export")
      button = candidate;
  ASSERT_NE(button, nullptr);
  ASSERT_TRUE(button->isEnabled());
  answerBox("", QMessageBox::DestructiveRole);
  QTest::mouseClick(button, Qt::LeftButton);
  // While the set moves in, there is a note about it.
  ASSERT_TRUE(waitFor([&] {
    const QStringList names = QDir(path("out")).entryList(QDir::Files);
    return names.contains("report.json") && names.filter("UNFINISHED").isEmpty();
  }));
  const QStringList names = QDir(path("out")).entryList(QDir::Files);
  for (const QString& name : names)
    EXPECT_TRUE(name.startsWith("prism") || name.startsWith("pedestal.") || name == "report.json")
        << name.toStdString();
  EXPECT_FALSE(names.filter("prism").isEmpty());
}

TEST_F(WindowTest, ClosingOffersToSaveUnsavedChanges) {
  openPart(writePart("plinth.stl", smallBox()));
  ASSERT_TRUE(document().dirty());
  answerBox("unsavedBox", QMessageBox::RejectRole);
  window().close();
  EXPECT_TRUE(window().isVisible());
  answerFileDialog(path("kept.voluta"));
  answerBox("unsavedBox", QMessageBox::AcceptRole);
  window().close();
  ASSERT_TRUE(waitFor([&] { return !window().isVisible(); }, 10000));
  EXPECT_TRUE(QFile::exists(path("kept.voluta")));
}

TEST_F(WindowTest, ProjectIsReopenedUnchanged) {
  openPart(writePart("plinth.stl", smallBox()));
  document().setParameter("walls", "1");
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  answerFileDialog(path("plinth.voluta"));
  QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return !document().dirty(); }, 20000));
  window().open("sample:vase");
  ASSERT_TRUE(waitFor([&] { return document().source()->name == "vase.stl"; }));
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  window().open(path("plinth.voluta"));
  ASSERT_TRUE(waitFor([&] {
    return document().name() == "plinth" && window().presenter().hasPaths() &&
           !window().presenter().busy();
  }));
  EXPECT_EQ(document().choices().item().parameters.at("walls"), "1");
  EXPECT_TRUE(document().upToDate(Stage::Motion));
  EXPECT_FALSE(document().dirty());
}

TEST_F(WindowTest, EverySampleOpensWithTheChoicesItRequires) {
  for (const window::Sample& sample : window::samples()) {
    find<QAction>(sample.id)->trigger();
    const std::string file = QFileInfo(sample.path()).fileName().toStdString();
    const std::string part = file.substr(file.find(':') + 1);
    ASSERT_TRUE(waitFor([&] {
      return document().source() && document().source()->name.starts_with(part) &&
             !window().presenter().busy();
    })) << sample.id;
    const project::Choices& choices = document().choices();
    const project::Choices required = sample.required(choices);
    EXPECT_EQ(choices.item().mode, required.item().mode) << sample.id;
    EXPECT_EQ(choices.item().platform, required.item().platform) << sample.id;
    EXPECT_EQ(choices.item().parameters, required.item().parameters) << sample.id;
    EXPECT_EQ(choices.tool().process, required.tool().process) << sample.id;
    EXPECT_EQ(choices.cell, required.cell) << sample.id;
    EXPECT_EQ(document::obstacle(choices), QString()) << sample.id;
    document().undoStack()->setClean();
  }
}

TEST_F(WindowTest, FileWithoutAMeshGivesAnErrorOfOneLineAndChangesNothing) {
  openPart(writePart("plinth.stl", smallBox()));
  document().undoStack()->setClean();
  QFile bad(path("bad.stl"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("this is no mesh");
  bad.close();
  const auto before = document().source();
  window().open(path("bad.stl"));
  ASSERT_TRUE(
      waitFor([&] { return window().findChild<QMessageBox*>("messageBox") != nullptr; }, 10000));
  auto* box = find<QMessageBox>("messageBox");
  EXPECT_TRUE(box->informativeText().isEmpty());
  EXPECT_FALSE(box->text().contains('\n'));
  EXPECT_TRUE(box->text().contains("bad.stl")) << box->text().toStdString();
  box->close();
  EXPECT_EQ(document().source(), before);
  EXPECT_TRUE(waitFor([&] { return !find<QAction>("cancel")->isEnabled(); }, 2000));
  EXPECT_EQ(find<window::FlowBar>("flowBar")->state(Page::Prepare), PageState::Done);
}

TEST_F(WindowTest, TheLanguageChangesWhileItRuns) {
  auto* plan = find<QAction>("plan");
  const QString english = plan->text();
  auto* italian = find<QAction>("language_it");
  italian->trigger();
  QCoreApplication::processEvents();
  EXPECT_NE(plan->text(), english);
  EXPECT_EQ(window().pages().find(Page::Prepare)->title(), QString("Prepara"));
  find<QAction>("language_en")->trigger();
  QCoreApplication::processEvents();
  EXPECT_EQ(plan->text(), english);
}

// 1280 x 800 at 150 %.
TEST_F(WindowTest, FitsASmallScreenInEveryLanguage) {
  for (const char* language : {"language_it", "language_en"}) {
    find<QAction>(language)->trigger();
    for (const char* page : {Page::Prepare, Page::Layers, Page::Simulate, Page::Export}) {
      window().pages().show(*window().pages().find(page));
      QCoreApplication::processEvents();
      const QSize minimum = window().minimumSizeHint();
      EXPECT_LE(minimum.width(), 853) << language << " page " << page;
      EXPECT_LE(minimum.height(), 533) << language << " page " << page;
    }
  }
}

// 1280 x 800 at 150 %, in a language: of everything, or of the text alone.
class NarrowPanelTest : public WindowTest,
                        public testing::WithParamInterface<std::tuple<std::string, bool>> {
protected:
  static bool isOfTextAlone() { return std::get<bool>(GetParam()); }
  static QString language() { return QString::fromStdString(std::get<std::string>(GetParam())); }
  void SetUp() override {
    usual_ = QApplication::font();
    QFont font = usual_;
    if (isOfTextAlone())
      font.setPointSizeF(1.5 * usual_.pointSizeF());
    QApplication::setFont(font);
    WindowTest::SetUp();
    window().resize(isOfTextAlone() ? QSize(1280, 800) : QSize(853, 533));
    find<QAction>(("language_" + language().toStdString()).c_str())->trigger();
  }
  void TearDown() override {
    find<QAction>("language_en")->trigger();
    WindowTest::TearDown();
    QApplication::setFont(usual_);
  }
  void expectNothingCutOff(const char* page) {
    window().pages().show(*window().pages().find(page));
    QTest::qWait(100);
    for (const QScrollArea* area : window().findChildren<QScrollArea*>())
      if (area->isVisible() && area->widget() && !area->widget()->visibleRegion().isEmpty()) {
        EXPECT_LE(area->widget()->width(), area->viewport()->width()) << page;
      }
    keepPicture(window(), ("narrow-" + language().toStdString() + "-" + page).c_str());
  }

private:
  QFont usual_;
};

TEST_P(NarrowPanelTest, ScrollsNothingSideways) {
  openPart(writePart("plinth.stl", smallBox()));
  window().planning().plan(Stage::Replay);
  ASSERT_TRUE(planned(Stage::Replay));
  for (const char* page :
       {Page::Prepare, Page::Layers, Page::Simulate, Page::Export, Page::Compare})
    expectNothingCutOff(page);
  using window::LayerSubject;
  const auto expectRoomFor = [&](LayerSubject subject) {
    auto* options = find<window::ViewOptions>("viewOptions");
    window::ViewChoices choices = options->choices();
    choices.subject = subject;
    options->setChoices(choices);
    expectNothingCutOff(Page::Layers);
  };
  expectRoomFor(LayerSubject::Voxels);
  expectRoomFor(LayerSubject::Layers);
  project::Choices choices = document().choices();
  choices.item().mode = "planar";
  document().setChoices(choices, "mode");
  window().planning().plan(Stage::Decompose);
  ASSERT_TRUE(planned(Stage::Decompose));
  expectRoomFor(LayerSubject::Pieces);
}

INSTANTIATE_TEST_SUITE_P(Languages, NarrowPanelTest,
                         testing::Combine(testing::Values("it", "nb", "nl", "zh"), testing::Bool()),
                         [](const testing::TestParamInfo<std::tuple<std::string, bool>>& test) {
                           return std::get<std::string>(test.param) +
                                  (std::get<bool>(test.param) ? "LargeText" : "LargeEverything");
                         });

TEST_F(WindowTest, AScriptedSessionOfAllPagesUnderTheWatchdog) {
  const QString file = writePart("plinth.stl", smallBox(24.0));
  application().resetWatch();
  openPart(file);
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  auto* layers = find<timeline::LayerRangeSlider>("layerSlider");
  for (int i = 0; i < layers->layerCount(); ++i) {
    QTest::keyClick(layers, Qt::Key_Down);
    QTest::qWait(5);
  }
  layers->setRange(0, layers->layerCount() - 1);
  choosePage(Page::Simulate);
  auto* timeline = find<timeline::TimelineBar>("timeline");
  timeline->setSpeed(100);
  timeline->play();
  QTest::qWait(1500);
  timeline->pause();
  choosePage(Page::Export);
  QTest::qWait(300);
  choosePage(Page::Prepare);
  document().setParameter("walls", "1");
  ASSERT_TRUE(planned(Stage::Load));
  recordLongestStretch();
}

} // namespace
} // namespace voluta::test
