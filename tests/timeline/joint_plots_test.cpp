#include "timeline/joint_plots.h"

#include "timeline/chart_canvas.h"
#include "timeline/sample_program.h"

#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

namespace voluta::timeline {
namespace {

class JointPlotsTest : public testing::Test {
protected:
  void load(int layers, int perLayer, double stepS) {
    const test::SampleProgram p = test::sampleProgram(layers, perLayer, stepS);
    plots_.resize(900, 400);
    plots_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&plots_));
    QSignalSpy ready(&plots_, &JointPlots::ready);
    plots_.setTrajectory(p.trajectory, test::sampleLimits());
    ASSERT_TRUE(ready.wait(10000));
  }
  QList<ChartCanvas*> canvases() { return plots_.findChildren<ChartCanvas*>(); }
  // Pixels of the picture that differ between two looks.
  static int difference(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x)
        count += a.pixel(x, y) != b.pixel(x, y);
    return count;
  }

  JointPlots plots_;
};

TEST_F(JointPlotsTest, ClickSignalsTheTimeThere) {
  load(3, 50, 0.1);
  QSignalSpy clicked(&plots_, &JointPlots::timeClicked);
  ChartCanvas* canvas = canvases().front();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->rect().center());
  QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->rect().center() + QPoint(100, 0));
  ASSERT_EQ(clicked.size(), 2);
  const double a = clicked[0][0].toDouble(), b = clicked[1][0].toDouble();
  EXPECT_GT(a, 5.0);
  EXPECT_LT(a, 10.0);
  EXPECT_NEAR(b - a, 100.0 / canvas->width() * plots_.spanToS(), 0.3);
}

TEST_F(JointPlotsTest, TheWheelZoomsAndADoubleClickShowsAll) {
  load(3, 50, 0.1);
  ChartCanvas* canvas = canvases().front();
  const QPointF centre = canvas->rect().center();
  QWheelEvent event(centre, canvas->mapToGlobal(centre), {}, QPoint(0, 360), {}, {},
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(canvas, &event);
  EXPECT_NEAR(plots_.spanToS() - plots_.spanFromS(), 15.2 / std::pow(1.25, 3), 0.1);
  EXPECT_GT(plots_.spanFromS(), 0.0);
  plots_.setSpan(-100.0, 1e6);
  EXPECT_EQ(plots_.spanFromS(), 0.0);
  EXPECT_NEAR(plots_.spanToS(), 15.2, 1e-9);
  plots_.setSpan(3.0, 5.0);
  QTest::mouseDClick(canvas, Qt::LeftButton, {}, canvas->rect().center());
  EXPECT_EQ(plots_.spanFromS(), 0.0);
}

TEST_F(JointPlotsTest, TheCursorFollowsTheTime) {
  load(3, 50, 0.1);
  ChartCanvas* canvas = canvases().front();
  plots_.setTimeS(3.0);
  const QImage before = canvas->grab().toImage();
  plots_.setTimeS(9.0);
  const int moved = difference(before, canvas->grab().toImage());
  EXPECT_GT(moved, 100);
  EXPECT_LT(moved, 8 * canvas->height()) << "only the line moves";
}

TEST_F(JointPlotsTest, JointsAndQuantitiesCanBeTurnedOff) {
  load(3, 50, 0.1);
  ChartCanvas* canvas = canvases().front();
  const QImage all = canvas->grab().toImage();
  for (int j = 0; j < 6; ++j)
    plots_.setJointShown(j, false);
  EXPECT_FALSE(plots_.jointShown(3));
  EXPECT_GT(difference(all, canvas->grab().toImage()), 500);
  plots_.setKind(PlotKind::Speed);
  EXPECT_TRUE(canvases()[0]->isHidden());
  EXPECT_FALSE(canvases()[1]->isHidden());
}

TEST_F(JointPlotsTest, JerkIsShownBesideThatOfTheMotionBefore) {
  load(3, 50, 0.1);
  plots_.setKind(PlotKind::Jerk);
  ASSERT_EQ(canvases().size(), 3);
  EXPECT_TRUE(canvases()[0]->isHidden());
  EXPECT_FALSE(canvases()[2]->isHidden());
  const test::SampleProgram slower = test::sampleProgram(3, 50, 0.2);
  QSignalSpy ready(&plots_, &JointPlots::ready);
  plots_.setTrajectory(slower.trajectory, test::sampleLimits());
  ASSERT_TRUE(ready.wait(10000));
  const QImage alone = canvases()[2]->grab().toImage();
  plots_.setEarlierShown(true);
  EXPECT_GT(difference(alone, canvases()[2]->grab().toImage()), 500);
  // Without a trajectory nothing is left of the one before.
  plots_.setTrajectory(nullptr, {});
  plots_.setTrajectory(slower.trajectory, test::sampleLimits());
  ASSERT_TRUE(ready.wait(10000));
  EXPECT_LT(difference(alone, canvases()[2]->grab().toImage()), 100);
}

// A plan as long as a bunny's is prepared beside the window's thread.
TEST_F(JointPlotsTest, ManyPointsDoNotHoldTheWindowUp) {
  const test::SampleProgram p = test::sampleProgram(100, 3450, 0.02);
  plots_.resize(1280, 400);
  plots_.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&plots_));
  QSignalSpy ready(&plots_, &JointPlots::ready);
  plots_.setTrajectory(p.trajectory, test::sampleLimits());
  EXPECT_FALSE(plots_.prepared());
  ASSERT_TRUE(ready.wait(20000));
  EXPECT_TRUE(plots_.prepared());
  ChartCanvas* canvas = canvases().front();
  const QImage all = canvas->grab().toImage();
  plots_.setSpan(100.0, 600.0);
  EXPECT_GT(difference(all, canvas->grab().toImage()), 500);
}

TEST_F(JointPlotsTest, NoTrajectoryIsNoTrouble) {
  load(1, 10, 0.1);
  plots_.setTrajectory(nullptr, {});
  EXPECT_FALSE(plots_.prepared());
  plots_.setTimeS(3.0);
  plots_.setSpan(1.0, 2.0);
  plots_.grab();
}

} // namespace
} // namespace voluta::timeline
