#include "timeline/layer_range_slider.h"

#include <QApplication>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <gtest/gtest.h>

namespace voluta::timeline {
namespace {

class LayerRangeTest : public testing::Test {
protected:
  LayerRangeTest() {
    slider_.resize(slider_.sizeHint().width(), 400);
    slider_.setLayers(101);
    slider_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&slider_));
  }
  void expectRange(int first, int last) {
    EXPECT_EQ(slider_.first(), first);
    EXPECT_EQ(slider_.last(), last);
  }
  void wheel(int notches, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent event(slider_.rect().center(), slider_.mapToGlobal(slider_.rect().center()), {},
                      QPoint(0, 120 * notches), {}, keys, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&slider_, &event);
  }
  QPoint at(double share) { // of the height, from below
    return {slider_.width() - 12, static_cast<int>((1.0 - share) * slider_.height())};
  }

  LayerRangeSlider slider_;
};

TEST_F(LayerRangeTest, ShowsAllLayersAtFirst) {
  expectRange(0, 100);
  slider_.setLayers(20);
  expectRange(0, 19);
  slider_.setLayers(0);
  expectRange(0, 0);
  EXPECT_FALSE(slider_.isEnabled());
}

TEST_F(LayerRangeTest, MarksAreShortNumbers) {
  for (const double low : {2.75, 0.2, 13.37, 480.0})
    for (const double span : {0.75, 3.2, 29.0, 800.0}) {
      slider_.setLayers(4, {low, low + 0.3 * span, low + 0.6 * span, low + span}, true);
      const std::vector<double> marks = slider_.ruledMm();
      EXPECT_GE(marks.size(), 3U) << low << " " << span;
      for (const double mark : marks)
        EXPECT_LE(QLocale::c().toString(mark, 'g', QLocale::FloatingPointShortest).size(), 6)
            << mark;
    }
}

TEST_F(LayerRangeTest, ItsLabelsGrowWithoutMovingThePictureBesideIt) {
  const int width = slider_.sizeHint().width();
  slider_.setLayers(0);
  EXPECT_EQ(slider_.sizeHint().width(), width);
  slider_.setLayers(7, {0.8, 1.6, 2.4, 3.2, 4.0, 4.8, 5.6});
  EXPECT_EQ(slider_.sizeHint().width(), width);
  slider_.setLayers(1200, std::vector<double>(1200, 987.65), true);
  EXPECT_EQ(slider_.sizeHint().width(), width);
}

TEST_F(LayerRangeTest, KeysMoveTheHandles) {
  QTest::keyClick(&slider_, Qt::Key_Down);
  QTest::keyClick(&slider_, Qt::Key_PageDown);
  expectRange(0, 89);
  QTest::keyClick(&slider_, Qt::Key_Up, Qt::ShiftModifier);
  QTest::keyClick(&slider_, Qt::Key_PageUp, Qt::ShiftModifier);
  expectRange(11, 89);
  QTest::keyClick(&slider_, Qt::Key_Home);
  expectRange(0, 89);
  QTest::keyClick(&slider_, Qt::Key_End);
  expectRange(0, 100);
}

TEST_F(LayerRangeTest, ThePlusAsksForAPauseBeforeTheUpperLayer) {
  QSignalSpy wished(&slider_, &LayerRangeSlider::pauseWished);
  EXPECT_TRUE(slider_.pauseButton().isEmpty()) << "not of these layers";
  slider_.setPauses({}, true);
  EXPECT_TRUE(QRectF(slider_.rect()).contains(slider_.pauseButton()));
  slider_.setRange(0, 40);
  const auto click = [&] {
    QTest::mouseClick(&slider_, Qt::LeftButton, {}, slider_.pauseButton().center().toPoint());
  };
  click();
  ASSERT_EQ(wished.size(), 1);
  EXPECT_EQ(wished[0], (QVariantList{40, true}));
  expectRange(0, 40); // the handle stays
  EXPECT_TRUE(slider_.pauses().empty()) << "whether it comes is the document's";
  slider_.setPauses({12, 40}, true);
  EXPECT_TRUE(slider_.accessibleDescription().contains("pause"));
  const QImage with = slider_.grab().toImage();
  click();
  EXPECT_EQ(wished[1], (QVariantList{40, false}));
  QTest::keyClick(&slider_, Qt::Key_Minus);
  EXPECT_EQ(wished.size(), 3);
  QTest::keyClick(&slider_, Qt::Key_Plus);
  EXPECT_EQ(wished.size(), 3) << "it is there";
  slider_.setPauses({}, true);
  EXPECT_NE(slider_.grab().toImage(), with);
  slider_.setRange(0, 0);
  EXPECT_TRUE(slider_.pauseButton().isEmpty()) << "nothing is printed before";
  QTest::keyClick(&slider_, Qt::Key_Plus);
  EXPECT_EQ(wished.size(), 3);
}

TEST_F(LayerRangeTest, TheHandlesNeverPass) {
  slider_.setRange(50, 52);
  QTest::keyClick(&slider_, Qt::Key_PageDown);
  expectRange(50, 50);
  QTest::keyClick(&slider_, Qt::Key_PageUp, Qt::ShiftModifier);
  expectRange(50, 50);
  slider_.setRange(80, 20);
  expectRange(20, 20);
  slider_.setRange(-5, 900);
  expectRange(0, 100);
}

TEST_F(LayerRangeTest, TheWheelMovesOneHandleOrBoth) {
  slider_.setRange(40, 60);
  wheel(1);
  expectRange(40, 61);
  wheel(-2, Qt::ShiftModifier);
  expectRange(38, 61);
  wheel(60, Qt::ControlModifier);
  expectRange(77, 100);
}

TEST_F(LayerRangeTest, AClickBringsTheNearerHandle) {
  QSignalSpy drag(&slider_, &LayerRangeSlider::dragging);
  QTest::mouseClick(&slider_, Qt::LeftButton, {}, at(0.75));
  EXPECT_EQ(slider_.first(), 0);
  EXPECT_NEAR(slider_.last(), 78, 8);
  QTest::mouseClick(&slider_, Qt::LeftButton, {}, at(0.3));
  EXPECT_NEAR(slider_.first(), 27, 8);
  EXPECT_EQ(drag.size(), 4);
}

TEST_F(LayerRangeTest, DragSignalsEveryChangeOnce) {
  QSignalSpy range(&slider_, &LayerRangeSlider::rangeChanged);
  QTest::mousePress(&slider_, Qt::LeftButton, {}, at(0.7));
  const int before = slider_.last();
  QTest::mouseMove(&slider_, at(0.4));
  QTest::mouseRelease(&slider_, Qt::LeftButton, {}, at(0.4));
  EXPECT_LT(slider_.last(), before - 10);
  EXPECT_EQ(range.size(), 2);
}

TEST_F(LayerRangeTest, ADoubleClickShowsASingleLayer) {
  QTest::mouseDClick(&slider_, Qt::LeftButton, {}, at(0.5));
  EXPECT_TRUE(slider_.single());
  EXPECT_EQ(slider_.first(), slider_.last());
  EXPECT_NEAR(slider_.last(), 50, 6);
  const int layer = slider_.last();
  QTest::keyClick(&slider_, Qt::Key_Up);
  expectRange(layer + 1, layer + 1);
  QTest::mouseDClick(&slider_, Qt::LeftButton, {}, at(0.5));
  EXPECT_FALSE(slider_.single());
  EXPECT_EQ(slider_.first(), 0);
}

} // namespace
} // namespace voluta::timeline
