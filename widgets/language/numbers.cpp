#include "language/numbers.h"

#include "base/shown_number.h"

#include <QLocale>

namespace voluta::language {

QString numberText(double number, int digits) {
  const base::ShownNumber shown = base::shownNumber(number, digits);
  return QLocale().toString(shown.value, 'f', shown.decimals);
}

} // namespace voluta::language
