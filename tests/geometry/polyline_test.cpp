#include "geometry/polyline.h"

#include "geometry/golden_section.h"

#include <Eigen/Core>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

using namespace voluta::geometry;
using Eigen::Vector2d;

namespace {

// A 3-4-5 step, a vertex twice, and a step along x: lengths 5, 0 and 2.
const std::vector<Vector2d> kLine{{0, 0}, {3, 4}, {3, 4}, {5, 4}};
Vector2d pointAt(std::size_t i) {
  return kLine[i];
}

Vector2d at(const PolylinePlace& place) {
  return kLine[place.segment] + place.share * (kLine[place.segment + 1] - kLine[place.segment]);
}

TEST(Polyline, LengthsAreThoseOfItsSegments) {
  EXPECT_EQ(polylineLength(4, pointAt), 7.0);
  EXPECT_EQ(polylineLength(1, pointAt), 0.0);
  EXPECT_EQ(polylineLength(0, pointAt), 0.0);
  EXPECT_EQ(arcLengths(4, pointAt), (std::vector<double>{0.0, 5.0, 5.0, 7.0}));
}

TEST(Polyline, PlacesAreAtTheirLengths) {
  const std::vector<double> lengths = arcLengths(4, pointAt);
  for (const std::size_t near : {0U, 1U, 2U, 9U}) {
    EXPECT_EQ(at(placeAtLength(lengths, 2.5, near)), Vector2d(1.5, 2.0));
    EXPECT_EQ(at(placeAtLength(lengths, 5.0, near)), Vector2d(3.0, 4.0));
    EXPECT_EQ(at(placeAtLength(lengths, 6.0, near)), Vector2d(4.0, 4.0));
    EXPECT_EQ(at(placeAtLength(lengths, -1.0, near)), Vector2d(0.0, 0.0));
    EXPECT_EQ(at(placeAtLength(lengths, 8.0, near)), Vector2d(5.0, 4.0));
  }
  EXPECT_EQ(placeAtLength(lengths, 6.0).segment, 2U);
}

// Of a circle's chords all are equally long; the place follows from the quotient.
TEST(Polyline, PlacesOfManySegmentsDoNotDependOnWhereTheSearchBegins) {
  constexpr std::size_t kCount = 101;
  const auto circle = [](std::size_t i) {
    const double angle = 0.01 * static_cast<double>(i);
    return Vector2d(std::cos(angle), std::sin(angle));
  };
  const double chord = 2.0 * std::sin(0.005);
  const std::vector<double> lengths = arcLengths(kCount, circle);
  EXPECT_NEAR(lengths.back(), 100.0 * chord, 1e-12);
  for (int k = 0; k < 100; ++k)
    for (const std::size_t near : {0, 17, 50, 99}) {
      const PolylinePlace place = placeAtLength(lengths, (k + 0.25) * chord, near);
      EXPECT_EQ(place.segment, static_cast<std::size_t>(k));
      EXPECT_NEAR(place.share, 0.25, 1e-9);
      const auto after = placeAfter((k + 0.25) * chord, kCount, circle);
      ASSERT_TRUE(after);
      EXPECT_EQ(after->segment, place.segment);
      EXPECT_NEAR(after->share, place.share, 1e-9);
    }
}

TEST(Polyline, PlacesAfterTheStartEndWithTheLine) {
  EXPECT_EQ(at(*placeAfter(0.0, 4, pointAt)), Vector2d(0.0, 0.0));
  EXPECT_EQ(at(*placeAfter(5.5, 4, pointAt)), Vector2d(3.5, 4.0));
  EXPECT_EQ(placeAfter(5.5, 4, pointAt)->segment, 2U);
  EXPECT_FALSE(placeAfter(7.0, 4, pointAt));
  EXPECT_FALSE(placeAfter(0.0, 1, pointAt));
}

TEST(GoldenSection, BracketsTheMinimumAndShrinksByTheGoldenRatio) {
  for (const double minimum : {-1.0, 0.3, 0.5, 2.0}) {
    int queries = 0;
    const auto value = [&](double x) {
      ++queries;
      return (x - minimum) * (x - minimum);
    };
    GoldenSection search(value, -1.0, 2.0);
    for (int k = 1; k <= 20; ++k) {
      search.step();
      EXPECT_NEAR(search.high - search.low, 3.0 * std::pow((std::sqrt(5.0) - 1.0) / 2.0, k), 1e-9);
      EXPECT_LE(search.low, minimum);
      EXPECT_GE(search.high, minimum);
      EXPECT_LT(search.a, search.b);
      EXPECT_EQ(search.atA, (search.a - minimum) * (search.a - minimum));
      EXPECT_EQ(search.atB, (search.b - minimum) * (search.b - minimum));
    }
    EXPECT_EQ(queries, 22);
  }
}

} // namespace
