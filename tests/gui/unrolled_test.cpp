// A layer around an axis unrolled: lengths as on the layer, the seam in both pictures, the same
// path chosen by the mouse.
#include "base/units.h"
#include "window/unrolled/unrolled_canvas.h"
#include "window/unrolled/unrolled_layer.h"
#include "window/unrolled/unrolled_picture.h"
#include "window/unrolled/unrolled_view.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <gtest/gtest.h>

namespace voluta::test {
namespace {

using window::UnrolledLayer;

using base::kPi;
constexpr double kRadius = 3.625, kHeight = 0.25, kLength = 50.0, kPitch = 0.65;
constexpr int kAround = 90, kTurns = 70, kStepsPerRevolution = 120;

Eigen::Vector3d onCylinder(double radius, double angle, double x) {
  return {x, radius * std::cos(angle), radius * std::sin(angle)};
}

// Layer 1 of 2: a cylinder closed around the x axis, its chart (radius * angle, x).
layers::LayerStack tubeLayer() {
  layers::Patch patch;
  patch.layer = 1;
  patch.chart.periodMm = 2 * kPi * kRadius;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2 * kPi * i / kAround - kPi, x = kLength * (j - 0.5);
      patch.surface.vertices.push_back(onCylinder(kRadius, angle, x));
      patch.chart.at.emplace_back(kRadius * angle, x);
      patch.thicknessMm.push_back(kHeight);
      patch.direction.push_back(onCylinder(1.0, angle, 0.0));
    }
  for (int i = 0; i < kAround; ++i) {
    const int a = i, b = (i + 1) % kAround, c = b + kAround, d = a + kAround;
    patch.surface.triangles.push_back({a, d, c});
    patch.surface.triangles.push_back({a, c, b});
  }
  layers::LayerStack stack;
  stack.layerCount = 2;
  stack.patches.push_back(std::move(patch));
  return stack;
}

// One helix over the tube, many times over the seam, on the layer's outer side; before it a path of
// another layer.
plan::ToolPlan helix() {
  plan::ToolPlan plan;
  const auto add = [&](double angle, double x) {
    plan.position.push_back(onCylinder(kRadius + 0.5 * kHeight, angle, x));
    plan.direction.push_back(onCylinder(1.0, angle, 0.0));
    plan.widthMm.push_back(0.7f);
    plan.heightMm.push_back(static_cast<float>(kHeight));
    plan.speedMmPerS.push_back(20.0f);
  };
  add(0.0, 0.0);
  add(0.1, 0.0);
  plan.paths.push_back({0, 2, plan::PathKind::Wall, 0, 0, 0, false});
  for (int i = 0; i <= kTurns * kStepsPerRevolution; ++i) {
    const double turns = static_cast<double>(i) / kStepsPerRevolution;
    add(2 * kPi * turns + 0.3, kPitch * (turns - 0.5 * kTurns));
  }
  plan.paths.push_back({2, plan.position.size() - 2, plan::PathKind::Infill, 1, 0, 0, false});
  return plan;
}

std::shared_ptr<const UnrolledLayer> unrolled() {
  const plan::ToolPlan plan = helix();
  return window::unrolledLayer(tubeLayer(), &plan, 1, {});
}

TEST(UnrolledLayer, KeepsLengthsAndContinuesAcrossTheSeam) {
  const auto layer = unrolled();
  const double period = 2 * kPi * kRadius;
  EXPECT_NEAR(layer->periodMm, period, 1e-9);
  ASSERT_EQ(layer->stretches.size(), static_cast<std::size_t>(kTurns) + 1);
  double length = 0.0;
  std::size_t expected = 0;
  for (const UnrolledLayer::Stretch& s : layer->stretches) {
    EXPECT_EQ(s.first, expected);
    EXPECT_EQ(s.path, 1u);
    EXPECT_EQ(s.kind, plan::PathKind::Infill);
    expected = s.first + s.count;
    for (std::size_t i = s.first; i < s.first + s.count; ++i) {
      EXPECT_LE(std::abs(layer->points[i].x()), 0.5 * period + 1e-9);
      if (i > s.first) {
        const QPointF step = layer->points[i] - layer->points[i - 1];
        EXPECT_LT(std::hypot(step.x(), step.y()), 1.2 * period / kStepsPerRevolution) << i;
        length += std::hypot(step.x(), step.y());
      }
    }
    if (&s != layer->stretches.data()) {
      const QPointF before = layer->points[s.first - 1], after = layer->points[s.first];
      EXPECT_NEAR(before.x(), 0.5 * period, 1e-9);
      EXPECT_NEAR(after.x(), -0.5 * period, 1e-9);
      EXPECT_NEAR(before.y(), after.y(), 1e-9);
    }
  }
  // The chart is blended on the chords of 90 sides.
  EXPECT_NEAR(length, kTurns * std::hypot(period, kPitch), 1e-3 * kTurns * period);
  double outline = 0.0;
  for (const QLineF& line : layer->outline)
    outline += line.length();
  EXPECT_NEAR(outline, 2 * period, 1e-6);
}

TEST(UnrolledLayer, FindsThePathUnderAPlaceAlsoAcrossTheSeam) {
  const auto layer = unrolled();
  const std::size_t waypoint = 2 + 10 * kStepsPerRevolution + 7;
  const auto at = window::placeOf(*layer, waypoint);
  ASSERT_TRUE(at);
  for (const double turns : {0.0, 1.0, -1.0}) {
    const auto hit = window::nearestPath(*layer, *at + QPointF(turns * layer->periodMm, 0.02), 0.2);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->path, 1u);
    EXPECT_NEAR(static_cast<double>(hit->waypoint), static_cast<double>(waypoint), 1.0);
    EXPECT_NEAR(hit->distanceMm, 0.02, 2e-3);
  }
  EXPECT_FALSE(window::nearestPath(*layer, {0.0, 2 * kLength}, 1.0));
  EXPECT_FALSE(window::placeOf(*layer, 0));
}

