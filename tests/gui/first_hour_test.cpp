// The first hour of a new user: nothing is lost, the window does not claim checks that were not
// made, and every word is where users look for it.
#include "forms/parameter_row.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "helpers/sharp_prism.h"
#include "panels/findings_panel.h"
#include "panels/format_list.h"
#include "panels/verdict_table.h"
#include "pipeline/checked_program.h"
#include "plan/finding_kinds.h"
#include "timeline/layer_range_slider.h"
#include "window/flow_bar.h"
#include "window/picture_badge.h"
#include "window/status_line.h"

#include <QAction>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QTreeWidget>
#include <QUndoStack>

namespace voluta::test {
namespace {

using document::StageState;
using project::Stage;
using window::PageState;

class FirstHourTest : public WindowTest {
protected:
  QString plinth() { return writePart("plinth.stl", box({0, 0, 0}, {9.0, 9.0, 5.0})); }
  QString small() { return writePart("small.stl", box({0, 0, 0}, {5.0, 5.0, 5.0})); }
  void planAll() {
    clickToolBar("plan");
    ASSERT_TRUE(planned(Stage::Replay));
  }
  QString saveAs(const QString& name) {
    answerFileDialog(path(name));
    clickMenu("fileMenu", "saveAs");
    EXPECT_TRUE(waitFor([&] { return !document().dirty(); }, 20000));
    return path(name);
  }
  static QByteArray bytesOf(const QString& name) {
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  }
  static int boxesUp() {
    int count = 0;
    for (const QWidget* widget : QApplication::topLevelWidgets())
      count += widget->isVisible() && qobject_cast<const QMessageBox*>(widget) != nullptr;
    return count;
  }
  PageState state(const char* page) { return find<window::FlowBar>("flowBar")->state(page); }
  QString badge() {
    auto* shown = find<window::PictureBadge>("pictureBadge");
    return shown->isVisible() ? shown->text() : QString();
  }
  forms::ParameterRow* row(const char* key) {
    return find<QWidget>("parameters")->findChild<forms::ParameterRow*>(key);
  }
  void type(QWidget* field, const QString& text) {
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
  }
  QPushButton* exportButton() { return find<QWidget>("export")->findChild<QPushButton*>("export"); }
  // On the Export page, into a folder of the test.
  void exportInto(const QString& folder) {
    choosePage(Page::Export);
    auto* line = find<QWidget>("export")->findChild<QLineEdit*>("folder");
    type(line, folder);
    QTest::keyClick(line, Qt::Key_Tab);
    ASSERT_TRUE(exportButton()->isEnabled());
    QTest::mouseClick(exportButton(), Qt::LeftButton);
  }
};

TEST_F(FirstHourTest, AMeshOpenedInASavedProjectLeavesTheProjectAsItIs) {
  openPart(plinth());
  const QString project = saveAs("first.voluta");
  const QByteArray kept = bytesOf(project);
  document().setParameter("walls", "1");
  const QString other = writePart("other.stl", box({0, 0, 0}, {12.0, 8.0, 4.0}));
  answerBox("unsavedBox", QMessageBox::RejectRole);
  window().open(other);
  EXPECT_EQ(document().name(), "first");
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  window().open(other);
  ASSERT_TRUE(waitFor([&] { return document().name() == "other"; }));
  EXPECT_TRUE(document().projectFile().isEmpty());
  EXPECT_TRUE(document().dirty());
  ASSERT_TRUE(planned(Stage::Load));
  window().activateWindow(); // there may be no window manager to do it after a dialog
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window()));
  // A save opens the file dialog, with the part's name.
  answerFileDialog(path("second.voluta"));
  clickToolBar("save");
  ASSERT_TRUE(waitFor([&] { return !document().dirty(); }, 20000));
  EXPECT_EQ(bytesOf(project), kept);
  EXPECT_TRUE(QFile::exists(path("second.voluta")));
}

