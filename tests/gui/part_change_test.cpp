// One part after another: unsaved work is discarded only after a confirmation, undo brings all of
// it back, and nothing of the part before is left in settings, picture and sliders.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "pipeline/checked_program.h"
#include "timeline/joint_plots.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QRegularExpression>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

namespace voluta::test {
namespace {

using project::Stage;

class PartChangeTest : public WindowTest {
protected:
  QString plinth() { return writePart("plinth.stl", box({0, 0, 0}, {9.0, 9.0, 5.0})); }
  QString other() { return writePart("other.stl", box({0, 0, 0}, {12.0, 8.0, 4.0})); }
  void planAll() {
    clickToolBar("plan");
    ASSERT_TRUE(planned(Stage::Replay));
  }
  void drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    // Qt hands a drop on to the widget that has taken the drag, and to no other.
    QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window(), &event);
    EXPECT_TRUE(event.isAccepted());
  }
  bool shows(const QString& name) {
    return waitFor([&] {
      return document().name() == name && document().sourceReady() &&
             document().upToDate(Stage::Load) && !window().planning().running() &&
             !window().presenter().busy();
    });
  }
  timeline::LayerRangeSlider& layers() { return *find<timeline::LayerRangeSlider>("layerSlider"); }
  timeline::TimelineBar& bar() { return *find<timeline::TimelineBar>("timeline"); }
  void expectSlidersOfWhatIsShown() {
    const window::Presenter& presenter = window().presenter();
    EXPECT_EQ(layers().layerCount(), presenter.pathLayers());
    EXPECT_EQ(layers().last(), layers().layerCount() - 1);
    EXPECT_EQ(bar().clock(), presenter.clock());
    EXPECT_LE(bar().timeS(), bar().clock() ? bar().clock()->durationS() : 0.0);
    choosePage(Page::Layers);
    EXPECT_EQ(bar().move(), presenter.movesOf(layers().last()));
  }
};

TEST_F(PartChangeTest, MeshOntoAnUnsavedPlanConfirmsAndUndoRestoresThePlan) {
  openPart(plinth());
  planAll();
  const auto plan = document().result(Stage::Replay);
  const int pathLayers = window().presenter().pathLayers();
  answerBox("dropBox", QMessageBox::DestructiveRole);
  answerBox("unsavedBox", QMessageBox::RejectRole);
  drop(other());
  ASSERT_TRUE(waitFor([&] { return answeredBoxes() == 2; }, 5000));
  QTest::qWait(500); // an open that was not cancelled would show by now
  EXPECT_EQ(document().name(), "plinth") << "cancelled";
  EXPECT_EQ(document().result(Stage::Replay), plan);

  answerBox("dropBox", QMessageBox::DestructiveRole);
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  drop(other());
  ASSERT_TRUE(shows("other"));
  EXPECT_FALSE(window().presenter().hasPaths());
  EXPECT_EQ(window().presenter().clock(), nullptr);
  EXPECT_EQ(bar().clock(), nullptr);

  window().activateWindow(); // there may be no window manager to do it after a dialog
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window()));
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(shows("plinth"));
  EXPECT_TRUE(document().upToDate(Stage::Replay));
  EXPECT_FALSE(document().result(Stage::Replay)->checked.empty());
  EXPECT_EQ(window().presenter().pathLayers(), pathLayers);
  ASSERT_NE(window().presenter().clock(), nullptr);
  expectSlidersOfWhatIsShown();

  QTest::keyClick(&window(), Qt::Key_Y, Qt::ControlModifier);
  ASSERT_TRUE(shows("other"));
  EXPECT_FALSE(window().presenter().hasPaths());
}

TEST_F(PartChangeTest, PartThatWasOnlyOpenedIsReplacedWithoutAQuestion) {
  openPart(plinth());
  window().open(other()); // a box would wait for an answer for ever
  ASSERT_TRUE(shows("other"));
}

