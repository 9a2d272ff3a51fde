// Pieces as they are drawn and picked: colours, areas that need support, exploded view.
#include "helpers/shapes.h"
#include "planar/given_cuts.h"
#include "scene/label_places.h"
#include "scene/offscreen_target.h"
#include "scene/piece_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {
using namespace voluta;
using Eigen::Vector3d;

// A ball, and the part above the plane z = 30 as a piece of its own.
std::vector<planar::Piece> ball(bool cut) {
  planar::Piece whole = planar::wholePart(test::sphere({0, 0, 20}, 20), {});
  if (!cut)
    return {whole};
  return planar::cutApart(whole, {{{0, 0, 30}, {Vector3d::UnitZ(), 30.0}, {}}}, {}, 1.2, {});
}

scene::Colour distanceTo(const scene::Colour& a, const scene::Colour& b) {
  return {std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])};
}

TEST(PieceColours, AreDistinctFromRedAndFromTheColourOfOverhangs) {
  std::vector<scene::Colour> known;
  for (const scene::Theme& theme : {scene::lightTheme(), scene::darkTheme()}) {
    known.push_back(theme.blocked);
    known.push_back(theme.risky);
  }
  for (int i = 0; i < 15; ++i) {
    const scene::Colour own = scene::pieceColour(i);
    for (const scene::Colour& other : known) {
      const scene::Colour d = distanceTo(own, other);
      EXPECT_GT(*std::max_element(d.begin(), d.end()), 0.12) << i;
    }
    known.push_back(own);
  }
}

TEST(Pieces, MoveAwayFromTheirBasePiece) {
  auto pieces = ball(true);
  pieces[1].parent = 0;
  const auto drawing = scene::drawPieces(pieces, {});
  ASSERT_EQ(scene::pieceCount(*drawing), 2);
  const auto offsets = scene::pieceOffsets(*drawing, 7.0);
  EXPECT_EQ(offsets[0], Vector3d(0, 0, 0));
  EXPECT_EQ(offsets[1], Vector3d(0, 0, 7));
  EXPECT_EQ(scene::basePlaneOffset(*drawing, 1, 7.0), Vector3d(0, 0, 0)) << "it stays below";
}

TEST(Pieces, AreHitWhereTheyAreDrawnAndReturnTheirTruePlace) {
  auto pieces = ball(true);
  pieces[1].parent = 0;
  scene::OffscreenTarget target;
  scene::Scene scene(scene::lightTheme());
  scene::OffscreenTarget::Session session(target, scene, 200, 160);
  scene.setPieces(scene::drawPieces(pieces, {}));
  scene::ViewState view;
  view.part = false;
  view.pieces = true;
  for (const double explodeMm : {0.0, 25.0}) {
    view.explodeMm = explodeMm;
    scene.setView(view);
    scene.standardView(scene::StandardView::Top);
    const auto hit = scene.pick(100, 80);
    ASSERT_TRUE(hit) << explodeMm;
    EXPECT_EQ(hit->what, scene::Hit::What::Piece);
    EXPECT_EQ(hit->piece, 1u);
    EXPECT_NEAR(hit->point.z(), 40.0, 0.05) << "on the part, wherever it is drawn";
  }
  scene.standardView(scene::StandardView::Bottom);
  const auto below = scene.pick(100, 80);
  ASSERT_TRUE(below);
  EXPECT_EQ(below->piece, 0u);
  view.pieces = false;
  scene.setView(view);
  EXPECT_FALSE(scene.pick(100, 80));
}

TEST(Pieces, LegendNamesThemAndAreasThatNeedSupport) {
  scene::Scene scene(scene::lightTheme());
  auto pieces = ball(true);
  pieces[1].parent = 0;
  scene.setPieces(scene::drawPieces(pieces, {}));
  scene::ViewState view;
  view.pieces = true;
  scene.setView(view);
  EXPECT_TRUE(scene.legend().entries.empty()) << "the picture has the numbers";
  EXPECT_EQ(scene.legend().marks.size(), 1u);
  view.pieceNumbers = false;
  scene.setView(view);
  const scene::Legend legend = scene.legend();
  EXPECT_EQ(base::english(legend.title), "Piece");
  ASSERT_EQ(legend.entries.size(), 2u);
  EXPECT_EQ(base::english(legend.entries[0].text()), "1 (on the plate)");
  EXPECT_EQ(base::english(legend.entries[1].text()), "2");
  EXPECT_EQ(legend.entries[1].colour, scene::pieceColour(1));
  ASSERT_EQ(legend.marks.size(), 1u) << "the ball's lower half leans out";
  EXPECT_EQ(legend.marks[0].colour, scene::lightTheme().risky);
}