TEST(UnrolledLayer, OnlyLayersWithAChartHaveOne) {
  layers::LayerStack stack = tubeLayer();
  EXPECT_TRUE(window::hasChart(stack));
  EXPECT_TRUE(window::hasChart(stack, 1));
  EXPECT_FALSE(window::hasChart(stack, 0));
  stack.patches[0].chart = {};
  EXPECT_FALSE(window::hasChart(stack));
  EXPECT_TRUE(window::unrolledLayer(stack, nullptr, 1, {})->area.isEmpty());
}

window::UnrolledLook plainLook() {
  window::UnrolledLook look;
  look.sheet = look.beside = Qt::white;
  look.outline = look.seam = Qt::black;
  look.chosen = Qt::magenta;
  look.kinds.fill(Qt::blue);
  return look;
}

TEST(UnrolledPicture, AreaLeftOfTheSeamIsRepeatedOnTheRight) {
  const auto layer = unrolled();
  window::UnrolledFrame frame;
  frame.pixelsPerMm = 400.0 / layer->periodMm; // a period is 400 pixels
  frame.size = {480, 300};
  const QImage image = window::unrolledPicture({layer, 1'000'000, {}}, frame, plainLook(), {});
  ASSERT_EQ(image.size(), QSize(480, 300));
  int seen = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 2; x < 36; ++x) {
      const QColor left = image.pixelColor(x, y), right = image.pixelColor(x + 400, y);
      EXPECT_NEAR(left.red(), right.red(), 24) << x << ' ' << y;
      seen += left.red() < 128;
    }
  EXPECT_GT(seen, 1000);
}

TEST(UnrolledPicture, UnprintedMovesAreFaint) {
  const auto layer = unrolled();
  window::UnrolledFrame frame;
  frame.pixelsPerMm = 8.0;
  frame.size = {200, 440};
  const auto blue = [&](std::size_t unprintedFrom) {
    const QImage image =
        window::unrolledPicture({layer, unprintedFrom, {}}, frame, plainLook(), {});
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        count += image.pixelColor(x, y).red() < 60 && image.pixelColor(x, y).blue() > 180;
    return count;
  };
  const int all = blue(1'000'000), half = blue(2 + kTurns * kStepsPerRevolution / 2),
            none = blue(0);
  EXPECT_GT(all, 20'000);
  EXPECT_NEAR(half, 0.5 * all, 0.06 * all);
  EXPECT_EQ(none, 0);
}

class UnrolledViewTest : public testing::Test {
protected:
  void SetUp() override {
    view_.resize(320, 560);
    view_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_));
    view_.setPlan(std::make_shared<layers::LayerStack>(tubeLayer()), plan_);
    view_.showLayer(1, 1'000'000, "Layer 2 of 2");
    ASSERT_TRUE(settles());
  }
  bool settles() {
    return QTest::qWaitFor([&] { return view_.settled() && canvas().content().layer; }, 20000);
  }
  window::UnrolledCanvas& canvas() { return view_.canvas(); }

  std::shared_ptr<const plan::ToolPlan> plan_ = std::make_shared<plan::ToolPlan>(helix());
  window::UnrolledView view_;
};

