// Figures that need not be exact, on a scale of thirteen steps a decade: a setting that is written
// where it changes is then written seldom.
#pragma once

namespace voluta::program {

// The nearest step that is no less, or no more. Precondition: value > 0.
double steppedUp(double value);
double steppedDown(double value);

} // namespace voluta::program