// Seen from below, the ball shows only the area that needs support; from above it shows none of it.
TEST(Pieces, AreaThatNeedsSupportHasItsColour) {
  const auto magenta = [](const scene::Image& image) {
    std::size_t count = 0;
    for (std::size_t p = 0; p + 2 < image.rgb.size(); p += 3)
      count += image.rgb[p] > image.rgb[p + 1] + 60 && image.rgb[p + 2] > image.rgb[p + 1] + 40;
    return count;
  };
  scene::Scene scene(scene::lightTheme());
  scene.setPieces(scene::drawPieces(ball(false), {}));
  scene::ViewState view;
  view.part = view.axes = false;
  view.pieces = true;
  scene.setView(view);
  scene::OffscreenTarget target;
  const auto from = [&](scene::StandardView side) {
    return magenta(target.imageOf(scene, 320, 200, [&] { scene.standardView(side); }));
  };
  EXPECT_GT(from(scene::StandardView::Bottom), 3000u);
  EXPECT_EQ(from(scene::StandardView::Top), 0u);
}

// The view from the front with 2 pixels a mm, x to the right and z up.
scene::LabelView fromTheFront() {
  scene::LabelView view;
  view.width = 400;
  view.height = 300;
  view.clip_T_world << 2.0 / 200, 0, 0, 0, 0, 0, 2.0 / 150, 0, 0, 0.01, 0, 0, 0, 0, 0, 1;
  return view;
}

TEST(LabelPlaces, AreInTheMiddleOfTheVisiblePartOfABody) {
  const auto wall = test::box({-60, 10, -40}, {60, 20, 40});
  const auto before = test::box({-60, 0, -40}, {20, 5, 40});
  scene::LabelView view = fromTheFront();
  auto places = scene::labelPlaces({{&wall}}, view);
  ASSERT_TRUE(places[0]);
  EXPECT_NEAR(places[0]->y(), 10.0, 1e-3) << "on the side that is seen";
  EXPECT_NEAR(places[0]->z(), 0.0, 4.0);
  EXPECT_LT(std::abs(places[0]->x()), 24.0);

  places = scene::labelPlaces({{&wall}, {&before}}, view);
  ASSERT_TRUE(places[0] && places[1]);
  EXPECT_NEAR(places[0]->x(), 40.0, 4.0) << "the rest is hidden";
  EXPECT_NEAR(places[1]->y(), 0.0, 1e-3);

  // It is behind all of it; glass lets it through.
  const auto behind = test::box({-50, 30, -30}, {-10, 40, 30});
  places = scene::labelPlaces({{&wall}, {&behind}}, view);
  EXPECT_FALSE(places[1]);
  places = scene::labelPlaces({{&wall}, {&behind, Eigen::Isometry3d::Identity(), true}}, view);
  ASSERT_TRUE(places[1]);
  EXPECT_NEAR(places[1]->y(), 30.0, 1e-3);
  EXPECT_NEAR(places[1]->x(), -30.0, 12.0);
}

TEST(LabelPlaces, AreOnTheMovedBody) {
  const auto ball = test::sphere({0, 0, 0}, 20);
  const Eigen::Isometry3d offset(Eigen::Translation3d(50, 0, 30));
  const auto places = scene::labelPlaces({{&ball, offset}}, fromTheFront());
  ASSERT_TRUE(places[0]);
  EXPECT_LT((*places[0] - Vector3d(0, -20, 0)).norm(), 3.0) << places[0]->transpose();
}

