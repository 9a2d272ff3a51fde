// Machines printing together: a second one is added, an order of work found, the common time
// scrubbed and all programs saved.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "timeline/machine_lanes.h"
#include "viewer/machines_view.h"
#include "window/together/machine_table.h"
#include "window/together/together_dialog.h"

#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

namespace voluta::test {
namespace {

class TogetherTest : public WindowTest {
protected:
  // Plans a box at the border of the plate that is away from the arm.
  void planBox() {
    openPart(writePart("box.stl", box({-6, -6, 0}, {6, 6, 2})));
    project::Choices choices = document().choices();
    choices.cell = "ur5-moving";
    choices.item().automatic = false;
    choices.item().mode = "flat";
    choices.item().platform = project::Platform("rect:200x200");
    choices.item().platformStays = true;
    choices.item().placement.centreMm = {80.0, 0.0};
    document().setChoices(choices, "job");
    window().planning().plan(project::Stage::Motion);
    ASSERT_TRUE(planned(project::Stage::Motion));
  }
  window::TogetherDialog& open() {
    clickMenu("runMenu", "printTogether");
    EXPECT_TRUE(waitFor([&] { return window().findChild<QWidget*>("togetherDialog"); }));
    return *find<window::TogetherDialog>("togetherDialog");
  }
  void press(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
  std::size_t shown() { return find<viewer::MachinesView>("machinesView")->scene().machineCount(); }
  void setPlace(int column, double value) {
    auto* table = find<window::MachineTable>("machineTable");
    static_cast<QDoubleSpinBox*>(table->cellWidget(1, column))->setValue(value);
  }
  QString figures() { return find<QLabel>("togetherFigures")->text(); }
  bool isFound(window::TogetherDialog& dialog) {
    return waitFor([&] { return dialog.machines().result() != nullptr; });
  }
};

TEST_F(TogetherTest, TwoArmsAreShownInOneTimeAndSaved) {
  planBox();
  window::TogetherDialog& dialog = open();
  EXPECT_FALSE(find<QPushButton>("togetherFind")->isEnabled());
  press("togetherAddAgain");
  ASSERT_TRUE(waitFor([&] { return shown() == 2; }));
  // The plates of both meet at their borders.
  EXPECT_NEAR(dialog.machines().all()[1].shared_T_world.translation().x(), 1040.0, 1.0);
  keepPicture(dialog, "together_placed");
  press("togetherFind");
  ASSERT_TRUE(isFound(dialog));
  keepPicture(dialog, "together_found");
  EXPECT_TRUE(figures().contains("collisions: 0")) << figures().toStdString();
  EXPECT_TRUE(find<QWidget>("togetherLanes")->isVisible());
  EXPECT_GT(find<QListWidget>("togetherPlaces")->count(), 0);

  // Half of the time later both parts have grown.
  const auto before = dialog.machines().momentsAt(0.0);
  auto* lanes = find<timeline::MachineLanes>("togetherLanes");
  QTest::mouseClick(lanes, Qt::LeftButton, {}, {lanes->width() / 2, lanes->height() / 2});
  EXPECT_GT(lanes->timeS(), 0.3 * dialog.machines().endS());
  const auto now = dialog.machines().momentsAt(lanes->timeS());
  EXPECT_GT(now[0].printedWaypoints + now[1].printedWaypoints,
            before[0].printedWaypoints + before[1].printedWaypoints);
  find<QListWidget>("togetherPlaces")->setCurrentRow(0);
  keepPicture(dialog, "together_wait");
  const double from = lanes->timeS();
  QTest::mouseClick(find<QToolButton>("togetherPlay"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return lanes->timeS() > from + 1.0; }));
  QTest::mouseClick(find<QToolButton>("togetherPlay"), Qt::LeftButton);

  dialog.save(path("both"));
  ASSERT_TRUE(waitFor([&] { return figures().contains(path("both")); }));
  for (const char* const file :
       {"station.voluta", "together.json", "machine1/job.voluta", "machine2/job.voluta"})
    EXPECT_TRUE(QFileInfo::exists(path("both") + "/" + file)) << file;

  // The station opens with its places, and its order of work is found again.
  const double clearance = find<QDoubleSpinBox>("togetherClearance")->value();
  dialog.close();
  ASSERT_TRUE(waitFor([&] { return !window().findChild<QWidget*>("togetherDialog"); }));
  window().open(path("both/station.voluta"));
  ASSERT_TRUE(waitFor([&] { return window().findChild<QWidget*>("togetherDialog"); }));
  auto& again = *find<window::TogetherDialog>("togetherDialog");
  ASSERT_TRUE(waitFor([&] { return shown() == 2; }));
  EXPECT_NEAR(again.machines().all()[1].shared_T_world.translation().x(), 1040.0, 1.0);
  EXPECT_EQ(find<QDoubleSpinBox>("togetherClearance")->value(), clearance);
  press("togetherFind");
  ASSERT_TRUE(isFound(again));
  EXPECT_TRUE(figures().contains("collisions: 0")) << figures().toStdString();
  keepPicture(again, "together_opened");
}

TEST_F(TogetherTest, MachinesTooCloseHaveAReasonAndAPlace) {
  planBox();
  window::TogetherDialog& dialog = open();
  press("togetherAddAgain");
  ASSERT_TRUE(waitFor([&] { return shown() == 2; }));
  setPlace(2, 700.0);
  EXPECT_FALSE(dialog.machines().result());
  press("togetherFind");
  ASSERT_TRUE(isFound(dialog));
  EXPECT_TRUE(figures().contains("move them apart")) << figures().toStdString();
  EXPECT_TRUE(figures().contains("Note: the plates of machine 1 (ur5-moving) and machine 2"))
      << figures().toStdString();
  EXPECT_FALSE(find<QPushButton>("togetherSave")->isEnabled());
  keepPicture(dialog, "together_too_close");
  ASSERT_TRUE(find<QPushButton>("togetherApart")->isVisible());
  press("togetherApart");
  EXPECT_NEAR(dialog.machines().all()[1].shared_T_world.translation().x(), 750.0, 1.0);
  auto* table = find<window::MachineTable>("machineTable");
  EXPECT_NEAR(static_cast<QDoubleSpinBox*>(table->cellWidget(1, 2))->value(), 750.0, 1.0);
  ASSERT_TRUE(isFound(dialog));
  press("togetherRemove");
  EXPECT_EQ(dialog.machines().all().size(), 1u);
}

TEST_F(TogetherTest, FileWithoutMotionIsNamed) {
  planBox();
  window::TogetherDialog& dialog = open();
  dialog.addFile(path("none.voluta"));
  ASSERT_TRUE(waitFor([&] { return figures().contains("none.voluta"); }, 20000))
      << figures().toStdString();
  EXPECT_EQ(dialog.machines().all().size(), 1u);
}

} // namespace
} // namespace voluta::test
