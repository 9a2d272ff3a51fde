// Orientations on the plate: shown for every part, taken by one click, and offered where a part is
// badly oriented.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/findings_panel.h"
#include "panels/placement_panel.h"
#include "panels/ways_list.h"
#include "plan/finding_kinds.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>
#include <QUndoStack>

namespace voluta::test {
namespace {

using project::Stage;

class StandTest : public WindowTest {
protected:
  panels::WaysList* ways() { return find<panels::WaysList>("waysToStand"); }
  QAbstractButton* orientationButton(int n) {
    return find<QAbstractButton>(qPrintable(QString("way%1").arg(n)));
  }
  bool settled() {
    return waitFor([&] {
      return document().upToDate(Stage::Load) && !window().planning().running() &&
             !window().presenter().busy() && ways()->count() > 0 && !ways()->isLooking();
    });
  }
  void openStanding(const QString& file) {
    openPart(file);
    find<QTabWidget>("prepareTabs")->setCurrentIndex(1);
    ASSERT_TRUE(settled());
  }
  double heightMm() { return window().presenter().partBox().sizes().z(); }
  int marked() {
    for (int n = 0; n < static_cast<int>(ways()->count()); ++n)
      if (orientationButton(n)->isChecked())
        return n;
    return -1;
  }
  static void intoSight(QWidget* widget) {
    for (QWidget* up = widget; up; up = up->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(up))
        area->ensureWidgetVisible(widget);
  }
  // As a hand would: into sight, then clicked.
  void click(QAbstractButton* button) {
    intoSight(button);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  bool tellsOfLyingBadly() {
    const auto result = document().result(Stage::Load);
    return std::ranges::any_of(result->job.report.findings, [](const plan::Finding& finding) {
      return finding.kind == plan::FindingKind::LiesBadly;
    });
  }
};

TEST_F(StandTest, OneClickLaysThePartAndUndoTakesItBack) {
  openStanding(writePart("plank.stl", box({0, 0, 0}, {60.0, 24.0, 30.0})));
  ASSERT_EQ(ways()->count(), 3u);
  EXPECT_EQ(marked(), 1) << "as it came, 24 mm would be lower";
  EXPECT_FALSE(tellsOfLyingBadly());
  EXPECT_TRUE(orientationButton(0)->accessibleName().contains("1,800"))
      << orientationButton(0)->accessibleName().toStdString();
  const QImage before = picture();
  click(orientationButton(0));
  ASSERT_TRUE(settled());
  EXPECT_NEAR(heightMm(), 24.0, 1e-6);
  EXPECT_EQ(marked(), 0);
  EXPECT_GT(differingShare(before, picture()), 0.02);
  EXPECT_EQ(document().undoStack()->undoText(), "change orientation");
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(settled());
  EXPECT_NEAR(heightMm(), 30.0, 1e-6);
  EXPECT_EQ(marked(), 1);
  EXPECT_EQ(document().choices().item().placement.rotation.coeffs(),
            Eigen::Quaterniond::Identity().coeffs());
}

TEST_F(StandTest, TheKeyboardLaysItToo) {
  openStanding(writePart("plank.stl", box({0, 0, 0}, {60.0, 24.0, 30.0})));
  const auto* reset = find<panels::PlacementPanel>("placement")->findChild<QWidget*>("reset");
  EXPECT_EQ(reset->nextInFocusChain(), orientationButton(0))
      << "Tab comes there from what stands before";
  EXPECT_EQ(orientationButton(1)->nextInFocusChain(), orientationButton(2));
  orientationButton(2)->setFocus();
  QTest::keyClick(orientationButton(2), Qt::Key_Space);
  ASSERT_TRUE(settled());
  EXPECT_NEAR(heightMm(), 60.0, 1e-6);
  EXPECT_EQ(marked(), 2);
}

TEST_F(StandTest, APlaceOfItsOwnStays) {
  openStanding(writePart("plank.stl", box({0, 0, 0}, {60.0, 24.0, 30.0})));
  geometry::Placement shifted;
  shifted.centreMm = {12.0, -7.0};
  shifted.liftMm = 3.0;
  document().place(shifted, "move");
  ASSERT_TRUE(settled());
  click(orientationButton(0));
  ASSERT_TRUE(settled());
  EXPECT_EQ(document().choices().item().placement.centreMm, shifted.centreMm);
  EXPECT_EQ(document().choices().item().placement.liftMm, 0.0) << "on the plate";
}

TEST_F(StandTest, APartOnItsEdgeIsOfferedTheBestWay) {
  openStanding(writePart("edge.stl", box({0, 0, 0}, {50.0, 6.0, 40.0})));
  ASSERT_TRUE(tellsOfLyingBadly());
  auto* list = find<panels::FindingsPanel>("findings")->findChild<QListView*>();
  ASSERT_EQ(list->model()->rowCount(), 1);
  const QModelIndex first = list->model()->index(0, 0);
  EXPECT_TRUE(first.data().toString().contains("Poor orientation"));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(first).center());
  auto* button =
      find<panels::FindingsPanel>("findings")->findChild<QPushButton*>("remedy_standBest");
  ASSERT_NE(button, nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
  window().planning().cancel();
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_NEAR(heightMm(), 6.0, 1e-3);
  EXPECT_EQ(marked(), 0);
  EXPECT_FALSE(tellsOfLyingBadly());
}

// A part that is turned by hand is shown in its orientation, beside the others.
TEST_F(StandTest, ListIncludesTheOrientationSetByHand) {
  openStanding(writePart("plank.stl", box({0, 0, 0}, {60.0, 24.0, 30.0})));
  geometry::Placement tipped;
  tipped.rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 1.0, 0.0).normalized());
  document().place(tipped, "turn");
  ASSERT_TRUE(settled());
  EXPECT_EQ(ways()->count(), 3u) << "on a corner it does not stand";
  EXPECT_EQ(marked(), -1);
  EXPECT_FALSE(find<QLabel>("waysState")->text().isEmpty());
  click(orientationButton(0));
  ASSERT_TRUE(settled());
  EXPECT_NEAR(heightMm(), 24.0, 1e-3);
  EXPECT_EQ(marked(), 0);
}

TEST_F(StandTest, ThereAreNoneAroundARod) {
  openStanding(writePart("plank.stl", box({0, 0, 0}, {60.0, 24.0, 30.0})));
  EXPECT_TRUE(ways()->isVisible());
  project::Choices choices = document().choices();
  choices.item().automatic = false;
  choices.item().mode = "lathe";
  choices.cell = "lathe";
  choices.item().platform = project::Platform("rod:5x200");
  document().setChoices(choices, "lathe");
  EXPECT_FALSE(ways()->isVisible());
}

// A vase has a wall and a bottom; its card shows that as soon as it is chosen.
TEST_F(StandTest, TheTimeOnACardIsThatOfThePlan) {
  openStanding(writePart("column.stl", box({0, 0, 0}, {30.0, 30.0, 24.0})));
  chooseFlat();
  ASSERT_TRUE(settled());
  const auto minutes = [&] {
    const QRegularExpression about("About (\\d+) min");
    return about.match(orientationButton(marked())->accessibleName()).captured(1).toInt();
  };
  const int solid = minutes();
  EXPECT_GT(solid, 15);
  find<QTabWidget>("prepareTabs")->setCurrentIndex(0);
  auto* row = find<QWidget>("parameters")->findChild<QWidget*>("spiral");
  ASSERT_NE(row, nullptr);
  auto* spiral = row->findChild<QCheckBox*>("editor");
  ASSERT_NE(spiral, nullptr);
  intoSight(spiral);
  QTest::mouseClick(spiral, Qt::LeftButton, {}, {8, spiral->height() / 2});
  ASSERT_EQ(document().choices().parameters.at("spiral"), "true");
  ASSERT_TRUE(settled());
  EXPECT_LT(minutes(), solid / 2);
  window().planning().plan(Stage::Motion);
  ASSERT_TRUE(planned(Stage::Motion));
  EXPECT_NEAR(60.0 * minutes(), document().result(Stage::Motion)->job.report.motion.durationS,
              60.0);
}

} // namespace
} // namespace voluta::test
