// Rounds values that need not be exact to a scale of thirteen steps per decade, so that a setting
// that is written on change is written rarely.
#pragma once

namespace voluta::program {

// Return the nearest step that is not smaller (or not larger). Precondition: value > 0.
double steppedUp(double value);
double steppedDown(double value);

} // namespace voluta::program
