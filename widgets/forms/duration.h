// Times in the window: how long something takes in words, a moment of a print as on a clock.
#pragma once

#include <QString>

namespace voluta::forms {

// "12 s", "5 min 30 s", "2 h 29 min", in the window's language.
QString durationText(double seconds);

// A moment, in seconds from the start: "12:34", "2:29:05" where `endS` is an hour or more.
QString clockText(double timeS, double endS);

} // namespace voluta::forms
