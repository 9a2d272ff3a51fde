// Parts around a rod in the window: settings that follow the mode, the layers unrolled beside the
// picture, the same path chosen in both.
#include "base/units.h"
#include "forms/platform_editor.h"
#include "gui/window_fixture.h"
#include "helpers/lathe_parts.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/unrolled/unrolled_canvas.h"
#include "window/unrolled/unrolled_view.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QUndoStack>

namespace voluta::test {
namespace {

using project::Stage;

class LatheWindowTest : public WindowTest {
protected:
  // By keys, as far down the list as it takes.
  void choose(const char* field, const char* id) {
    choosePage(Page::Prepare);
    auto* combo = find<QComboBox>(field);
    combo->setFocus();
    QTest::keyClick(combo, Qt::Key_Home);
    for (int i = 0; i < combo->count() && combo->currentData().toString() != id; ++i)
      QTest::keyClick(combo, Qt::Key_Down);
    ASSERT_EQ(combo->currentData().toString(), id);
  }
  // Bore 4.8 mm, outside 7 mm, 16 mm long, upright as it came: four layers of 0.25 mm.
  QString tubeFile() const {
    geometry::TriangleMesh tube = revolved({{-8, kBore}, {-8, 3.5}, {8, 3.5}, {8, kBore}}, 128);
    for (Eigen::Vector3d& v : tube.vertices)
      v = Eigen::Vector3d(v.y(), v.z(), v.x());
    return writePart("tube.stl", tube);
  }
  bool unrolledSettles() {
    return waitFor(
        [&] {
          return !window().presenter().busy() && unrolled().settled() && canvas().content().layer;
        },
        30000);
  }
  window::UnrolledView& unrolled() { return *find<window::UnrolledView>("unrolled"); }
  window::UnrolledCanvas& canvas() { return unrolled().canvas(); }
  QString notice() { return find<QLabel>("notice")->text(); }
  void planTube() {
    openPart(tubeFile());
    choose("mode", "lathe");
    window().planning().plan(Stage::Toolpath);
    ASSERT_TRUE(planned(Stage::Toolpath));
    choosePage(Page::Layers);
  }
};

TEST_F(LatheWindowTest, CellPlatformAndProcessGoAlongAndComeBack) {
  openPart(tubeFile());
  document().setParameter("walls", "1");
  choose("mode", "curved");
  project::Choices own = document().choices();
  own.item().platform = project::Platform("disc:80");
  document().setChoices(own, "platform");
  const int edits = document().undoStack()->count();
  choose("mode", "lathe");
  const project::Choices& now = document().choices();
  EXPECT_EQ(now.cell, "lathe");
  EXPECT_EQ(now.tool().process, "fdm-0.35");
  EXPECT_EQ(now.item().platform.text(), "rod:5x200");
  EXPECT_EQ(now.item().parameters.at("walls"), "1");
  EXPECT_TRUE(notice().contains("turning rod")) << notice().toStdString();
  EXPECT_TRUE(find<QPushButton>("noticeButton")->isHidden());
  auto* platform = find<forms::PlatformEditor>("platform");
  EXPECT_EQ(platform->findChild<QComboBox*>("kind")->count(), 3);
  EXPECT_TRUE(platform->findChild<QComboBox*>("rodShape")->isVisible());

  choose("mode", "flat");
  EXPECT_EQ(document().choices().cell, own.cell);
  EXPECT_EQ(document().choices().tool().process, own.tool().process);
  EXPECT_EQ(document().choices().item().platform.text(), "disc:80");

  // One step of undo also restores the settings that followed the mode.
  while (document().undoStack()->count() > edits && document().choices().item().mode != "curved")
    document().undoStack()->undo();
  EXPECT_EQ(document().choices().item().platform.text(), "disc:80");
  EXPECT_EQ(document().choices().cell, own.cell);
}

TEST_F(LatheWindowTest, UnsuitableCellIsExplainedAndAButtonChangesIt) {
  openPart(tubeFile());
  choose("mode", "lathe");
  choose("cell", "ur5-fixed");
  auto* button = find<QPushButton>("noticeButton");
  ASSERT_TRUE(button->isVisible());
  EXPECT_FALSE(notice().isEmpty());
  EXPECT_TRUE(button->text().contains("turning rod")) << button->text().toStdString();
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(document().choices().cell, "lathe");
  EXPECT_FALSE(button->isVisible());

  project::Choices plate = document().choices();
  plate.item().platform = project::Platform("disc:60");
  document().setChoices(plate, "platform");
  ASSERT_TRUE(button->isVisible());
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(document().choices().item().platform.text(), "rod:5x200");

  // Printing on a surface requires one, and takes it from a dialog.
  choose("mode", "substrate");
  ASSERT_TRUE(button->isVisible());
  const QString body = writePart("half.stl", halfCylinder(40, 60));
  answerFileDialog(body);
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(document().choices().item().platform.text(), ("mesh:" + body).toStdString());
  EXPECT_FALSE(button->isVisible());
  ASSERT_TRUE(QFile::remove(body));
  document().setParameter("walls", "3");
  EXPECT_TRUE(button->isVisible());
  EXPECT_TRUE(notice().contains("half.stl")) << notice().toStdString();
}

TEST_F(LatheWindowTest, RodIsShownBeforeAPlanWithThePartOnIt) {
  openPart(tubeFile());
  const Eigen::Vector3d upright = window().presenter().partBox().sizes();
  EXPECT_NEAR(upright.z(), 16.0, 1e-4);
  choose("mode", "lathe");
  ASSERT_TRUE(planned(Stage::Load));
  ASSERT_TRUE(waitFor([&] { return window().presenter().partBox().sizes().x() > 15.0; }));
  EXPECT_NEAR(window().presenter().partBox().center().norm(), 0.0, 1e-3);
  EXPECT_LT(document().result(Stage::Load)->job.item().placement->liftMm, -3.0);
  // Looked at from the front, the middle of the picture is the part; on the rod beside it,
  // platform.
  const QImage shown = picture();
  EXPECT_FALSE(shown.isNull());
}

TEST_F(LatheWindowTest, LayersShowTheirRadiusAndAreUnrolledBesideThePicture) {
  planTube();
  EXPECT_TRUE(find<QDockWidget>("unrolledDock")->isVisible());
  auto* slider = find<timeline::LayerRangeSlider>("layerSlider");
  ASSERT_EQ(slider->layerCount(), 4);
  ASSERT_TRUE(waitFor([&] { return !slider->topText(3).isEmpty(); }));
  EXPECT_EQ(slider->topText(1), "r 3.00 mm");
  EXPECT_EQ(slider->topText(3), "r 3.50 mm");
  ASSERT_TRUE(unrolledSettles());
  EXPECT_EQ(canvas().content().layer->layer, 3);
  EXPECT_NEAR(canvas().content().layer->periodMm, 2 * base::kPi * 3.375, 0.02);
  EXPECT_GT(canvas().content().layer->stretches.size(), 0u);
  slider->setRange(0, 1);
  ASSERT_TRUE(waitFor([&] { return canvas().content().layer->layer == 1; }));
  ASSERT_TRUE(unrolledSettles());
  EXPECT_TRUE(find<QLabel>("unrolledTitle")->text().contains("r 3.00 mm"));

  // The part up to the move slider is printed.
  auto* bar = find<timeline::TimelineBar>("timeline");
  const int half = window().presenter().movesOf(1) / 2;
  bar->setMove(half);
  EXPECT_EQ(canvas().content().unprintedFrom,
            window().presenter().waypointsOf(1)[static_cast<std::size_t>(half)]);
  clickMenu("viewMenu", "toggleUnrolled");
  EXPECT_FALSE(find<QDockWidget>("unrolledDock")->isVisible());
  clickMenu("viewMenu", "toggleUnrolled");
  EXPECT_TRUE(find<QDockWidget>("unrolledDock")->isVisible());
  choosePage(Page::Prepare);
  EXPECT_FALSE(find<QDockWidget>("unrolledDock")->isVisible());
}

TEST_F(LatheWindowTest, APathThatIsChosenInOnePictureIsChosenInBoth) {
  planTube();
  ASSERT_TRUE(unrolledSettles());
  const auto& layer = *canvas().content().layer;
  const std::size_t point = layer.points.size() / 2;
  const std::size_t waypoint = layer.waypoint[point];
  application().resetWatch();
  const QPoint at = canvas().pixelOf(layer.points[point]).toPoint();
  QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at);
  const scene::ViewState& view = window().viewport().view();
  ASSERT_TRUE(view.path && view.marker);
  const auto plan = document().result(Stage::Toolpath)->job.toolPlan;
  EXPECT_LT((*view.marker - plan->position[waypoint]).norm(), 0.8);
  auto* bar = find<timeline::TimelineBar>("timeline");
  EXPECT_LT(bar->move(), window().presenter().movesOf(3));
  EXPECT_EQ(canvas().content().path, view.path);
  ASSERT_TRUE(unrolledSettles());

