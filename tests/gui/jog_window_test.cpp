// The arm of the simulation is moved by hand, and the nozzle's tip leaves a trace.
#include "base/units.h"
#include "collision/growing_part.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/cursor_info.h"
#include "panels/jog_panel.h"
#include "pipeline/plan_result.h"
#include "robot/cell.h"
#include "timeline/timeline_bar.h"
#include "window/pages/jogged_arm.h"
#include "window/pages/tip_trace.h"
#include "window/presenters/presenter.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>

namespace voluta::test {
namespace {

using project::Stage;

class JogTest : public WindowTest {
protected:
  void planPlinth() {
    openPart(writePart("plinth.stl", box({0, 0, 0}, {24, 18, 6})));
    chooseFlat();
    clickToolBar("plan");
    ASSERT_TRUE(planned(Stage::Replay));
    choosePage(Page::Simulate);
    bar()->setTimeS(0.5 * clock()->durationS());
  }
  timeline::TimelineBar* bar() { return find<timeline::TimelineBar>("timeline"); }
  std::shared_ptr<const timeline::Clock> clock() { return window().presenter().clock(); }
  QCheckBox* box_(const char* name) { return find<QCheckBox>(name); }
  void click(const char* checkBox) {
    QCheckBox* box = box_(checkBox);
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
  }
  QDoubleSpinBox* field(const char* name) { return find<QDoubleSpinBox>(name); }
  void type(const char* name, const QString& text) {
    QDoubleSpinBox* box = field(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
  }
  void press(const char* name) { QTest::mouseClick(find<QToolButton>(name), Qt::LeftButton); }
  QString message() { return find<QLabel>("jogMessage")->text(); }
  // Of the check of the present pose, which runs in the background.
  bool says(const char* beginning) {
    return waitFor([&] { return message().startsWith(beginning); }, 10000);
  }
  const robot::JointVector& shownJoints() { return window().viewport().view().joints; }
  // Of the shown joints, on the platform.
  Eigen::Vector3d tip() {
    return document().result(Stage::Motion)->cell->work_T_tool(shownJoints()).translation();
  }
};

TEST_F(JogTest, TheArmFollowsTheJointsAndTheNozzleAndGoesBackToThePlan) {
  planPlinth();
  const robot::JointVector planned = clock()->jointsAt(bar()->timeS());
  const auto plan = document().lastResult();
  click("jogArm");
  ASSERT_TRUE(find<panels::JogPanel>("jogPanel")->isVisible());
  EXPECT_FALSE(find<QWidget>("plotsArea")->isVisible());
  EXPECT_TRUE(shownJoints().isApprox(planned)) << "where the plan is";
  EXPECT_NEAR(field("jogJoint1")->value(), base::radiansToDegrees(planned[0]), 0.006);
  ASSERT_TRUE(waitFor([&] { return message().startsWith("Free") && !message().contains('\n'); }))
      << "the part is checked";
  keepPicture(window(), "jog");

  const Eigen::Vector3d before = tip();
  press("jogMoreZ");
  press("jogMoreZ");
  EXPECT_NEAR(tip().z(), before.z() + 20.0, 1e-6);
  EXPECT_NEAR(tip().x(), before.x(), 1e-6);
  EXPECT_NEAR(field("jogZ")->value(), tip().z(), 0.006);
  EXPECT_TRUE(says("Free")) << message().toStdString();
  type("jogX", "15");
  EXPECT_NEAR(tip().x(), 15.0, 1e-6);
  press("jogMoreA");
  EXPECT_NEAR(field("jogA")->value(), 5.0, 0.006);
  EXPECT_NEAR(tip().x(), 15.0, 1e-6) << "about the tip";
  auto* info = find<panels::CursorInfo>("cursorInfo");
  EXPECT_TRUE(info->shown(2).startsWith("A 5.0°")) << info->shown(2).toStdString();
  keepPicture(window(), "jog-lifted");

  const double joint = shownJoints()[5];
  QSlider* slider = find<QSlider>("jogSlider6");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_NEAR(shownJoints()[5], joint + base::degreesToRadians(1.0), base::degreesToRadians(0.06));
  EXPECT_EQ(document().lastResult(), plan) << "the plan stays as it is";
  EXPECT_TRUE(document().upToDate(Stage::Replay));

  QTest::mouseClick(find<QPushButton>("jogEnd"), Qt::LeftButton);
  EXPECT_FALSE(box_("jogArm")->isChecked());
  EXPECT_FALSE(find<panels::JogPanel>("jogPanel")->isVisible());
  EXPECT_TRUE(shownJoints().isApprox(planned));
}

TEST_F(JogTest, CollisionsAndPosesOutOfReachAreSaid) {
  planPlinth();
  click("jogArm");
  ASSERT_TRUE(waitFor([&] { return message().startsWith("Free") && !message().contains('\n'); }));
  const Eigen::Vector3d before = tip();
  type("jogZ", "-30"); // through the plate
  EXPECT_TRUE(says("Collision")) << message().toStdString();
  keepPicture(window(), "jog-collision");
  type("jogZ", QLocale().toString(before.z() + 20.0));
  EXPECT_TRUE(says("Free")) << message().toStdString();
  const robot::JointVector there = shownJoints();
  type("jogX", "9000");
  EXPECT_TRUE(message().contains("does not reach")) << message().toStdString();
  EXPECT_TRUE(shownJoints().isApprox(there)) << "it stays";
  EXPECT_NEAR(field("jogX")->value(), tip().x(), 0.006) << "the field too";
  // A joint is kept within its limits.
  const auto& limits = document().result(Stage::Motion)->cell->limits();
  type("jogJoint1", "99999");
  EXPECT_NEAR(shownJoints()[0], limits[0].max, 1e-3);
}

TEST_F(JogTest, EndsWithTheMomentThePlanOrThePage) {
  planPlinth();
  click("jogArm");
  ASSERT_TRUE(box_("jogArm")->isChecked());
  bar()->setTimeS(0.25 * clock()->durationS());
  EXPECT_FALSE(box_("jogArm")->isChecked());
  EXPECT_TRUE(shownJoints().isApprox(clock()->jointsAt(bar()->timeS())));
  click("jogArm");
  choosePage(Page::Layers);
  choosePage(Page::Simulate);
  EXPECT_FALSE(box_("jogArm")->isChecked());
  // A plan while jogging, with a number half typed.
  click("jogArm");
  field("jogX")->setFocus();
  field("jogX")->selectAll();
  QTest::keyClicks(field("jogX"), "12");
  document().setParameter("liftMm", "4");
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  choosePage(Page::Simulate);
  EXPECT_FALSE(box_("jogArm")->isChecked());
  EXPECT_TRUE(shownJoints().isApprox(clock()->jointsAt(bar()->timeS())));
  // Nothing to jog.
  document().undoStack()->undo();
  document().clear();
  click("jogArm");
  EXPECT_FALSE(box_("jogArm")->isChecked());
}

TEST_F(JogTest, TheTipLeavesATrace) {
  planPlinth();
  QComboBox* traces = find<QComboBox>("tipTrace");
  window().viewport().framePart();
  const QImage without = picture();
  for (const char* what : {"Last 10 s", "Last 60 s", "Whole print"}) {
    SCOPED_TRACE(what);
    traces->setCurrentIndex(traces->findText(what));
    EXPECT_TRUE(waitFor([&] { return differingShare(without, picture()) > 2e-4; }, 10000));
    keepPicture(window(), (std::string("trace-") + what).c_str());
  }
  const QImage whole = picture();
  choosePage(Page::Layers);
  const QImage layers = picture();
  choosePage(Page::Simulate); // with the whole cell
  window().viewport().framePart();
  EXPECT_LT(differingShare(whole, picture()), 2e-3) << "it is there again";
  traces->setCurrentIndex(0);
  EXPECT_LT(differingShare(without, picture()), 2e-3);
  choosePage(Page::Layers);
  EXPECT_LT(differingShare(layers, picture()), 1e-4) << "it is of Simulate alone";
}

TEST_F(JogTest, TheTraceHasTheColoursOfTheLook) {
  planPlinth();
  QComboBox* traces = find<QComboBox>("tipTrace");
  window().viewport().framePart();
  const QImage without = picture();
  traces->setCurrentIndex(traces->count() - 1);
  ASSERT_TRUE(waitFor([&] { return differingShare(without, picture()) > 2e-4; }, 10000));
  const QImage light = picture();
  for (const char* look : {"highContrast", "light"}) {
    find<QAction>(look)->trigger();
    QTest::qWait(100);
    const QImage changed = picture();
    keepPicture(window(), (std::string("trace-") + look).c_str());
    traces->setCurrentIndex(0);
    EXPECT_GT(differingShare(changed, picture()), 2e-4);
    traces->setCurrentIndex(traces->count() - 1); // drawn in the look
    EXPECT_LT(differingShare(changed, picture()), 1e-4) << look;
  }
  EXPECT_LT(differingShare(light, picture()), 1e-4);
}

TEST_F(JogTest, TheTraceIsWhereTheNozzleWas) {
  planPlinth();
  const auto motion = document().result(Stage::Motion);
  const window::TipTrace trace = window::tipTrace(*clock(), *motion->cell, {});
  ASSERT_GE(trace.timeS.size(), clock()->pointCount());
  EXPECT_TRUE(std::ranges::is_sorted(trace.timeS));
  for (std::size_t i = 0; i < trace.timeS.size(); i += 37) {
    const Eigen::Vector3d tip =
        motion->cell->work_T_tool(clock()->jointsAt(trace.timeS[i])).translation();
    EXPECT_NEAR((trace.tipMm[i].cast<double>() - tip).norm(), 0.0, 0.5) << i;
  }
  const scene::Theme theme = scene::lightTheme();
  const double middle = 0.5 * clock()->durationS();
  const auto lengthOf = [](const scene::LineGroup& group) {
    double length = 0.0;
    for (const auto& line : group.lines)
      for (std::size_t i = 1; i < line.size(); ++i)
        length += (line[i] - line[i - 1]).norm();
    return length;
  };
  const auto whole = window::traceLines(trace, 0.0, clock()->durationS(), theme),
             half = window::traceLines(trace, middle, clock()->durationS(), theme);
  EXPECT_NEAR(lengthOf(whole[0]), motion->job.report.toolpath.lengthMm,
              0.02 * motion->job.report.toolpath.lengthMm);
  EXPECT_LT(lengthOf(half[0]), lengthOf(whole[0]));
  EXPECT_GT(whole[1].lines.size(), 10u) << "dashes";
}

// A print of two million points: all of it is in the trace, on the beads.
TEST(TipTrace, OfALongPrintShowsItsBeginningToo) {
  window::TipTrace trace;
  constexpr int kPoints = 2'000'000, kEachTurn = 1000;
  const auto tipAt = [](int i) {
    const double angle = base::kTwoPi * i / kEachTurn;
    return Eigen::Vector3d(50.0 * std::cos(angle), 50.0 * std::sin(angle), 0.0002 * i);
  };
  for (int i = 0; i < kPoints; ++i) {
    trace.timeS.push_back(0.01 * i);
    trace.tipMm.push_back(tipAt(i).cast<float>());
    trace.prints.push_back(i % (100 * kEachTurn) != 0);
  }
  const auto lines = window::traceLines(trace, 0.0, trace.timeS.back(), scene::lightTheme());
  std::size_t points = 0;
  double length = 0.0, lowest = 1e9, farthest = 0.0;
  for (const auto& line : lines[0].lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      ++points;
      lowest = std::min(lowest, line[i].z());
      farthest = std::max(farthest, std::abs(line[i].head<2>().norm() - 50.0));
      if (i > 0) {
        length += (line[i] - line[i - 1]).norm();
        farthest =
            std::max(farthest, std::abs((0.5 * (line[i] + line[i - 1])).head<2>().norm() - 50.0));
      }
    }
  EXPECT_LE(points, window::kMaxTracePoints);
  EXPECT_LT(lowest, 1.0);
  EXPECT_LT(farthest, 0.3);
  const double whole = base::kTwoPi * 50.0 * kPoints / kEachTurn;
  EXPECT_NEAR(length, whole, 0.01 * whole);
  // A short stretch keeps every point.
  const auto last =
      window::traceLines(trace, trace.timeS.back() - 10.0, trace.timeS.back(), scene::lightTheme());
  EXPECT_GE(last[0].lines.back().size(), 1000u);
}

TEST_F(JogTest, SimulateHasTheStatisticsToo) {
  planPlinth();
  ASSERT_TRUE(waitFor([&] { return window().presenter().statistics() != nullptr; }));
  EXPECT_TRUE(window().viewport().view().materialColour);
  click("simulateKinds");
  EXPECT_FALSE(window().viewport().view().materialColour);
  keepPicture(window(), "simulate-kinds");
  click("simulateKinds");
  EXPECT_TRUE(window().viewport().view().materialColour);
}

TEST(JoggedArm, AnglesOfTheNozzleAreThoseItIsSetTo) {
  const Eigen::Isometry3d upright = window::work_T_toolOf({});
  EXPECT_TRUE(upright.linear().col(2).isApprox(-Eigen::Vector3d::UnitZ()));
  for (const Eigen::Vector3d& angles :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(30, -20, 100), Eigen::Vector3d(-170, 60, -10),
        Eigen::Vector3d(5, 89.9, 3)}) {
    const window::NozzlePose pose{{1, 2, 3}, angles};
    const window::NozzlePose back = window::nozzlePose(window::work_T_toolOf(pose));
    EXPECT_NEAR((back.anglesDeg - angles).norm(), 0.0, 1e-6) << angles.transpose();
    EXPECT_TRUE(back.tipMm.isApprox(pose.tipMm));
  }
  // At 90 degrees the same rotation is given by other angles.
  const window::NozzlePose locked{{0, 0, 0}, {40, 90, 10}};
  const Eigen::Isometry3d pose = window::work_T_toolOf(locked);
  EXPECT_TRUE(
      window::work_T_toolOf(window::nozzlePose(pose)).linear().isApprox(pose.linear(), 1e-6));
}

} // namespace
} // namespace voluta::test
