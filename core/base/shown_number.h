// A number as a user reads it: so many significant digits, and never a power of ten.
#pragma once

namespace voluta::base {

struct ShownNumber {
  double value = 0.0; // rounded
  int decimals = 0;   // that it is written with: none of them idle zeros
};

// Returns `value` rounded to `digits` significant digits: 3484.2 to three as {3480, 0}, 0.1204 to
// three as {0.12, 2}. What is nearer to 0 than a billionth is 0.
// At least one digit.
ShownNumber shownNumber(double value, int digits);

} // namespace voluta::base
