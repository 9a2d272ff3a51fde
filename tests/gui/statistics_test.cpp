// The preview's figures: the legend as statistics that hide kinds of beads, the ruler of layers,
// and the machine at the cursor.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/cursor_info.h"
#include "pipeline/checked_program.h"
#include "pipeline/plan_result.h"
#include "robot/cell.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/legend_view.h"
#include "window/presenters/presenter.h"

#include <QCheckBox>
#include <QTest>
#include <QUndoStack>
#include <algorithm>
#include <cmath>

namespace voluta::test {
namespace {

using project::Stage;

class StatisticsTest : public WindowTest {
protected:
  void planPlinth() {
    openPart(writePart("plinth.stl", box({0, 0, 0}, {24, 18, 6})));
    project::Choices choices = document().choices();
    choices.item().automatic = false;
    choices.item().mode = "flat";
    choices.parameters["walls"] = "2";
    document().setChoices(choices, "flat");
    clickToolBar("plan");
    ASSERT_TRUE(planned(Stage::Replay));
    choosePage(Page::Layers);
    ASSERT_TRUE(waitFor([&] { return window().presenter().statistics() != nullptr; }));
    ASSERT_TRUE(waitFor([&] { return window().presenter().statistics()->figures.whole.timed; }));
  }
  window::LegendView& legend() { return *find<window::LegendView>("legend"); }
  static constexpr int kWall = static_cast<int>(plan::PathKind::Wall);
};

TEST_F(StatisticsTest, TheLegendIsTheStatistics) {
  planPlinth();
  ASSERT_TRUE(waitFor([&] { return !legend().figures().rows.empty(); }, 5000));
  keepPicture(window(), "statistics");
  const window::KindStatistics& whole = window().presenter().statistics()->figures.whole;
  const window::KindFigures total = whole.total();
  const auto result = document().lastResult();
  ASSERT_NE(result, nullptr);
  EXPECT_NEAR(total.lengthMm, result->job.report.toolpath.lengthMm, 0.1);
  EXPECT_NEAR(total.massG, result->tooling().printedG(*result->job.toolPlan), 1e-6);
  EXPECT_NEAR(total.timeS, window().presenter().clock()->durationS(), 1e-6);
  EXPECT_GT(whole.kinds[kWall].timeS, 0.0);
  EXPECT_GT(whole.travelS, 0.0);
  EXPECT_EQ(legend().figures().heads.size(), 4);
  EXPECT_EQ(legend().figures().totals.back().first, "Total");
  EXPECT_EQ(legend().figures().totals.back().second.at(1), "100.0 %");
  // The layers add up to the whole.
  window::KindFigures sum;
  for (const window::KindStatistics& layer : window().presenter().statistics()->figures.layers) {
    sum.lengthMm += layer.total().lengthMm;
    sum.massG += layer.total().massG;
  }
  EXPECT_NEAR(sum.lengthMm, total.lengthMm, 1e-6);
  EXPECT_NEAR(sum.massG, total.massG, 1e-9);
  // A layer alone has its own.
  find<timeline::LayerRangeSlider>("layerSlider")->setRange(2, 2);
  EXPECT_EQ(legend().figures().totals.back().first, "Layer 3");
}

TEST_F(StatisticsTest, AClickHidesAKindAndAnotherShowsIt) {
  planPlinth();
  ASSERT_TRUE(waitFor([&] { return !legend().rowOf(kWall).isEmpty(); }, 5000));
  const QImage before = picture();
  const auto click = [&] {
    QTest::mouseClick(&legend(), Qt::LeftButton, {}, legend().rowOf(kWall).center());
  };
  click();
  EXPECT_EQ(window().viewport().view().hiddenKinds, 1U << kWall);
  EXPECT_EQ(legend().figures().hidden, 1U << kWall);
  keepPicture(window(), "statistics_hidden");
  EXPECT_GT(differingShare(before, picture()), 0.005);
  click();
  EXPECT_EQ(window().viewport().view().hiddenKinds, 0U);
  EXPECT_LT(differingShare(before, picture()), 0.005);
}

TEST_F(StatisticsTest, TheRulerMarksRoundHeights) {
  planPlinth();
  const auto* slider = find<timeline::LayerRangeSlider>("layerSlider");
  ASSERT_TRUE(waitFor([&] { return !slider->ruledMm().empty(); }, 5000));
  const std::vector<double> marks = slider->ruledMm();
  ASSERT_GE(marks.size(), 2U);
  const double step = marks[1] - marks[0];
  for (std::size_t i = 0; i < marks.size(); ++i) {
    EXPECT_NEAR(marks[i], marks[0] + static_cast<double>(i) * step, 1e-9);
    EXPECT_NEAR(std::remainder(marks[i], step), 0.0, 1e-9);
    EXPECT_LE(marks[i], 6.0 + 1e-6);
  }
}

TEST_F(StatisticsTest, APlusOnTheRulerPausesThePrint) {
  planPlinth();
  auto* slider = find<timeline::LayerRangeSlider>("layerSlider");
  slider->setRange(0, 3);
  QTest::mouseClick(slider, Qt::LeftButton, {}, slider->pauseButton().center().toPoint());
  EXPECT_EQ(slider->pauses(), std::vector{3});
  slider->setRange(0, 1);
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Plus);
  EXPECT_EQ(slider->pauses(), (std::vector{1, 3}));
  EXPECT_EQ(document().choices().item().parameters.at("pauseLayers"), "2, 4");
  keepPicture(window(), "pauses");
  document().undoStack()->undo();
  EXPECT_EQ(slider->pauses(), std::vector{3});
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  const auto result = document().lastResult();
  EXPECT_TRUE(result->job.report.replay.passed);
  const auto& events = result->job.trajectory->events;
  EXPECT_EQ(std::ranges::count(events, plan::EventKind::Pause, &plan::TrajectoryEvent::kind), 1);
  // A list that is half typed is none yet, and another project has none.
  document().setParameter("pauseLayers", "4, x");
  EXPECT_TRUE(slider->pauses().empty());
  document().undoStack()->undo();
  EXPECT_EQ(slider->pauses(), std::vector{3});
  document().clear();
  EXPECT_TRUE(slider->pauses().empty());
}

TEST_F(StatisticsTest, TheMachineIsDescribedAtTheCursor) {
  planPlinth();
  choosePage(Page::Simulate);
  auto* info = find<panels::CursorInfo>("cursorInfo");
  auto* bar = find<timeline::TimelineBar>("timeline");
  const auto clock = window().presenter().clock();
  const double middle = 0.5 * clock->durationS();
  bar->setTimeS(middle);
  ASSERT_TRUE(waitFor([&] { return info->shown(0).size() > 3; })) << "no line of the program";
  keepPicture(window(), "cursor");
  const auto motion = document().result(Stage::Motion);
  const Eigen::Vector3d tip = motion->cell->work_T_tool(clock->jointsAt(middle)).translation();
  EXPECT_TRUE(info->shown(1).contains(QString("Z %1").arg(QLocale().toString(tip.z(), 'f', 1))))
      << info->shown(1).toStdString();
  EXPECT_TRUE(info->shown(4).endsWith("mm/s"));
  EXPECT_EQ(info->shown(5).count(QChar(0xB0)), motion->cell->dof());
  const QString line = info->shown(0), joints = info->shown(5);
  bar->setTimeS(0.7 * clock->durationS());
  EXPECT_NE(info->shown(0), line);
  EXPECT_NE(info->shown(5), joints);
  EXPECT_EQ(info->shown(2).count(QChar(0xB0)), 3);
  EXPECT_TRUE(info->shown(6).endsWith(" g")) << info->shown(6).toStdString();
  QString text;
  for (const auto& file : document().result(Stage::Replay)->checked.front()->program.files)
    text += QString::fromStdString(file.text);
  EXPECT_TRUE(text.contains(info->shown(0))) << info->shown(0).toStdString();
}

TEST_F(StatisticsTest, TheCameraFollowsTheNozzle) {
  planPlinth();
  choosePage(Page::Simulate);
  auto* bar = find<timeline::TimelineBar>("timeline");
  const auto clock = window().presenter().clock();
  int moved = 0;
  QObject::connect(&window().viewport(), &viewer::Viewport::cameraMoved, &window(),
                   [&] { ++moved; });
  bar->setTimeS(0.3 * clock->durationS());
  EXPECT_EQ(moved, 0);
  auto* follow = find<QCheckBox>("followNozzle");
  QTest::mouseClick(follow, Qt::LeftButton, {}, QPoint(8, follow->height() / 2));
  EXPECT_EQ(moved, 1);
  bar->setTimeS(0.6 * clock->durationS());
  EXPECT_EQ(moved, 2);
  keepPicture(window(), "followed");
  QTest::mouseClick(follow, Qt::LeftButton, {}, QPoint(8, follow->height() / 2));
  bar->setTimeS(0.8 * clock->durationS());
  EXPECT_EQ(moved, 2);
}

} // namespace
} // namespace voluta::test