TEST(LabelPlaces, AreLeftOutWhereThereIsNoRoom) {
  const auto chip = test::box({0, 0, 0}, {3, 5, 3});
  scene::LabelView view = fromTheFront();
  view.minRadius = 8.0;
  EXPECT_FALSE(scene::labelPlaces({{&chip}}, view)[0]);

  const auto large = test::box({-20, 0, -20}, {0, 5, 20}),
             small = test::box({0, 0, -5}, {10, 5, 5});
  view.minRadius = 0.0;
  auto places = scene::labelPlaces({{&small}, {&large}}, view);
  EXPECT_TRUE(places[0] && places[1]);
  view.apart = 80.0;
  places = scene::labelPlaces({{&small}, {&large}}, view);
  EXPECT_FALSE(places[0]) << "the label of what shows more stays";
  EXPECT_TRUE(places[1]);
  // A section removes the part above it.
  view.apart = 0.0;
  view.shown = [](const Vector3d& p) { return p.z() < 0.0; };
  places = scene::labelPlaces({{&large}}, view);
  ASSERT_TRUE(places[0]);
  EXPECT_LT(places[0]->z(), -5.0);
}

TEST(Framing, KeepsClearOfOverlays) {
  scene::Scene scene(scene::lightTheme());
  scene.setPieces(scene::drawPieces(ball(false), {}));
  scene::ViewState view;
  view.part = false;
  view.pieces = true;
  scene.setView(view);
  scene::OffscreenTarget target;
  scene::OffscreenTarget::Session session(target, scene, 300, 200);
  const auto heightMm = [&](std::vector<Eigen::AlignedBox2d> covered) {
    scene.setCovered(std::move(covered));
    scene.standardView(scene::StandardView::Front);
    return scene::pictureHeightMm(scene.renderer(), Vector3d(0, 0, 20));
  };
  const double free = heightMm({});
  // The box fills the height: from x = 55 to 245.
  EXPECT_EQ(heightMm({{Eigen::Vector2d(0, 120), Eigen::Vector2d(40, 200)}}), free);
  const double beside = heightMm({{Eigen::Vector2d(0, 120), Eigen::Vector2d(80, 200)}});
  EXPECT_GT(beside, 1.1 * free);
  // Never far off: an overlay over everything is ignored.
  EXPECT_LT(heightMm({{Eigen::Vector2d(0, 0), Eigen::Vector2d(300, 200)}}), 1.5 * free);
}

TEST(PieceNumbers, AreDrawnIfTheViewShowsThem) {
  scene::Scene scene(scene::lightTheme());
  auto pieces = ball(true);
  pieces[1].parent = 0;
  scene.setPieces(scene::drawPieces(pieces, {}));
  scene::ViewState view;
  view.part = view.axes = false;
  view.pieces = true;
  scene::OffscreenTarget target;
  const auto picture = [&] {
    scene.setView(view);
    return target.imageOf(
        scene, 320, 200, [&] { scene.standardView(scene::StandardView::Front); }, 1);
  };
  // Dark strokes with the disc's light ground at either side, which rims and edges do not have.
  const auto strokes = [](const scene::Image& image) {
    const auto at = [&](int x, int y) {
      const std::size_t p = 3 * (static_cast<std::size_t>(y) * 320 + static_cast<std::size_t>(x));
      return std::minmax({image.rgb[p], image.rgb[p + 1], image.rgb[p + 2]});
    };
    std::size_t count = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 6; x < 314; ++x) {
        bool left = false, right = false;
        for (int d = 1; d <= 6; ++d) {
          left = left || at(x - d, y).first > 235;
          right = right || at(x + d, y).first > 235;
        }
        count += at(x, y).second < 100 && left && right;
      }
    return count;
  };
  const std::size_t with = strokes(picture());
  view.pieceNumbers = false;
  const std::size_t without = strokes(picture());
  EXPECT_EQ(without, 0u);
  EXPECT_GE(with, 16u) << "two numbers";
  // And beside pieces of glass, which VTK draws in another way.
  view.pieceNumbers = true;
  view.piece = 1;
  EXPECT_NE(picture().rgb, (view.pieceNumbers = false, picture()).rgb);
}

} // namespace
