#include "timeline/timeline_bar.h"

#include "forms/colours.h"
#include "timeline/sample_program.h"
#include "timeline/scrub_slider.h"

#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

namespace voluta::timeline {
namespace {

class TimelineBarTest : public testing::Test {
protected:
  TimelineBarTest() {
    const test::SampleProgram p = test::sampleProgram(3, 4);
    clock_ = std::make_shared<Clock>(p.trajectory, p.toolPlan);
    bar_.resize(800, 40);
    bar_.setClock(clock_);
    bar_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&bar_));
  }
  ScrubSlider* slider() { return bar_.findChild<ScrubSlider*>(); }
  QString label() { return bar_.findChild<QLabel*>()->text(); }

  std::shared_ptr<const Clock> clock_;
  TimelineBar bar_;
};

TEST_F(TimelineBarTest, ShowsMinutesAndSeconds) {
  EXPECT_EQ(label(), "00:00 / 14 s");
  bar_.setTimeS(7.5);
  EXPECT_EQ(label(), "00:07 / 14 s");
}

TEST_F(TimelineBarTest, LongProgramsShowHours) {
  const test::SampleProgram p = test::sampleProgram(1, 4, 2000.0);
  bar_.setClock(std::make_shared<Clock>(p.trajectory, p.toolPlan));
  bar_.setTimeS(3725.0);
  EXPECT_EQ(label(), "1:02:05 / 2 h 13 min");
}

TEST_F(TimelineBarTest, SignalsOnlyChanges) {
  QSignalSpy time(&bar_, &TimelineBar::timeChanged);
  bar_.setTimeS(3.0);
  bar_.setTimeS(3.0);
  bar_.setTimeS(99.0);
  ASSERT_EQ(time.size(), 2);
  EXPECT_EQ(time[1][0].toDouble(), 14.0);
}

TEST_F(TimelineBarTest, KeysStepByMovesAndLayers) {
  bar_.setFocus();
  QTest::keyClick(&bar_, Qt::Key_Right);
  QTest::keyClick(&bar_, Qt::Key_Right);
  EXPECT_DOUBLE_EQ(bar_.timeS(), 2.0);
  QTest::keyClick(&bar_, Qt::Key_Left);
  EXPECT_DOUBLE_EQ(bar_.timeS(), 1.0);
  QTest::keyClick(&bar_, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(bar_.timeS(), 6.0);
  QTest::keyClick(&bar_, Qt::Key_Left, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(bar_.timeS(), 1.0);
  QTest::keyClick(&bar_, Qt::Key_End);
  EXPECT_DOUBLE_EQ(bar_.timeS(), 14.0);
  QTest::keyClick(&bar_, Qt::Key_Home);
  EXPECT_DOUBLE_EQ(bar_.timeS(), 0.0);
}

TEST_F(TimelineBarTest, SpacePlaysAndPauses) {
  QSignalSpy playing(&bar_, &TimelineBar::playingChanged);
  bar_.setSpeed(10.0);
  EXPECT_EQ(bar_.speed(), 10.0);
  QTest::keyClick(&bar_, Qt::Key_Space);
  EXPECT_TRUE(bar_.playing());
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar_.timeS() > 0.5; }, 3000));
  QTest::keyClick(&bar_, Qt::Key_Space);
  EXPECT_FALSE(bar_.playing());
  EXPECT_EQ(playing.size(), 2);
}

TEST_F(TimelineBarTest, ADragOnTheGrooveScrubs) {
  QSignalSpy time(&bar_, &TimelineBar::timeChanged), drag(&bar_, &TimelineBar::dragging);
  const QPoint middle = slider()->rect().center();
  QTest::mousePress(slider(), Qt::LeftButton, {}, middle);
  EXPECT_NEAR(bar_.timeS(), 7.0, 0.1);
  QTest::mouseMove(slider(), middle + QPoint(100, 0));
  EXPECT_GT(bar_.timeS(), 7.5);
  QTest::mouseRelease(slider(), Qt::LeftButton, {}, middle + QPoint(100, 0));
  EXPECT_GE(time.size(), 2);
  EXPECT_EQ(drag.size(), 2);
}

TEST_F(TimelineBarTest, AClickNearAMarkMeansTheMark) {
  bar_.setMarks({{7.0, true, "collision"}});
  QTest::mouseClick(slider(), Qt::LeftButton, {}, slider()->rect().center() + QPoint(3, 0));
  EXPECT_NEAR(bar_.timeS(), 7.0, 1e-9);
}

