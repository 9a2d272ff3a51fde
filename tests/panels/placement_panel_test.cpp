#include "base/units.h"
#include "forms/value_boxes.h"
#include "panels/placement_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

using namespace voluta;

namespace {
constexpr double kRight = base::kPi / 2.0;

void type(QWidget* box, const QString& text) {
  QTest::keyClick(box, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(box, text);
  QTest::keyClick(box, Qt::Key_Return);
}

class PlacementPanelTest : public testing::Test {
protected:
  PlacementPanelTest() {
    QObject::connect(&panel, &panels::PlacementPanel::placementChanged,
                     [this](const geometry::Placement& placement, const QString& name) {
                       reported.push_back(placement);
                       names << name;
                     });
  }
  forms::NumberBox* box(const char* name) {
    return panel.findChild<forms::NumberBox*>(QLatin1String(name));
  }
  void press(const char* name) { panel.findChild<QAbstractButton*>(QLatin1String(name))->click(); }

  panels::PlacementPanel panel;
  std::vector<geometry::Placement> reported;
  QStringList names;
};
} // namespace

TEST_F(PlacementPanelTest, TypedAnglesStayAsTypedAtARightAngleToo) {
  type(box("turnX"), "20");
  type(box("turnY"), "90");
  type(box("turnZ"), "30");
  ASSERT_EQ(reported.size(), 3u);
  panel.setPlacement(reported.back());
  EXPECT_DOUBLE_EQ(box("turnX")->value(), 20.0);
  EXPECT_DOUBLE_EQ(box("turnY")->value(), 90.0);
  EXPECT_DOUBLE_EQ(box("turnZ")->value(), 30.0);
}

TEST_F(PlacementPanelTest, QuarterTurnsAreAboutFixedAxesFromTheCurrentPose) {
  press("moreX");
  press("moreZ");
  ASSERT_EQ(reported.size(), 2u);
  const Eigen::Quaterniond wanted = Eigen::AngleAxisd(kRight, Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(kRight, Eigen::Vector3d::UnitX());
  EXPECT_LT(reported.back().rotation.angularDistance(wanted), 1e-9);
  press("lessZ");
  press("lessX");
  EXPECT_LT(reported.back().rotation.angularDistance(Eigen::Quaterniond::Identity()), 1e-9);
  for (const char* name : {"turnX", "turnY", "turnZ"})
    EXPECT_NEAR(box(name)->value(), 0.0, 1e-9);
}

TEST_F(PlacementPanelTest, MoveDropCentreReset) {
  type(box("moveX"), "12.5");
  type(box("moveZ"), "3");
  EXPECT_EQ(reported.back().centreMm, Eigen::Vector2d(12.5, 0.0));
  EXPECT_EQ(reported.back().liftMm, 3.0);
  press("drop");
  EXPECT_EQ(reported.back().liftMm, 0.0);
  EXPECT_EQ(reported.back().centreMm.x(), 12.5);
  press("centre");
  EXPECT_EQ(reported.back().centreMm, Eigen::Vector2d(0.0, 0.0));
  press("moreY");
  press("reset");
  EXPECT_LT(reported.back().rotation.angularDistance(Eigen::Quaterniond::Identity()), 1e-12);
  EXPECT_EQ(names,
            (QStringList{"Move", "Move", "Drop to plate", "Centre", "Turn", "Reset placement"}));
}

TEST_F(PlacementPanelTest, SettingEmitsNothing) {
  QSignalSpy scale(&panel, &panels::PlacementPanel::scaleChanged);
  QSignalSpy lay(&panel, &panels::PlacementPanel::layOnFaceToggled);
  geometry::Placement placement;
  placement.centreMm = {4.0, 5.0};
  placement.rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized());
  panel.setPlacement(placement);
  panel.setScale("fit", 0.42);
  panel.setSizeMm({1, 2, 3});
  panel.setLayOnFace(true);
  EXPECT_TRUE(reported.empty());
  EXPECT_EQ(scale.size() + lay.size(), 0);
  EXPECT_DOUBLE_EQ(box("percent")->value(), 42.0);
  EXPECT_TRUE(panel.findChild<QPushButton*>(QStringLiteral("fit"))->isChecked());
}

TEST_F(PlacementPanelTest, PercentAndFactorAreOneAndFitIsAText) {
  QSignalSpy scale(&panel, &panels::PlacementPanel::scaleChanged);
  type(box("percent"), "50");
  EXPECT_DOUBLE_EQ(box("factor")->value(), 0.5);
  type(box("factor"), "2.5");
  EXPECT_DOUBLE_EQ(box("percent")->value(), 250.0);
  press("fit");
  ASSERT_EQ(scale.size(), 3);
  EXPECT_EQ(scale[0][0].toString(), "0.5");
  EXPECT_EQ(scale[1][0].toString(), "2.5");
  EXPECT_EQ(scale[2][0].toString(), "fit");
}

TEST_F(PlacementPanelTest, FitsIntoANarrowPanel) {
  EXPECT_LE(panel.minimumSizeHint().width(), 300);
}
