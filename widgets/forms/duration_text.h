// Times in the window: durations in words, moments of a print as on a clock.
#pragma once

#include <QString>

namespace voluta::forms {

// Returns "12 s", "5 min 30 s" or "2 h 29 min", in the window's language.
QString durationText(double seconds);

// Returns a moment, in seconds from the start: "12:34", or "2:29:05" if `endS` is an hour or more.
QString clockText(double timeS, double endS);

} // namespace voluta::forms