TEST_F(FirstHourTest, QuitAndDiscardQuits) {
  openPart(plinth());
  ASSERT_TRUE(document().dirty());
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  clickMenu("fileMenu", "quit");
  EXPECT_TRUE(waitFor([&] { return !window().isVisible(); }, 5000));
}

TEST_F(FirstHourTest, ChangeRemovesTheCheckedState) {
  openPart(small());
  planAll();
  choosePage(Page::Export);
  auto* verdict = find<QWidget>("export")->findChild<panels::VerdictTable*>();
  EXPECT_EQ(verdict->item(0, 3)->toolTip().contains("Not checked"), false);
  document().setParameter("walls", "3");
  QCoreApplication::processEvents();
  EXPECT_EQ(verdict->item(0, 3)->toolTip(), "Not checked since the change");
  EXPECT_EQ(badge(), "Out of date");
  for (const char* page : {Page::Layers, Page::Simulate, Page::Export})
    EXPECT_EQ(state(page), PageState::OutOfDate) << page;
  document().undoStack()->undo();
  QCoreApplication::processEvents();
  EXPECT_NE(verdict->item(0, 3)->toolTip(), "Not checked since the change");
  EXPECT_EQ(badge(), QString());
}

TEST_F(FirstHourTest, SliderAndPictureAreOfOneState) {
  openPart(plinth());
  planAll();
  auto* slider = find<timeline::LayerRangeSlider>("layerSlider");
  EXPECT_EQ(slider->layerCount(), window().presenter().pathLayers());
  EXPECT_FALSE(slider->topText(0).isEmpty());
  const int before = slider->layerCount();
  document().setParameter("layerHeightMm", "0.5");
  ASSERT_TRUE(waitFor([&] {
    return document().upToDate(Stage::Decompose) && !window().livePreview().running() &&
           !window().presenter().busy();
  }));
  ASSERT_TRUE(window().viewport().view().voxels);
  EXPECT_EQ(badge(), "Preview");
  EXPECT_EQ(slider->layerCount(), window().presenter().voxelLayers());
  EXPECT_TRUE(slider->topText(0).isEmpty()) << "heights of layers that are not on show";
  // The paths from before, with their layers.
  for (auto* button : find<QWidget>("viewOptions")->findChildren<QAbstractButton*>())
    if (button->text() == "Paths")
      button->click();
  EXPECT_TRUE(window().viewport().view().paths);
  EXPECT_EQ(badge(), "Out of date");
  EXPECT_EQ(slider->layerCount(), before);
}

TEST_F(FirstHourTest, CancelLeavesThePictureAsItWas) {
  openPart(plinth());
  planAll();
  const QImage before = picture();
  const auto paths = document().result(Stage::Toolpath);
  find<QAction>("livePreview")->trigger(); // off
  document().setParameter("voxelMm", "0.6");
  ASSERT_TRUE(planned(Stage::Load));
  QObject::connect(&window().planning(), &document::Planning::stageDone, &window(),
                   [&](Stage stage) {
                     if (stage == Stage::Layers)
                       clickToolBar("cancel");
                   });
  clickToolBar("plan");
  ASSERT_TRUE(waitFor([&] { return !window().planning().running(); }));
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  EXPECT_EQ(document().result(Stage::Toolpath), paths);
  EXPECT_TRUE(window().viewport().view().paths);
  EXPECT_EQ(badge(), "Out of date");
  EXPECT_TRUE(find<QLabel>("statusStage")->text().contains("still shown"));
  find<QWidget>("pictureBadge")->hide();
  EXPECT_LT(differingShare(before, picture()), 0.002);
}

