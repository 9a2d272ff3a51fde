// Golden-section search for the minimum of a function of one variable.
#pragma once

namespace voluta::geometry {

// A bracket [low, high] of the minimum of a convex function, with two positions inside at which its
// values are known. The values at the ends are not needed.
template <typename Value> class GoldenSection {
public:
  // Queries the function at the lower of the two positions first. Keeps a reference to it.
  GoldenSection(const Value& value, double from, double to) : low(from), high(to), value_(value) {
    a = high - kShare * (high - low);
    b = low + kShare * (high - low);
    atA = value_(a);
    atB = value_(b);
  }

  // Returns whether the next step drops what is above b; otherwise it drops what is below a.
  bool dropsUpper() const { return atA < atB; }
  // Shortens the bracket to 0.618 of its length; queries the function once.
  void step() {
    if (dropsUpper()) {
      high = b;
      b = a;
      atB = atA;
      a = high - kShare * (high - low);
      atA = value_(a);
    } else {
      low = a;
      a = b;
      atA = atB;
      b = low + kShare * (high - low);
      atB = value_(b);
    }
  }

  double low, high;            // The bracket's ends
  double a, b;                 // Positions inside, a < b
  double atA = 0.0, atB = 0.0; // Values there

private:
  static constexpr double kShare = 0.6180339887498949;
  const Value& value_;
};

} // namespace voluta::geometry
