// Numbers in the language of the window.
#pragma once

#include <QString>

namespace voluta::language {

// Returns the number with this many significant digits, as base::shownNumber(): never as a power of
// ten.
QString numberText(double number, int digits);

} // namespace voluta::language
