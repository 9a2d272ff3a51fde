#include "forms/duration_text.h"

#include "base/duration.h"
#include "language/words.h"

#include <cmath>

namespace voluta::forms {

QString durationText(double seconds) {
  return language::words(base::duration(seconds));
}

QString clockText(double timeS, double endS) {
  const auto whole = static_cast<long long>(std::floor(timeS + 1e-9));
  const auto two = [](long long n) { return QStringLiteral("%1").arg(n, 2, 10, QLatin1Char('0')); };
  const QString minutes = two(whole / 60 % 60) + QLatin1Char(':') + two(whole % 60);
  return endS < 3600.0 ? minutes : QStringLiteral("%1:%2").arg(whole / 3600).arg(minutes);
}

} // namespace voluta::forms