  // From the front the nozzle's side of the tube is in the middle.
  bar->setMove(window().presenter().movesOf(3));
  clickMenu("viewMenu", "viewFront");
  clickMenu("viewMenu", "frameAll");
  (void)picture();
  QTest::mouseClick(&window().viewport(), Qt::LeftButton, {},
                    window().viewport().rect().center() + QPoint(4, 6));
  ASSERT_TRUE(waitFor([&] { return window().viewport().view().path.has_value(); }, 3000));
  EXPECT_LT(window().viewport().view().marker->y(), -2.0);
  EXPECT_EQ(canvas().content().path, window().viewport().view().path);
  // Beside every path nothing is chosen.
  QTest::mouseClick(&window().viewport(), Qt::LeftButton, {}, QPoint(8, 200));
  EXPECT_FALSE(window().viewport().view().path);
  EXPECT_FALSE(canvas().content().path);
  recordLongestStretch();
}

TEST_F(LatheWindowTest, TouchedPointsMoveThePart) {
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  const auto answer = [&](const QString& text, bool accept) {
    QTimer::singleShot(300, &window(), [this, text, accept] {
      auto* dialog = window().findChild<QDialog*>("touchDialog");
      ASSERT_NE(dialog, nullptr);
      auto* apply = dialog->findChild<QPushButton*>("touchApply");
      auto* found = dialog->findChild<QLabel*>("touchFound");
      EXPECT_FALSE(apply->isEnabled());
      auto* points = dialog->findChild<QPlainTextEdit*>("touchPoints");
      points->setPlainText("0 0\n1 1\n2 2");
      EXPECT_FALSE(apply->isEnabled()) << "points on a line";
      EXPECT_FALSE(found->text().isEmpty());
      points->setPlainText("1 2\nfirst 3");
      EXPECT_TRUE(found->text().contains("2")) << found->text().toStdString();
      points->setPlainText(text);
      EXPECT_EQ(apply->isEnabled(), accept);
      EXPECT_TRUE(found->text().contains("20.000")) << found->text().toStdString();
      QTest::mouseClick(apply, Qt::LeftButton);
    });
  };
  // About (y 2, z 1.5), radius 20; x is not looked at.
  answer("10, 22, 1.5\n10, 2, 21.5\n-3, -18, 1.5\n", true);
  clickMenu("editMenu", "touchedPoints");
  EXPECT_NEAR(document().choices().item().placement.centreMm.y(), 2.0, 1e-6);
  EXPECT_NEAR(document().choices().item().placement.liftMm, 1.5, 1e-6);
}

} // namespace
} // namespace voluta::test
