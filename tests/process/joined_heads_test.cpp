// The head that contains several heads, by sampled radii.
#include "process/joined_heads.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::process {
namespace {

// The radius of the widest section at a height, steps included; 0 above the top.
double radiusAt(const HeadShape& head, double z) {
  double radius = 0.0;
  for (std::size_t i = 0; i + 1 < head.sections.size(); ++i) {
    const HeadSection &a = head.sections[i], &b = head.sections[i + 1];
    if (z < a.zMm || z > b.zMm)
      continue;
    radius = std::max(radius, a.zMm == b.zMm ? std::max(a.radiusMm, b.radiusMm)
                                             : a.radiusMm + (b.radiusMm - a.radiusMm) *
                                                                (z - a.zMm) / (b.zMm - a.zMm));
  }
  return radius;
}

HeadShape randomHead(std::mt19937& random) {
  const auto in = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  HeadShape head;
  double z = 0.0;
  for (std::size_t i = 0, n = 2 + random() % 5; i < n; ++i) {
    head.sections.push_back({z, in(0.5, 30.0)});
    if (i > 0 && i + 1 < n && random() % 3 == 0)
      head.sections.push_back({z, in(0.5, 30.0)}); // a step
    z += in(1.0, 20.0);
  }
  return head;
}

TEST(JoinedHeads, ASingleHeadStays) {
  std::mt19937 random(1);
  const std::vector<HeadShape> heads(3, randomHead(random));
  const HeadShape joined = joinedHeads(heads);
  ASSERT_EQ(joined.sections.size(), heads[0].sections.size());
  for (std::size_t i = 0; i < joined.sections.size(); ++i)
    EXPECT_EQ(joined.sections[i].radiusMm, heads[0].sections[i].radiusMm);
}

TEST(JoinedHeads, ContainsEveryHeadAndIsAsWideAsTheWidestAtItsSections) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const std::vector<HeadShape> heads = {randomHead(random), randomHead(random),
                                          randomHead(random)};
    const HeadShape joined = joinedHeads(heads);
    EXPECT_EQ(joined.sections.front().zMm, 0.0);
    double top = 0.0;
    for (const HeadShape& head : heads)
      top = std::max(top, head.sections.back().zMm);
    EXPECT_EQ(joined.sections.back().zMm, top);
    EXPECT_TRUE(std::ranges::is_sorted(joined.sections, {}, &HeadSection::zMm));
    for (int k = 0; k <= 200; ++k) {
      const double z = top * k / 200.0;
      for (const HeadShape& head : heads)
        EXPECT_GE(radiusAt(joined, z), radiusAt(head, z) - 1e-9) << z;
    }
    for (const HeadSection& section : joined.sections) {
      double widest = 0.0;
      for (const HeadShape& head : heads)
        widest = std::max(widest, radiusAt(head, section.zMm));
      EXPECT_LE(section.radiusMm, widest + 1e-9);
    }
  }
}

} // namespace
} // namespace voluta::process
