// Paint of slicers on triangles: the code, by own counts of areas.
#include "geometry/formats/threemf_paint.h"

#include "geometry/formats/threemf_parts.h"
#include "geometry/measures.h"
#include "helpers/slicer_packages.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace voluta::geometry {
namespace {

using Eigen::Vector3d;
using ::testing::Contains, ::testing::HasSubstr, ::testing::IsEmpty, ::testing::Not;

const Facet kFacet{Vector3d(0, 0, 0), Vector3d(8, 0, 0), Vector3d(0, 4, 0)}; // 16 mm2

double areaOf(const Facet& f) {
  return 0.5 * (f[1] - f[0]).cross(f[2] - f[0]).norm();
}

Vector3d middleOf(const Facet& f) {
  return (f[0] + f[1] + f[2]) / 3.0;
}

std::map<int, double> areasOf(const std::vector<PaintedFacet>& pieces) {
  std::map<int, double> areas;
  for (const PaintedFacet& piece : pieces)
    areas[piece.state] += areaOf(piece.facet);
  return areas;
}

std::map<int, double> areasOf(const std::string& code) {
  const auto pieces = paintedFacets(code, kFacet);
  EXPECT_TRUE(pieces) << code;
  return pieces ? areasOf(*pieces) : std::map<int, double>();
}

using Areas = std::map<int, double>;

TEST(ThreeMfPaint, WholeTrianglesHaveTheirState) {
  EXPECT_EQ(areasOf("0"), Areas{});
  EXPECT_EQ(areasOf("4"), (Areas{{1, 16.0}}));
  EXPECT_EQ(areasOf("8"), (Areas{{2, 16.0}}));
  EXPECT_EQ(areasOf("0C"), (Areas{{3, 16.0}}));
  EXPECT_EQ(areasOf("1c"), (Areas{{4, 16.0}}));
  EXPECT_EQ(areasOf("DC"), (Areas{{16, 16.0}}));
  EXPECT_EQ(areasOf("0FC"), (Areas{{18, 16.0}}));
}

// The published example of one divided side, 481: the first half is of extruder 1, the second of 2.
TEST(ThreeMfPaint, DividedTrianglesHaveTheirPieces) {
  const auto halves = paintedFacets("481", kFacet);
  ASSERT_TRUE(halves);
  ASSERT_EQ(halves->size(), 2u);
  for (const PaintedFacet& piece : *halves) {
    EXPECT_NEAR(areaOf(piece.facet), 8.0, 1e-12);
    // Divided from the first corner to the middle (4, 2) of the side opposite of it.
    EXPECT_EQ(piece.state, middleOf(piece.facet).x() > 2.0 * middleOf(piece.facet).y() ? 1 : 2);
  }
  EXPECT_EQ(areasOf("48483"), (Areas{{1, 8.0}, {2, 8.0}}));
  // Two sides: the piece at the corner is a quarter.
  EXPECT_EQ(areasOf("4002"), (Areas{{1, 4.0}}));
  EXPECT_EQ(areasOf("0402"), (Areas{{1, 4.0}}));
  EXPECT_EQ(areasOf("0042"), (Areas{{1, 8.0}}));
  // The corner from which pieces are counted.
  for (const auto& [code, corner] :
       {std::pair("4002", 0), std::pair("4006", 1), std::pair("400A", 2)}) {
    const auto pieces = paintedFacets(code, kFacet);
    ASSERT_TRUE(pieces && pieces->size() == 1u);
    EXPECT_THAT((*pieces)[0].facet, Contains(kFacet[static_cast<std::size_t>(corner)]));
  }
}

// A tree in which each piece knows its area, and its code.
struct Tree {
  std::string stream; // from the root on
  Areas areas;
};

Tree randomTree(const Facet& f, std::mt19937& random, int depth) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  Tree tree;
  const int sides = depth == 0 ? 0 : static_cast<int>(random() % 4);
  const auto side = sides == 3 ? 0U : static_cast<unsigned>(random() % 3);
  if (sides == 0) {
    const int state = static_cast<int>(random() % 40);
    if (state < 3) {
      tree.stream = kDigits[state * 4];
    } else {
      tree.stream = "C";
      int left = state - 3;
      for (; left >= 15; left -= 15)
        tree.stream += 'F';
      tree.stream += kDigits[left];
    }
    if (state > 0)
      tree.areas[state] = areaOf(f);
    return tree;
  }
  tree.stream = kDigits[side * 4 + static_cast<unsigned>(sides)];
  const Vector3d &a = f[side], &b = f[(side + 1) % 3], &c = f[(side + 2) % 3];
  const Vector3d ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  const std::vector<Facet> children =
      sides == 1   ? std::vector<Facet>{{a, b, bc}, {bc, c, a}}
      : sides == 2 ? std::vector<Facet>{{a, ab, ca}, {ab, b, ca}, {b, c, ca}}
                   : std::vector<Facet>{{a, ab, ca}, {ab, b, bc}, {bc, c, ca}, {ab, bc, ca}};
  for (auto child = children.rbegin(); child != children.rend(); ++child) {
    const Tree own = randomTree(*child, random, depth - 1);
    tree.stream += own.stream;
    for (const auto& [state, area] : own.areas)
      tree.areas[state] += area;
  }
  return tree;
}

