// How long something takes, in words.
#pragma once

#include <QString>

namespace voluta::forms {

// "12 s", "5 min 30 s", "2 h 29 min", in the window's language.
QString durationText(double seconds);

} // namespace voluta::forms