TEST_F(FirstHourTest, InvalidProcessValueIsExplainedUnderItsField) {
  openPart(plinth());
  choosePage(Page::Prepare);
  auto* height = row("layerHeightMm");
  ASSERT_NE(height, nullptr);
  type(height->editor(), "5");
  QTest::keyClick(height->editor(), Qt::Key_Tab);
  QTest::qWait(200);
  EXPECT_EQ(boxesUp(), 0);
  EXPECT_TRUE(height->hasProblem());
  EXPECT_FALSE(find<QAction>("plan")->isEnabled());
  auto* status = find<QLabel>("statusStage");
  EXPECT_TRUE(status->text().contains("marked setting")) << status->text().toStdString();
  EXPECT_FALSE(find<QLabel>("notice")->isVisible()) << "told once";
  EXPECT_EQ(document().failure(), nullptr);
  int reported = 0;
  for (const QLabel* label : window().findChildren<QLabel*>())
    if (label->isVisible()) {
      EXPECT_FALSE(label->text().contains("layerHeightMm")) << label->text().toStdString();
      reported += label->text().contains("5 mm");
    }
  EXPECT_EQ(reported, 1);
  type(height->editor(), "0.8");
  QTest::keyClick(height->editor(), Qt::Key_Tab);
  EXPECT_FALSE(height->hasProblem());
  EXPECT_TRUE(find<QAction>("plan")->isEnabled());
  EXPECT_TRUE(waitFor([&] { return status->text() == "Ready. Press Plan."; }, 20000))
      << status->text().toStdString();
}

TEST_F(FirstHourTest, AFileIsChosenWhereAParameterTakesOne) {
  openPart(plinth());
  choosePage(Page::Prepare);
  project::Choices choices = document().choices();
  choices.item().mode = "planar";
  document().setChoices(choices, "mode");
  find<QWidget>("parameters")->findChild<QAbstractButton*>("all")->click();
  QFile cuts(path("cuts.json"));
  ASSERT_TRUE(cuts.open(QIODevice::WriteOnly));
  constexpr const char* kPlane = R"([{"point": [0, 0, 5], "normal": [0, 0, 1]}])";
  cuts.write(kPlane);
  cuts.close();
  auto* browse = row("cutPlanes")->findChild<QAbstractButton*>("browse");
  ASSERT_TRUE(browse->isVisibleTo(&window()));
  answerFileDialog(path("cuts.json"));
  browse->click();
  EXPECT_EQ(document().choices().item().parameters.at("cutPlanes"), kPlane) << "the content";
  EXPECT_FALSE(row("voxelMm")->findChild<QAbstractButton*>("browse")->isVisibleTo(&window()));
}

TEST_F(FirstHourTest, GroupsOfOtherModesAreNotInTheForm) {
  openPart(plinth());
  choosePage(Page::Prepare);
  EXPECT_FALSE(find<QWidget>("growth")->isVisible());
  QTest::mouseClick(find<QWidget>("research")->findChild<QAbstractButton*>(), Qt::LeftButton);
  EXPECT_TRUE(find<QWidget>("growth")->isVisible());
  EXPECT_FALSE(row("rodAxis")->isVisible());
  EXPECT_FALSE(row("planarScheme")->isVisible());
  project::Choices choices = document().choices();
  choices.item().mode = "planar";
  document().setChoices(choices, "mode");
  EXPECT_FALSE(find<QWidget>("growth")->isVisible());
  EXPECT_TRUE(row("planarScheme")->isVisible());
  EXPECT_FALSE(row("layerShape")->isVisible());
}

TEST_F(FirstHourTest, ANumberThatIsBeingTypedCountsWhenPlanIsPressed) {
  openPart(plinth());
  choosePage(Page::Prepare);
  type(row("voxelMm")->editor(), "1.1");
  QTest::keyClick(&window(), Qt::Key_L, Qt::ControlModifier);
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_EQ(document().choices().item().parameters.at("voxelMm"), "1.1");
}

TEST_F(FirstHourTest, ReopenedProjectIsNotReadyForExport) {
  openPart(plinth());
  planAll();
  const bool blocked = state(Page::Export) == PageState::Blocked;
  const QString project = saveAs("plinth.voluta");
  find<QAction>("new")->trigger();
  window().open(project);
  ASSERT_TRUE(waitFor([&] {
    return document().name() == "plinth" && window().presenter().hasPaths() &&
           !window().presenter().busy();
  }));
  EXPECT_EQ(state(Page::Export), blocked ? PageState::Blocked : PageState::Nothing);
  EXPECT_EQ(state(Page::Layers), PageState::Done);
  choosePage(Page::Export);
  EXPECT_FALSE(exportButton()->isEnabled());
}

