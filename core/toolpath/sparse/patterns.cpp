#include "toolpath/sparse/patterns.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using std::numbers::sqrt3;

// Half of the width [beads] over which countBelow() rises: two lines that cross at a right angle
// then pass each other a bead apart.
constexpr double kRise = 0.7;

// Returns how many of the lines at integers are below `t`. A line is counted gradually, within
// `rise` of it: as a half at the line itself.
double countBelow(double t, double rise) {
  const double line = std::round(t);
  return line - 0.5 + 0.5 * std::clamp((t - line) / rise, -1.0, 1.0);
}

// The lines of several families do not cross: each runs below one family and above another, and
// where two lines meet they exchange their ways (the levels of an arrangement of lines). That holds
// for the sum of the families' counts, if all of them rise with y.
class Families {
public:
  Families(double periodMm, double beadMm) : rise_(std::min(0.45, kRise * beadMm / periodMm)) {}

  template <typename... Numbers> double at(Numbers... numbers) const {
    return (countBelow(numbers, rise_) + ...);
  }

private:
  double rise_; // [periods]
};

PatternValue lines(double period, double) {
  return [period](const Vector3d& p) { return p.y() / period; };
}

// Squares that stand on a corner.
PatternValue grid(double period, double bead) {
  const Families families(period, bead);
  return [period, families](const Vector3d& p) {
    const double u = p.x() / (std::numbers::sqrt2 * period),
                 v = p.y() / (std::numbers::sqrt2 * period);
    return families.at(v - u, v + u);
  };
}

PatternValue triangles(double period, double bead) {
  const Families families(period, bead);
  return [period, families](const Vector3d& p) {
    const double y = p.y() / period, x = p.x() / period;
    return families.at(y, 0.5 * y - 0.5 * sqrt3 * x, 0.5 * y + 0.5 * sqrt3 * x);
  };
}

// Three families of planes perpendicular to each other, which stand on a corner: cubes. In a layer
// they are triangles that change from layer to layer.
PatternValue cubic(double period, double bead) {
  const Families families(period, bead);
  return [period, families](const Vector3d& p) {
    const double y = p.y() / period, x = p.x() / period,
                 z = std::numbers::sqrt2 / 2.0 * p.z() / period;
    return families.at(y + z, 0.5 * y - 0.5 * sqrt3 * x - z, 0.5 * y + 0.5 * sqrt3 * x - z);
  };
}

// Hexagons with edges of `period`: lines that run along every second of their edges and meet their
// neighbours, a bead apart, along the others.
PatternValue honeycomb(double period, double bead) {
  const double row = 0.5 * sqrt3 * period, most = std::max(0.0, 0.5 - 0.5 * bead / row),
               rise = std::min(0.25, 0.25 * bead / row); // Ramps of neighbours do not overlap
  return [=](const Vector3d& p) {
    const double t = p.x() / (3.0 * period);
    // Flat over a third of a period, sloping over a sixth.
    const double wave = std::clamp(6.0 * (std::abs(t - std::floor(t) - 0.5) - 0.25), -0.5, 0.5);
    const double shift = 2.0 * wave * most;
    const double y = p.y() / row;
    // Odd lines are mirror images of even ones.
    return countBelow(0.5 * (y - shift), rise) + countBelow(0.5 * (y + shift) + 0.5, rise);
  };
}

// Schoen's gyroid with a cell of `period`.
PatternValue gyroid(double period, double) {
  return [period](const Vector3d& p) {
    const Vector3d q = 2.0 * base::kPi / period * p;
    return 0.5 + 0.3 * (std::sin(q.x()) * std::cos(q.y()) + std::sin(q.y()) * std::cos(q.z()) +
                        std::sin(q.z()) * std::cos(q.x()));
  };
}

// Area of the gyroid in a cubic cell by the cell's face [Schoen 1970], times the mean share of it
// that a layer cuts.
constexpr double kGyroidLength = 3.0915 * 0.25 * base::kPi;

constexpr std::array<SparsePattern, 7> kPatterns{{
    {"gyroid", "gyroid"_text, kGyroidLength, 1.0, gyroid},
    {"lines", "lines"_text, 1.0, 1.0, lines},
    {"grid", "grid"_text, 2.0, std::numbers::sqrt2, grid},
    {"triangles", "triangles"_text, 3.0, 2.0, triangles},
    {"cubic", "cubic"_text, 3.0, 2.0, cubic},
    {"honeycomb", "honeycomb"_text, 8.0 / (3.0 * sqrt3), sqrt3, honeycomb},
    {"concentric", "concentric"_text, 1.0, 1.0, nullptr},
}};
} // namespace

std::span<const SparsePattern> sparsePatterns() {
  return kPatterns;
}

const SparsePattern& sparsePattern(std::string_view id) {
  std::vector<std::string> ids;
  for (const SparsePattern& pattern : kPatterns) {
    if (pattern.id == id)
      return pattern;
    ids.emplace_back(pattern.id);
  }
  throw base::Error(base::ErrorCode::Usage,
                    base::message("unknown sparse infill '{id}'"_text, std::string(id)),
                    "sparsePattern"_name, base::didYouMean(id, ids));
}

} // namespace voluta::toolpath
