#include "process/joined_heads.h"

#include "base/error.h"

#include <algorithm>
#include <set>

namespace voluta::process {

namespace {
// The radius just below and just above a height; 0 above the head's top.
struct Radii {
  double below = 0.0, above = 0.0;
};

Radii radiiAt(const HeadShape& head, double zMm) {
  const std::vector<HeadSection>& s = head.sections;
  const auto first = std::ranges::lower_bound(s, zMm, {}, &HeadSection::zMm);
  const auto last = std::ranges::upper_bound(s, zMm, {}, &HeadSection::zMm);
  if (first != last)
    return {first->radiusMm, last == s.end() ? 0.0 : (last - 1)->radiusMm};
  if (first == s.end() || first == s.begin())
    return {};
  const HeadSection &a = *(first - 1), &b = *first;
  const double radius = a.radiusMm + (b.radiusMm - a.radiusMm) * (zMm - a.zMm) / (b.zMm - a.zMm);
  return {radius, radius};
}
} // namespace

HeadShape joinedHeads(std::span<const HeadShape> heads) {
  base::require(!heads.empty(), "a head to join");
  if (std::ranges::all_of(heads, [&](const HeadShape& head) {
        return std::ranges::equal(head.sections, heads.front().sections,
                                  [](const HeadSection& a, const HeadSection& b) {
                                    return a.zMm == b.zMm && a.radiusMm == b.radiusMm;
                                  });
      }))
    return heads.front();
  std::set<double> heights;
  for (const HeadShape& head : heads)
    for (const HeadSection& section : head.sections)
      heights.insert(section.zMm);
  HeadShape joined;
  for (const double z : heights) {
    Radii widest;
    for (const HeadShape& head : heads) {
      const Radii own = radiiAt(head, z);
      widest.below = std::max(widest.below, own.below);
      widest.above = std::max(widest.above, own.above);
    }
    if (z > 0.0)
      joined.sections.push_back({z, widest.below});
    const bool isTop = z == *heights.rbegin();
    if (z == 0.0 || (!isTop && widest.above != widest.below))
      joined.sections.push_back({z, widest.above});
  }
  return joined;
}

} // namespace voluta::process