TEST_F(FirstHourTest, AReopenedProjectKeepsItsFormatsTicked) {
  openPart(plinth());
  planAll();
  choosePage(Page::Export);
  auto* formats = find<QWidget>("export")->findChild<panels::FormatList*>("formats");
  const QStringList usual = formats->checkedIds();
  ASSERT_FALSE(usual.isEmpty());
  const QString project = saveAs("plinth.voluta");
  const auto reopen = [&] {
    find<QAction>("new")->trigger();
    window().open(project);
    ASSERT_TRUE(waitFor([&] {
      return document().name() == "plinth" && window().presenter().hasPaths() &&
             !window().presenter().busy();
    }));
    choosePage(Page::Export);
  };
  reopen();
  EXPECT_EQ(formats->checkedIds(), usual);
  project::Choices choices = document().choices();
  choices.formats = {"csv"};
  document().setChoices(choices, "formats");
  clickToolBar("save");
  ASSERT_TRUE(waitFor([&] { return !document().dirty(); }, 20000));
  reopen();
  EXPECT_EQ(formats->checkedIds(), QStringList("csv"));
}

TEST_F(FirstHourTest, WithoutAnyFormatNothingIsExported) {
  openPart(plinth());
  planAll();
  choosePage(Page::Export);
  auto* formats = find<QWidget>("export")->findChild<panels::FormatList*>("formats");
  for (int i = 0; i < formats->topLevelItemCount(); ++i)
    formats->topLevelItem(i)->setCheckState(0, Qt::Unchecked);
  EXPECT_TRUE(formats->checkedIds().isEmpty());
  EXPECT_FALSE(exportButton()->isEnabled());
  EXPECT_FALSE(document().choices().formats.empty()) << "empty stands for the usual ones";
}

TEST_F(FirstHourTest, ExportConfirmsReplacementAndWritesAReport) {
  openPart(writePart("prism.stl", sharpPrism()));
  document().setParameter("quality", "strict");
  planAll();
  QDir().mkpath(path("out"));
  answerBox("", QMessageBox::DestructiveRole); // although the part differs
  exportInto(path("out"));
  ASSERT_TRUE(waitFor([&] { return !QDir(path("out")).isEmpty(); }));
  ASSERT_TRUE(waitFor([&] { return exportButton()->isEnabled(); })) << "one at a time";
  const QDir out(path("out"));
  const QStringList names = out.entryList(QDir::Files);
  EXPECT_TRUE(names.contains("report.json"));
  EXPECT_GT(names.size(), 1);
  QFile mark(out.filePath("report.json"));
  ASSERT_TRUE(mark.open(QIODevice::WriteOnly));
  mark.write("mine");
  mark.close();
  QString asked;
  const auto again = [&](QMessageBox::ButtonRole replace) {
    answerBox("replaceBox", replace);
    auto* reading = new QTimer(&window());
    QObject::connect(reading, &QTimer::timeout, reading, [reading, &asked] {
      for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* box = qobject_cast<QMessageBox*>(widget);
            box && box->isVisible() && box->objectName() == "replaceBox") {
          asked = box->informativeText();
          reading->deleteLater();
          reading->stop();
          return;
        }
    });
    reading->start(5);
    auto* differing = new QTimer(&window());
    QObject::connect(differing, &QTimer::timeout, differing, [differing] {
      for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* button = widget->findChild<QPushButton*>("exportBlocked");
            button && button->isVisible()) {
          differing->deleteLater();
          differing->stop();
          QTest::mouseClick(button, Qt::LeftButton);
          return;
        }
    });
    differing->start(30);
    QTest::mouseClick(exportButton(), Qt::LeftButton);
    QTest::qWait(300);
  };
  again(QMessageBox::RejectRole);
  EXPECT_EQ(bytesOf(out.filePath("report.json")), "mine");
  again(QMessageBox::DestructiveRole);
  EXPECT_TRUE(waitFor([&] { return bytesOf(out.filePath("report.json")) != "mine"; }));
  // Programs that would run on a robot come first.
  const auto programs = document().result(Stage::Replay)->checked;
  const QString first = asked.section('\n', 0, 0);
  EXPECT_TRUE(first.contains(QString::fromStdString(programs.at(0)->program.files.at(0).name)))
      << asked.toStdString();
}

