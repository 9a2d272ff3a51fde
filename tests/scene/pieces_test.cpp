// Pieces as they are drawn and met: colours, what needs support, moved apart.
#include "planar/given_cuts.h"
#include "scene/offscreen_target.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {
using namespace voluta;
using Eigen::Vector3d;

// A ball, and what is above the plane z = 30 as a piece of its own.
std::vector<planar::Piece> ball(bool cut) {
  planar::Piece whole = planar::wholePart(test::sphere({0, 0, 20}, 20), {});
  if (!cut)
    return {whole};
  return planar::cutApart(whole, {{{0, 0, 30}, {Vector3d::UnitZ(), 30.0}}}, {}, 1.2, {});
}

scene::Colour distanceTo(const scene::Colour& a, const scene::Colour& b) {
  return {std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])};
}

TEST(PieceColours, AreDistinctAndNeitherRedNorThatOfWhatNeedsSupport) {
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

TEST(Pieces, MoveOffTheOneTheyStandOn) {
  auto pieces = ball(true);
  pieces[1].parent = 0;
  const auto drawing = scene::drawPieces(pieces, {});
  ASSERT_EQ(scene::pieceCount(*drawing), 2);
  const auto offsets = scene::pieceOffsets(*drawing, 7.0);
  EXPECT_EQ(offsets[0], Vector3d(0, 0, 0));
  EXPECT_EQ(offsets[1], Vector3d(0, 0, 7));
  EXPECT_EQ(scene::basePlaneOffset(*drawing, 1, 7.0), Vector3d(0, 0, 0)) << "it stays below";
}

TEST(Pieces, AreMetWhereTheyAreDrawnAndToldWhereTheyBelong) {
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

TEST(Pieces, LegendNamesThemAndWhatNeedsSupport) {
  scene::Scene scene(scene::lightTheme());
  auto pieces = ball(true);
  pieces[1].parent = 0;
  scene.setPieces(scene::drawPieces(pieces, {}));
  scene::ViewState view;
  view.pieces = true;
  scene.setView(view);
  const scene::Legend legend = scene.legend();
  EXPECT_EQ(legend.title, "Piece");
  ASSERT_EQ(legend.entries.size(), 2u);
  EXPECT_EQ(legend.entries[0].text(), "1 (on the plate)");
  EXPECT_EQ(legend.entries[1].text(), "2");
  EXPECT_EQ(legend.entries[1].colour, scene::pieceColour(1));
  ASSERT_EQ(legend.marks.size(), 1u) << "the ball's lower half leans out";
  EXPECT_EQ(legend.marks[0].colour, scene::lightTheme().risky);
}

// Seen from below, the ball shows nothing but what needs support; from above it shows none of it.
TEST(Pieces, WhatNeedsSupportHasItsColour) {
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

} // namespace
