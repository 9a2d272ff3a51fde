// Numbers for display: with a given number of significant digits and without powers of ten.
#pragma once

namespace voluta::base {

struct ShownNumber {
  double value = 0.0; // Rounded
  int decimals = 0;   // Decimals needed, without trailing zeros
};

// Returns `value` rounded to `digits` significant digits: 3484.2 to three as {3480, 0}, 0.1204 to
// three as {0.12, 2}. Values nearer to 0 than 1e-9 give 0. At least one digit.
ShownNumber shownNumber(double value, int digits);

// Returns `value` rounded to `decimals`, but away from a limit that it would otherwise meet: beside
// "at least 97.00" 96.9996 reads 96.99. A value that equals the limit stays.
double roundedBeyond(double value, double limit, int decimals);

} // namespace voluta::base
