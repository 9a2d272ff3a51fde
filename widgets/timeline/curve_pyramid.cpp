#include "timeline/curve_pyramid.h"

#include "base/error.h"

#include <algorithm>
#include <limits>

namespace voluta::timeline {

namespace {
constexpr std::size_t kFan = 16;

constexpr ValueRange kNothing{std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity()};

void widen(ValueRange& range, const ValueRange& by) {
  range.low = std::min(range.low, by.low);
  range.high = std::max(range.high, by.high);
}

template <typename At> std::vector<ValueRange> levelAbove(std::size_t count, const At& at) {
  std::vector<ValueRange> level((count + kFan - 1) / kFan, kNothing);
  for (std::size_t i = 0; i < count; ++i)
    widen(level[i / kFan], at(i));
  return level;
}
} // namespace

CurvePyramid::CurvePyramid(std::vector<float> values) : values_(std::move(values)) {
  if (values_.size() <= kFan)
    return;
  levels_.push_back(levelAbove(values_.size(), [&](std::size_t i) {
    return ValueRange{values_[i], values_[i]};
  }));
  while (levels_.back().size() > kFan) {
    const std::vector<ValueRange>& below = levels_.back();
    levels_.push_back(levelAbove(below.size(), [&](std::size_t i) { return below[i]; }));
  }
}

ValueRange CurvePyramid::over(std::size_t begin, std::size_t end) const {
  base::require(begin < end && end <= values_.size(), "CurvePyramid: a stretch that exists");
  ValueRange range = kNothing;
  const auto at = [&](std::size_t level, std::size_t i) {
    return level == 0 ? ValueRange{values_[i], values_[i]} : levels_[level - 1][i];
  };
  // Values at the ends that do not fill a range of the next level are taken here, the middle there.
  for (std::size_t level = 0; begin < end; ++level) {
    const bool top = level == levels_.size();
    while (begin < end && (top || begin % kFan != 0))
      widen(range, at(level, begin++));
    while (begin < end && end % kFan != 0)
      widen(range, at(level, --end));
    begin /= kFan;
    end /= kFan;
  }
  return range;
}

} // namespace voluta::timeline
