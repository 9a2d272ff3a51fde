#include "toolpath/sparse/patterns.h"

#include "base/nearest_name.h"
#include "base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using std::numbers::sqrt3;

// Half of the width [beads] over which countBelow() rises: two lines that cross at a right angle
// then pass each other a bead apart.
constexpr double kRise = 0.7;
// Length of the gyroid's lines per area of a layer [1 / period].
constexpr double kGyroidLength = 2.455;

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
  // spacingMm: between the lines of a family.
  Families(double spacingMm, double beadMm) : spacingMm_(spacingMm), beadMm_(beadMm) {}

  // `numbers`: per family, an integer on its lines.
  template <typename... Numbers> double at(const Branching& b, Numbers... numbers) const {
    return (count(numbers, b) + ...);
  }

private:
  double count(double number, const Branching& b) const {
    const double closer = std::exp2(b.times), spacing = spacingMm_ / closer;
    // Branches of a line at 0 end at quarters of the distance to its neighbours.
    const double t = closer * number - (b.times > 0 ? 0.5 : 0.0);
    const double rise = std::min(0.45, kRise * beadMm_ / spacing);
    if (b.apartMm <= 0.0)
      return countBelow(t, rise);
    const double offset = b.apartMm / spacing;
    return countBelow(t - offset, rise) + countBelow(t + offset, rise);
  }

  double spacingMm_, beadMm_;
};

PatternValue lines(double period, double bead) {
  const Families families(period, bead);
  return [=](const Vector3d& p, const Branching& b) {
    return families.at(b, p.y() / period - 0.5); // The first line is half a period from y = 0
  };
}

// Squares that stand on a corner.
PatternValue grid(double period, double bead) {
  const Families families(period, bead);
  return [=](const Vector3d& p, const Branching& b) {
    const double u = p.x() / (std::numbers::sqrt2 * period),
                 v = p.y() / (std::numbers::sqrt2 * period);
    return families.at(b, v - u, v + u);
  };
}

PatternValue triangles(double period, double bead) {
  const Families families(period, bead);
  return [=](const Vector3d& p, const Branching& b) {
    const double y = p.y() / period, x = p.x() / period;
    return families.at(b, y, 0.5 * y - 0.5 * sqrt3 * x, 0.5 * y + 0.5 * sqrt3 * x);
  };
}

// Three families of planes perpendicular to each other, which stand on a corner: cubes. In a layer
// they are triangles that change from layer to layer.
PatternValue cubic(double period, double bead) {
  const Families families(period, bead);
  return [=](const Vector3d& p, const Branching& b) {
    const double y = p.y() / period, x = p.x() / period,
                 z = std::numbers::sqrt2 / 2.0 * p.z() / period;
    return families.at(b, y + z, 0.5 * y - 0.5 * sqrt3 * x - z, 0.5 * y + 0.5 * sqrt3 * x - z);
  };
}

// Hexagons with edges of `period`: lines that run along every second of their edges and meet their
// neighbours, a bead apart, along the others.
PatternValue honeycomb(double period, double bead) {
  const double row = 0.5 * sqrt3 * period, maximum = std::max(0.0, 0.5 - 0.5 * bead / row);
  // Lines of a family are two rows apart. Half a bead, so that ramps of neighbours do not overlap.
  const Families families(2.0 * row, 0.5 / kRise * bead);
  return [=](const Vector3d& p, const Branching& b) {
    const double t = p.x() / (3.0 * period);
    // Flat over a third of a period, sloping over a sixth.
    const double wave = std::clamp(6.0 * (std::abs(t - std::floor(t) - 0.5) - 0.25), -0.5, 0.5);
    const double shift = 2.0 * wave * maximum, y = p.y() / row;
    // Odd lines are mirror images of even ones.
    return families.at(b, 0.5 * (y - shift), 0.5 * (y + shift) + 0.5);
  };
}

// Schoen's gyroid with a cell of `period`.
PatternValue gyroid(double period, double bead) {
  const Families families(period / kGyroidLength, bead);
  return [=](const Vector3d& p, const Branching& b) {
    const Vector3d q = 2.0 * base::kPi / period * p;
    constexpr double kMaximum = 1.5; // midway between the sheets
    const double g = std::sin(q.x()) * std::cos(q.y()) + std::sin(q.y()) * std::cos(q.z()) +
                     std::sin(q.z()) * std::cos(q.x());
    return families.at(b, 0.5 * g / kMaximum);
  };
}

constexpr std::array<SparsePattern, 8> kPatterns{{
    {"gyroid", "gyroid"_text, kGyroidLength, 0.0, 1.0, 1.0 / kGyroidLength, 0.6, gyroid},
    {"lines", "lines"_text, 1.0, 0.0, 1.0, 1.0, std::numbers::sqrt2, lines},
    {"grid", "grid"_text, 2.0, 0.83, std::numbers::sqrt2, 1.0, 1.0, grid},
    {"triangles", "triangles"_text, 3.0, 1.43, 2.0, 1.0, 2.0 / sqrt3, triangles},
    {"cubic", "cubic"_text, 3.0, 1.97, 2.0, 1.0, 2.0 / sqrt3, cubic},
    {"honeycomb", "honeycomb"_text, 8.0 / (3.0 * sqrt3), 0.62, sqrt3, sqrt3, 2.0, honeycomb},
    {"concentric", "concentric"_text, 1.0, 0.0, 1.0, 1.0, std::numbers::sqrt2, lines, true},
    {"pith", "dense at the pith"_text, 1.0, 0.0, 1.0, 1.0, std::numbers::sqrt2, lines, true, true},
}};
} // namespace

double SparsePattern::periodMm(double density, double hatchMm, double beadMm) const {
  const double wanted = density / hatchMm, loss = cornerLoss * beadMm;
  if (loss <= 0.0)
    return lengthPerArea / wanted;
  // Of lengthPerArea / period - loss / period^2 = wanted; at most what the pattern can hold.
  const double root = std::sqrt(std::max(0.0, lengthPerArea * lengthPerArea - 4.0 * loss * wanted));
  return 2.0 * loss / (lengthPerArea - root);
}

std::span<const SparsePattern> sparsePatterns() {
  return kPatterns;
}

const SparsePattern& sparsePattern(std::string_view id) {
  return base::rowWithId(sparsePatterns(), id, "unknown sparse infill '{id}'"_text,
                         "sparsePattern"_name);
}

} // namespace voluta::toolpath
