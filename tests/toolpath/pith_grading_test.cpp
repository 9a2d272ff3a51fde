// Density that falls as a cosine from the pith outwards.
#include "toolpath/sparse/pith_grading.h"

#include "base/units.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace voluta::toolpath {
namespace {

struct Places {
  std::vector<double> mm, area;
};

// Rings of a disc, or parts of a strip whose walls are its long sides.
Places placesOf(double deepest, bool isDisc) {
  Places places;
  constexpr int kRings = 2000;
  for (int k = 0; k < kRings; ++k) {
    const double mm = deepest * (k + 0.5) / kRings;
    places.mm.push_back(mm);
    places.area.push_back(isDisc ? deepest - mm : 1.0);
  }
  places.mm.push_back(deepest);
  places.area.push_back(0.0);
  return places;
}

TEST(PithGrading, HasTheDensityOnAverage) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    const double deepest = 3.0 + 40.0 * share(random), density = 0.05 + 0.8 * share(random);
    const Places places = placesOf(deepest, k % 2 == 0);
    const PithGrading grading = pithGrading(places.mm, places.area, density);
    double sum = 0.0, area = 0.0, last = -1.0;
    for (std::size_t i = 0; i < places.mm.size(); ++i) {
      const double here = grading.densityAt(places.mm[i]);
      EXPECT_GE(here, 0.0);
      EXPECT_LE(here, 1.0);
      sum += here * places.area[i];
      area += places.area[i];
      const double even = grading.evenMm(places.mm[i]);
      ASSERT_GT(even, last);
      last = even;
    }
    EXPECT_NEAR(sum / area, density, 2e-3);
    EXPECT_GT(grading.densityAt(deepest), grading.densityAt(0.0));
  }
}

// Over a strip, a cosine has no mean: the density is that of the pattern, and twice as dense less
// the rest below the skin at the pith.
TEST(PithGrading, OfAStripIsACosine) {
  const Places places = placesOf(10.0, false);
  const PithGrading grading = pithGrading(places.mm, places.area, 0.2);
  EXPECT_NEAR(grading.densityAt(10.0), 0.36, 1e-4);
  EXPECT_NEAR(grading.densityAt(5.0), 0.2, 1e-4);
  EXPECT_NEAR(grading.densityAt(0.0), 0.04, 1e-4);
  EXPECT_NEAR(grading.evenMm(10.0), 10.0, 1e-3);
  EXPECT_NEAR(grading.evenMm(5.0), 5.0 - 0.8 * 10.0 / base::kPi, 1e-3);
}

TEST(PithGrading, WithoutRoomIsEven) {
  const std::vector<double> mm{-0.3, 0.0}, area{1.0, 1.0};
  const PithGrading grading = pithGrading(mm, area, 0.3);
  EXPECT_DOUBLE_EQ(grading.evenMm(0.7), 0.7);
  EXPECT_DOUBLE_EQ(grading.densityAt(0.7), 0.3);
}

} // namespace
} // namespace voluta::toolpath
