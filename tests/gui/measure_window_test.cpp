// Measuring in the view by clicks: corners, faces and edges of a block and of a disc.
#include "gui/part_view_fixture.h"
#include "helpers/shapes.h"
#include "viewer/camera_control.h"
#include "window/view_tools.h"

#include <QAction>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <cmath>

namespace voluta::test {
namespace {

class MeasureTest : public PartViewTest {
protected:
  QLabel* card() { return find<QLabel>("measureCard"); }
  // Clicks a place of the part in its place on the plate.
  void click(const Eigen::Vector3d& place) {
    const QString before = card()->text();
    const viewer::CameraControl camera(viewport().scene().renderer());
    const Eigen::Vector3d display = camera.project(place);
    QTest::mouseClick(&viewport(), Qt::LeftButton, {},
                      viewport().fromDisplay({display.x(), display.y()}).toPoint());
    EXPECT_TRUE(waitFor([&] { return card()->text() != before; }, 10000)) << "nothing measured";
  }
  void expectSays(const char* words) {
    EXPECT_TRUE(card()->text().contains(QString::fromUtf8(words)))
        << words << " is not in: " << card()->text().toStdString();
  }
};

TEST_F(MeasureTest, PlacesOfABlock) {
  openFlat(writePart("block.stl", box({-15, -10, 0}, {15, 10, 12})));
  EXPECT_FALSE(card()->isVisible());
  QTest::mouseClick(find<window::ViewTools>("viewTools")->button(find<QAction>("toolMeasure")),
                    Qt::LeftButton);
  EXPECT_EQ(viewport().tool(), viewer::Tool::Measure);
  EXPECT_TRUE(card()->isVisible());
  expectSays("Click a corner");
  viewport().viewFrom(Eigen::Vector3d(1, -1, 1).normalized());
  picture();
  click({3, 2, 12}); // inside the upper face
  expectSays("Wall behind the face: 12.00 mm");
  click({15, -10, 12.0}); // a corner
  expectSays("Corner");
  expectSays("Distance: ");
  EXPECT_EQ(viewport().marks().size(), 2u);
  EXPECT_LT((viewport().marks()[1] - Eigen::Vector3d(15, -10, 12)).norm(), 1e-6);
  keepPicture(window(), "measure_block");
  click({-15, -10, 12}); // begins anew, exactly on the silhouette
  EXPECT_EQ(viewport().marks().size(), 1u);
  click({15, -10, 12});
  expectSays("Distance: 30.00 mm");
  expectSays("X 30.00 mm, Y 0.00 mm, Z 0.00 mm");
  click({3, 2, 12});
  click({3, -10, 5}); // the side
  expectSays("Angle: 90.0");
  // Another placement: the places are not its own.
  document().setScale("1.5");
  EXPECT_TRUE(waitFor([&] { return viewport().marks().empty(); }, 10000));
  expectSays("Click a corner");
  viewport().setFocus();
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_FALSE(card()->isVisible());
}

TEST_F(MeasureTest, RoundFacesAndEdgesOfADisc) {
  geometry::TriangleMesh disc; // of 48 sides
  constexpr int kSides = 48;
  for (int i = 0; i < kSides; ++i)
    for (const double z : {0.0, 9.0}) {
      const double angle = base::kTwoPi * i / kSides;
      disc.vertices.emplace_back(14.0 * std::cos(angle), 14.0 * std::sin(angle), z);
    }
  disc.vertices.emplace_back(0, 0, 0);
  disc.vertices.emplace_back(0, 0, 9);
  for (int i = 0; i < kSides; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % kSides);
    disc.triangles.insert(
        disc.triangles.end(),
        {{a, b, b + 1}, {a, b + 1, a + 1}, {2 * kSides, b, a}, {2 * kSides + 1, a + 1, b + 1}});
  }
  openFlat(writePart("disc.stl", disc));
  QTest::keyClick(&window(), Qt::Key_I);
  ASSERT_EQ(viewport().tool(), viewer::Tool::Measure);
  viewport().viewFrom(Eigen::Vector3d(0, -1, 1).normalized());
  picture();
  const double middle = base::kPi / kSides;
  const Eigen::Vector3d side(14.0 * std::sin(middle), -14.0 * std::cos(middle), 4.5);
  click(side);
  expectSays("Round face: radius 14.00 mm, diameter 28.00 mm");
  expectSays("Wall behind the face: 27.94 mm"); // from strip to strip
  keepPicture(window(), "measure_disc");
  click({0, 14.0, 9.0}); // the far edge of the top
  expectSays("Round edge: radius 14.00 mm");
}

} // namespace
} // namespace voluta::test