TEST(ThreeMfPaint, AnyTreeHasTheAreasOfItsStates) {
  std::mt19937 random(5);
  for (int round = 0; round < 500; ++round) {
    const Tree tree = randomTree(kFacet, random, 5);
    const std::string code(tree.stream.rbegin(), tree.stream.rend());
    const Areas found = areasOf(code);
    ASSERT_EQ(found.size(), tree.areas.size()) << code;
    for (const auto& [state, area] : tree.areas)
      EXPECT_NEAR(found.at(state), area, 1e-9) << code;
    // Cut or continued it is damaged.
    if (code.size() > 1) {
      EXPECT_FALSE(paintedFacets(code.substr(1), kFacet)) << code;
    }
    EXPECT_FALSE(paintedFacets("0" + code, kFacet)) << code;
  }
}

TEST(ThreeMfPaint, DamagedCodesAreRefused) {
  for (const char* code : {"", "C", "FC", "1", "41", "G", "4 ", "4D", "44E", "x4"})
    EXPECT_FALSE(paintedFacets(code, kFacet)) << code;
  EXPECT_FALSE(paintedFacets(std::string(5000, '3'), kFacet));
  EXPECT_FALSE(paintedFacets(std::string(5000, 'F') + "C", kFacet));
}

// Each way of writing, with its attributes. The first triangle of the body is half of its
// underside.
TEST(ThreeMfPaint, PaintedSurfacesOfAFileAreModifiers) {
  test::SlicerPart part{{{"body", {-20, -20, 0}, {20, 20, 24}},
                         {"mod", {-9, -9, 2}, {9, 9, 9}, test::SlicerKind::Modifier}}};
  struct Way {
    const char* attributes;
    std::string package;
  };
  for (const bool isPrusa : {true, false}) {
    part.onTriangle =
        isPrusa
            ? R"(slic3rpe:custom_supports="4" slic3rpe:custom_seam="481" slic3rpe:mmu_segmentation="8")"
            : R"(paint_supports="4" paint_seam="481" paint_color="8")";
    const PartOfFile read = read3mfWhole(
        isPrusa ? test::prusaPackage({part}) : test::bambuPackage({part}, true), "part.3mf");
    std::map<std::string, double> painted;
    for (const ModifierOfFile& modifier : read.modifiers)
      if (modifier.isPainted) {
        ASSERT_EQ(modifier.settings.size(), 1u);
        painted[modifier.settings[0].first + "=" + modifier.settings[0].second] +=
            area(modifier.mesh);
        EXPECT_NEAR(bounds(modifier.mesh).max().z(), 0.0, 1e-9);
      }
    EXPECT_EQ(painted, (std::map<std::string, double>{{"paint_supports=1", 800.0},
                                                      {"paint_seam=1", 400.0},
                                                      {"paint_seam=2", 400.0},
                                                      {"paint_color=2", 800.0}}));
    EXPECT_EQ(read.modifiers.size(), 5u) << "paint on modifiers is none";
    EXPECT_THAT(base::english(read.file.repairs), Not(Contains(HasSubstr("paint"))));
  }
}

TEST(ThreeMfPaint, WhatCannotBeUsedIsNamed) {
  test::SlicerPart part{{{"body", {-20, -20, 0}, {20, 20, 24}}}};
  part.onTriangle = R"(paint_supports="C" paint_seam="0C" paint_color="4" paint_fuzzy_skin="4")";
  const PartOfFile read = read3mfWhole(test::bambuPackage({part}, false), "part.3mf");
  EXPECT_THAT(read.modifiers, IsEmpty()) << "colour 1 is the part's";
  const std::vector<std::string> notes = base::english(read.file.repairs);
  for (const char* what :
       {"as it is damaged: painted supports on 1 triangle of 'body' (paint_supports",
        "as it is damaged: a painted seam on 1 triangle of 'body' (paint_seam",
        "not used: a painted fuzzy skin on 1 triangle of 'body'"})
    EXPECT_THAT(notes, Contains(HasSubstr(what)));
  EXPECT_EQ(notes.size(), 3u) << ::testing::PrintToString(notes);
}

} // namespace
} // namespace voluta::geometry