TEST_F(UnrolledViewTest, ClickSelectsTheWaypointUnderIt) {
  std::vector<std::optional<std::size_t>> chosen;
  QObject::connect(&view_, &window::UnrolledView::chosen,
                   [&](std::optional<std::size_t> waypoint) { chosen.push_back(waypoint); });
  const std::size_t waypoint = 2 + 30 * kStepsPerRevolution + 11;
  const QPointF at = canvas().pixelOf(*window::placeOf(*canvas().content().layer, waypoint));
  QTest::mouseMove(&canvas(), at.toPoint());
  QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at.toPoint());
  ASSERT_EQ(chosen.size(), 1u);
  ASSERT_TRUE(chosen[0]);
  EXPECT_NEAR(static_cast<double>(*chosen[0]), static_cast<double>(waypoint), 2.0);
  QTest::mouseClick(&canvas(), Qt::LeftButton, {}, QPoint(3, 3)); // on the axis' numbers
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_FALSE(chosen[1]);

  const QImage before = canvas().picture();
  view_.choose(waypoint);
  ASSERT_TRUE(settles());
  EXPECT_EQ(canvas().content().path, std::optional<std::size_t>(1));
  EXPECT_NE(before, canvas().picture());
}

TEST_F(UnrolledViewTest, LabelShowsThePlaceUnderThePointer) {
  const std::size_t waypoint = 2 + 5;
  const QPointF mm = *window::placeOf(*canvas().content().layer, waypoint);
  QTest::mouseMove(&canvas(), canvas().pixelOf(mm).toPoint());
  auto* place = view_.findChild<QLabel*>("unrolledPlace");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !place->text().isEmpty(); }, 2000));
  EXPECT_TRUE(place->text().contains("Infill 2")) << place->text().toStdString();
  EXPECT_TRUE(place->text().contains(QChar(0xb0))) << place->text().toStdString();
}

TEST_F(UnrolledViewTest, ZoomsAboutThePointerAndMovesByDragAndKeys) {
  const double whole = canvas().pixelsPerMm();
  const QPoint at = canvas().rect().center() + QPoint(40, -60);
  const QPointF held = canvas().mmAt(at);
  QWheelEvent wheel(at, canvas().mapToGlobal(at), {}, {0, 360}, Qt::NoButton, {}, Qt::NoScrollPhase,
                    false);
  QCoreApplication::sendEvent(&canvas(), &wheel);
  EXPECT_NEAR(canvas().pixelsPerMm(), whole * 1.2 * 1.2 * 1.2, 1e-6);
  EXPECT_NEAR(canvas().mmAt(at).x(), held.x(), 1e-6);
  EXPECT_NEAR(canvas().mmAt(at).y(), held.y(), 1e-6);
  QTest::mousePress(&canvas(), Qt::LeftButton, {}, at);
  QTest::mouseMove(&canvas(), at + QPoint(30, 20));
  QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at + QPoint(30, 20));
  EXPECT_NEAR(canvas().mmAt(at + QPoint(30, 20)).x(), held.x(), 1e-6);
  QTest::keyClick(&canvas(), Qt::Key_Right);
  EXPECT_GT(canvas().mmAt(at).x(), held.x() - 30 / whole);
  QTest::keyClick(&canvas(), Qt::Key_Home);
  EXPECT_NEAR(canvas().pixelsPerMm(), whole, 1e-9);
  ASSERT_TRUE(settles());
}

} // namespace
} // namespace voluta::test
