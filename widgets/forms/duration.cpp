#include "forms/duration.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace voluta::forms {

namespace {
struct Duration {
  Q_DECLARE_TR_FUNCTIONS(Duration)
};
} // namespace

QString durationText(double seconds) {
  const auto whole = static_cast<long long>(std::llround(std::max(0.0, seconds)));
  if (whole < 60)
    return Duration::tr("%1 s").arg(whole);
  if (whole < 3600)
    return Duration::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
  const long long minutes = (whole + 30) / 60;
  return Duration::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

QString clockText(double timeS, double endS) {
  const auto whole = static_cast<long long>(std::floor(timeS + 1e-9));
  const auto two = [](long long n) { return QStringLiteral("%1").arg(n, 2, 10, QLatin1Char('0')); };
  const QString minutes = two(whole / 60 % 60) + QLatin1Char(':') + two(whole % 60);
  return endS < 3600.0 ? minutes : QStringLiteral("%1:%2").arg(whole / 3600).arg(minutes);
}

} // namespace voluta::forms