TEST_F(FirstHourTest, MarkOfAFindingDisappearsOnAPageChangeOrAnEdit) {
  openPart(small());
  planAll();
  auto* panel = find<panels::FindingsPanel>("findings");
  auto* list = panel->findChild<QListView*>("list");
  plan::Finding placed = plan::verbatimFinding(Stage::Toolpath, "gouge", "on the part", "");
  placed.where = window().presenter().partBox().center();
  const auto mark = [&] {
    panel->setFindings({placed});
    const QModelIndex index = list->model()->index(0, 0);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(index).center());
    return window().viewport().view().marker.has_value();
  };
  ASSERT_TRUE(mark());
  choosePage(Page::Layers);
  choosePage(Page::Simulate);
  EXPECT_FALSE(window().viewport().view().marker);
  ASSERT_TRUE(mark());
  document().setParameter("walls", "3");
  EXPECT_FALSE(window().viewport().view().marker);
}

// 1280 x 800 at 150 %.
TEST_F(FirstHourTest, ASmallScreenHasPlanAndCancelInSightAndFindingsToRead) {
  openPart(small());
  planAll();
  for (const char* language : {"language_it", "language_en"}) {
    find<QAction>(language)->trigger();
    window().resize(853, 500);
    QTest::qWait(100);
    auto* bar = find<QToolBar>("toolBar");
    for (const char* action : {"plan", "cancel"}) {
      const QWidget* button = bar->widgetForAction(find<QAction>(action));
      EXPECT_TRUE(waitFor([&] { return button->isVisible(); }, 2000)) << language << " " << action;
      EXPECT_LE(button->mapTo(&window(), button->rect().bottomRight()).x(), window().width());
    }
  }
}

// The picture beside a label keeps its size, whatever the label's text.
TEST_F(FirstHourTest, PictureKeepsItsSizeDuringAPlan) {
  openPart(plinth());
  choosePage(Page::Layers);
  QTest::qWait(100);
  const QSize before = window().viewport().size(), whole = window().size();
  std::vector<QSize> sizes;
  QObject::connect(&window().planning(), &document::Planning::progressed, &window(),
                   [&] { sizes.push_back(window().viewport().size()); });
  planAll();
  QTest::qWait(200);
  sizes.push_back(window().viewport().size());
  for (const QSize& size : sizes)
    EXPECT_EQ(size, before);
  find<window::StatusLine>("statusLine")->showIdle(QString("a word and another ").repeated(60));
  QTest::qWait(100);
  EXPECT_EQ(window().size(), whole);
  EXPECT_EQ(window().viewport().size(), before);
}

TEST_F(FirstHourTest, SizeOfThePartIsShownAtMostTwice) {
  openPart(plinth());
  choosePage(Page::Prepare);
  int reported = 0;
  for (const QLabel* label : window().findChildren<QLabel*>())
    reported += label->text().contains(QString::fromUtf8("9.0 × 9.0 × 5.0"));
  EXPECT_LE(reported, 2); // where it is scaled, and in the status line
  auto* tree = find<QTreeWidget>("tree");
  for (int column = 0; column < tree->columnCount(); ++column)
    EXPECT_FALSE(tree->topLevelItem(0)->text(column).contains("9.0"));
}

} // namespace
} // namespace voluta::test
