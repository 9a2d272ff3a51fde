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
  return Duration::tr("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

} // namespace voluta::forms
