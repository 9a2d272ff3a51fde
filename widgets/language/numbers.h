// Numbers in the language of the window.
#pragma once

#include <QString>

namespace voluta::language {

// With so many significant digits, as base::shownNumber() has them: never as a power of ten.
QString numberText(double number, int digits);

} // namespace voluta::language
