#include "base/duration.h"

#include <algorithm>
#include <cmath>

namespace voluta::base {

Message duration(double seconds) {
  const auto whole = static_cast<long long>(std::llround(std::max(0.0, seconds)));
  if (whole < 60)
    return message("{seconds} s"_text, whole);
  if (whole < 3600)
    return message("{minutes} min {seconds} s"_text, whole / 60, whole % 60);
  const long long minutes = (whole + 30) / 60;
  return message("{hours} h {minutes} min"_text, minutes / 60, minutes % 60);
}

} // namespace voluta::base