TEST_F(TimelineBarTest, EventsAreMarkedAndAClickNearOneJumpsThere) {
  const QImage without = slider()->grab().toImage();
  bar_.setEvents({{7.0, "Pause"}});
  EXPECT_NE(slider()->grab().toImage(), without);
  QTest::mouseClick(slider(), Qt::LeftButton, {}, slider()->rect().center() + QPoint(4, 0));
  EXPECT_NEAR(bar_.timeS(), 7.0, 1e-9);
  // The right button asks for a menu at its place, and only while the bar shows times.
  QSignalSpy asked(&bar_, &TimelineBar::menuAsked);
  const QPoint place = slider()->rect().center() + QPoint(60, 0);
  QContextMenuEvent menu(QContextMenuEvent::Mouse, place, slider()->mapToGlobal(place));
  QApplication::sendEvent(slider(), &menu);
  ASSERT_EQ(asked.size(), 1);
  EXPECT_GT(asked[0][0].toDouble(), 7.0);
  bar_.setMode(BarMode::Moves);
  QApplication::sendEvent(slider(), &menu);
  EXPECT_EQ(asked.size(), 1);
}

TEST_F(TimelineBarTest, AStretchOfTimeIsSetOffInModeTimeOnly) {
  const auto setOff = [&](double timeS) {
    const QImage picture = slider()->grab().toImage();
    const double share = timeS / bar_.clock()->durationS();
    const QColor warning = forms::warningColour(slider()->palette());
    const int x = 8 + static_cast<int>(share * (slider()->width() - 16));
    for (int y = slider()->height() / 2 + 3; y < slider()->height(); ++y)
      if (picture.pixelColor(x, y) == warning)
        return true;
    return false;
  };
  bar_.setSpans({{2.0, 4.0, "slower"}});
  bar_.setTimeS(9.0);
  EXPECT_TRUE(setOff(3.0));
  EXPECT_FALSE(setOff(5.0));
  bar_.setMode(BarMode::Moves);
  EXPECT_FALSE(setOff(3.0));
  bar_.setMode(BarMode::Time);
  EXPECT_TRUE(setOff(3.0));
  bar_.setSpans({});
  EXPECT_FALSE(setOff(3.0));
}

TEST_F(TimelineBarTest, StepsOfGrowthHaveTheirOwnPositionAndJumpByTen) {
  bar_.setMoveCount(40);
  bar_.setStepCount(25);
  bar_.setMode(BarMode::Steps);
  EXPECT_EQ(bar_.step(), 25) << "all is grown at first";
  QSignalSpy step(&bar_, &TimelineBar::stepChanged), move(&bar_, &TimelineBar::moveChanged);
  QSignalSpy layer(&bar_, &TimelineBar::layerStepRequested);
  bar_.previousMove();
  EXPECT_EQ(bar_.step(), 24);
  bar_.previousLayer();
  EXPECT_EQ(bar_.step(), 14);
  bar_.nextLayer();
  bar_.nextLayer();
  EXPECT_EQ(bar_.step(), 25) << "held at the end";
  EXPECT_EQ(step.size(), 4);
  bar_.setStep(3);
  bar_.setStepCount(25);
  EXPECT_EQ(bar_.step(), 3) << "as many steps: the place is kept";
  bar_.setStepCount(30);
  EXPECT_EQ(bar_.step(), 30);
  bar_.setMode(BarMode::Moves);
  EXPECT_EQ(bar_.move(), 40);
  EXPECT_EQ(move.size(), 0);
  EXPECT_EQ(layer.size(), 0);
}

TEST_F(TimelineBarTest, MovesOfALayerHaveTheirOwnPosition) {
  bar_.setTimeS(5.0);
  bar_.setMoveCount(40);
  bar_.setMode(BarMode::Moves);
  EXPECT_EQ(bar_.move(), 40) << "a layer is shown whole at first";
  QSignalSpy move(&bar_, &TimelineBar::moveChanged), time(&bar_, &TimelineBar::timeChanged);
  QSignalSpy layer(&bar_, &TimelineBar::layerStepRequested);
  bar_.previousMove();
  EXPECT_EQ(bar_.move(), 39);
  bar_.nextLayer();
  ASSERT_EQ(layer.size(), 1);
  EXPECT_EQ(layer[0][0].toInt(), 1);
  bar_.setMove(7);
  bar_.setMoveCount(12);
  EXPECT_EQ(bar_.move(), 12);
  EXPECT_EQ(move.size(), 3);
  EXPECT_EQ(time.size(), 0);
  bar_.setMode(BarMode::Time);
  EXPECT_DOUBLE_EQ(bar_.timeS(), 5.0);
  EXPECT_EQ(label(), "00:05 / 14 s");
}

TEST_F(TimelineBarTest, WithoutAProgramNothingCanBePlayed) {
  bar_.setClock(nullptr);
  EXPECT_FALSE(slider()->isEnabled());
  bar_.play();
  EXPECT_FALSE(bar_.playing());
  bar_.nextMove();
  EXPECT_EQ(bar_.timeS(), 0.0);
}

} // namespace
} // namespace voluta::timeline