TEST_F(PartChangeTest, SettingsOfOnePartAreNotTheNextOnes) {
  openPart(plinth());
  const project::Choices usual = document().choices();
  document().setParameter("walls", "5");
  project::Choices own = document().choices();
  own.item().mode = "flat";
  own.seed = 7;
  own.tool().process = "fdm-0.35";
  own.formats = {"urscript"};
  own.item().scale = "1.5";
  document().setChoices(own, "own");
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  window().open(other());
  ASSERT_TRUE(shows("other"));
  const project::Choices& next = document().choices();
  EXPECT_TRUE(next.item().parameters.empty());
  EXPECT_EQ(next.item().mode, usual.item().mode);
  EXPECT_EQ(next.seed, usual.seed);
  EXPECT_EQ(next.item().scale, usual.item().scale);
  EXPECT_EQ(next.tool().process, "fdm-0.35") << "the workshop's, not the part's";
  EXPECT_EQ(next.formats, own.formats);
  document().undoStack()->undo();
  EXPECT_EQ(document().choices().item().parameters.at("walls"), "5");
  EXPECT_EQ(document().choices().item().mode, "flat");
  // The same file read again is the same part.
  ASSERT_TRUE(shows("plinth"));
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  window().open(plinth());
  ASSERT_TRUE(waitFor([&] { return document().choices().item().scale == "1"; }));
  EXPECT_EQ(document().choices().item().parameters.at("walls"), "5");
}

TEST_F(PartChangeTest, ANewProjectLeavesNothingOfThePartBefore) {
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); })); // the cell is drawn
  choosePage(Page::Simulate);
  const QImage empty = picture();
  keepPicture(window(), "just_opened");
  choosePage(Page::Prepare);
  openPart(plinth());
  planAll();
  choosePage(Page::Simulate);
  EXPECT_GT(differingShare(empty, picture()), 0.05);
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  clickMenu("fileMenu", "new");
  ASSERT_TRUE(waitFor([&] { return !document().source(); }, 5000));
  EXPECT_EQ(bar().clock(), nullptr);
  EXPECT_EQ(layers().layerCount(), 0);
  QTest::qWait(500); // a picture still being drawn would appear by now
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  choosePage(Page::Simulate);
  EXPECT_LT(differingShare(empty, picture()), 0.01);
  for (const QToolButton* button :
       find<timeline::JointPlots>("plots")->findChildren<QToolButton*>())
    EXPECT_FALSE(button->isVisible() &&
                 QRegularExpression("^J\\d+$").match(button->text()).hasMatch())
        << button->text().toStdString() << ", a joint of the arm before";
  EXPECT_EQ(find<QLabel>("statusStage")->text(), QString());
  keepPicture(window(), "new_project");
}

TEST_F(PartChangeTest, AnotherArmIsInThePictureAtOnceAndWithoutTheMotionOfTheFirst) {
  openPart(plinth());
  planAll();
  choosePage(Page::Simulate);
  const QImage before = picture();
  project::Choices choices = document().choices();
  choices.cell = "ur10-moving";
  document().setChoices(choices, "cell");
  EXPECT_EQ(window().presenter().clock(), nullptr);
  EXPECT_EQ(bar().clock(), nullptr);
  ASSERT_TRUE(waitFor([&] {
    return window().presenter().hasCell() && !window().presenter().busy() &&
           !window().planning().running();
  }));
  EXPECT_TRUE(window().viewport().view().cell);
  EXPECT_EQ(window().viewport().view().joints.size(), 0) << "at home";
  EXPECT_FALSE(find<QWidget>("pictureBadge")->isVisible()) << "nothing in it is out of date";
  EXPECT_GT(differingShare(before, picture()), 0.02);
  keepPicture(window(), "another_arm");
  document().undoStack()->undo();
  ASSERT_TRUE(waitFor([&] { return window().presenter().clock() != nullptr; }));
  EXPECT_EQ(bar().clock(), window().presenter().clock());
  EXPECT_TRUE(document().upToDate(Stage::Motion));
}

TEST_F(PartChangeTest, SlidersAreOfTheNewPlan) {
  openPart(plinth());
  planAll();
  expectSlidersOfWhatIsShown();
  const int layersBefore = layers().layerCount();
  const double durationBefore = bar().clock()->durationS();
  choosePage(Page::Simulate);
  bar().setTimeS(durationBefore);
  choosePage(Page::Layers);
  layers().setRange(0, 1);
  EXPECT_EQ(bar().move(), window().presenter().movesOf(1)) << "another layer";
  document().setParameter("layerHeightMm", "0.5");
  planAll();
  EXPECT_GT(layers().layerCount(), layersBefore);
  expectSlidersOfWhatIsShown();
  choosePage(Page::Simulate);
  EXPECT_NE(bar().clock()->durationS(), durationBefore);
  EXPECT_LE(bar().timeS(), bar().clock()->durationS());
}

} // namespace
} // namespace voluta::test
