#include "panels/ways_list.h"

#include "base/error.h"
#include "base/units.h"
#include "helpers/shapes.h"
#include "panels/stand_picture.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>
#include <set>

using namespace voluta;

namespace {

std::vector<panels::ShownOrientation> someWays(std::size_t count) {
  const auto pictures =
      panels::standPictures(test::box({0, 0, 0}, {30, 20, 10}), {Eigen::Quaterniond::Identity()},
                            panels::WaysList::pictureSize());
  panels::ShownOrientation orientation;
  orientation.picture = pictures[0];
  orientation.contactMm2 = 12345.0;
  orientation.overhangMm2 = 678.0;
  orientation.heightMm = 90.0;
  orientation.missed = 1234;
  orientation.voxels = 8000;
  orientation.time = "12 h 59 min";
  return std::vector<panels::ShownOrientation>(count, orientation);
}

class WaysListTest : public testing::Test {
protected:
  QAbstractButton* card(int n) {
    return list.findChild<QAbstractButton*>(QStringLiteral("way%1").arg(n));
  }
  QString state() { return list.findChild<QLabel*>("waysState")->text(); }
  panels::WaysList list;
};

TEST_F(WaysListTest, ClickIsSignalledAndMarksNothingByItself) {
  QSignalSpy chosen(&list, &panels::WaysList::chosen);
  list.setWays(someWays(4));
  list.setNow(3);
  EXPECT_EQ(chosen.size(), 0);
  EXPECT_TRUE(card(3)->isChecked());
  card(1)->click();
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), 1);
  EXPECT_TRUE(card(3)->isChecked()) << "the part lies as it did until it does not";
  EXPECT_FALSE(card(1)->isChecked());
}

TEST_F(WaysListTest, StateTextFollowsTheSearchAndTheChoice) {
  EXPECT_FALSE(state().isEmpty()) << "none";
  list.setLooking(true);
  const QString looking = state();
  EXPECT_FALSE(looking.isEmpty());
  list.setLooking(false);
  list.setWays(someWays(3));
  EXPECT_NE(state(), looking);
  EXPECT_FALSE(state().isEmpty()) << "custom orientation";
  list.setNow(0);
  EXPECT_TRUE(state().isEmpty());
  list.setWays(someWays(2));
  EXPECT_EQ(list.count(), 2u);
  EXPECT_TRUE(card(1)->isVisibleTo(&list));
  EXPECT_FALSE(card(2)->isVisibleTo(&list));
  EXPECT_THROW(list.setWays(someWays(5)), base::Error);
}

TEST_F(WaysListTest, EveryFigureHasATextAndRoom) {
  list.setWays(someWays(4));
  EXPECT_LE(list.minimumSizeHint().width(), 320);
  for (int n = 0; n < 4; ++n) {
    EXPECT_TRUE(card(n)->accessibleName().contains("1,234"));
    EXPECT_TRUE(card(n)->toolTip().contains("678"));
    EXPECT_EQ(card(n)->focusPolicy() & Qt::TabFocus, Qt::TabFocus);
  }
  list.resize(list.minimumSizeHint());
  list.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&list));
  for (int n = 0; n < 4; ++n)
    EXPECT_GE(card(n)->width(),
              card(n)->fontMetrics().horizontalAdvance(QStringLiteral("Contact 12,345 mm²")));
}

double inkShare(const QImage& image) {
  int ink = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      ink += qAlpha(image.pixel(x, y)) > 200;
  return static_cast<double>(ink) / (image.width() * image.height());
}

TEST(StandPicture, ShowsThePartInItsOrientationInsideTheFrame) {
  const geometry::TriangleMesh plank = test::box({0, 0, 0}, {60, 20, 4});
  const auto pictures = panels::standPictures(
      plank,
      {Eigen::Quaterniond::Identity(),
       Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * base::kPi, Eigen::Vector3d::UnitY()))},
      {120, 90});
  ASSERT_EQ(pictures.size(), 2u);
  EXPECT_NE(pictures[0], pictures[1]);
  for (const QImage& picture : pictures) {
    EXPECT_EQ(picture.size(), QSize(120, 90));
    EXPECT_GT(inkShare(picture), 0.05);
    for (int x = 0; x < picture.width(); ++x) {
      EXPECT_EQ(qAlpha(picture.pixel(x, 0)), 0) << "cut off";
      EXPECT_EQ(qAlpha(picture.pixel(x, picture.height() - 1)), 0) << "cut off";
    }
  }
  EXPECT_THROW(panels::standPictures({}, {Eigen::Quaterniond::Identity()}, {120, 90}), base::Error);
}

// Three faces of a box are seen, each in its tone.
TEST(StandPicture, FacesDifferInTone) {
  const QImage picture = panels::standPictures(test::box({0, 0, 0}, {30, 30, 30}),
                                               {Eigen::Quaterniond::Identity()}, {90, 90})[0];
  std::set<QRgb> tones;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (qAlpha(picture.pixel(x, y)) == 255)
        tones.insert(picture.pixel(x, y));
  EXPECT_GE(tones.size(), 3u);
}

} // namespace
