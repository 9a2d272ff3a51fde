// Minimum and maximum over any interval of a long curve without visiting every value.
#pragma once

#include <cstddef>
#include <vector>

namespace voluta::timeline {

struct ValueRange {
  float low, high;
};

// Levels of ranges over 16, 256, ... values above the values themselves; a query costs O(16 log N).
class CurvePyramid {
public:
  CurvePyramid() = default;
  explicit CurvePyramid(std::vector<float> values);

  std::size_t size() const { return values_.size(); }
  float operator[](std::size_t i) const { return values_[i]; }
  // Returns the range over [begin, end). Precondition (Error{Internal}): begin < end <= size().
  ValueRange over(std::size_t begin, std::size_t end) const;

private:
  std::vector<float> values_;
  std::vector<std::vector<ValueRange>> levels_; // [0]: a range per 16 values
};

} // namespace voluta::timeline
