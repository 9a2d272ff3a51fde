// The limit of places and lengths that users type and files contain.
#pragma once

#include "base/error.h"

#include <cmath>
#include <span>
#include <string_view>

namespace voluta::base {

inline constexpr double kFarthestMm = 1e6;

// Throws Error{Usage} if one of the lengths or coordinates is beyond a kilometre. `text`: they, as
// typed; `name`: of the value that has them.
inline void refuseFar(std::span<const double> mm, std::string_view text, const Value& name) {
  for (const double one : mm)
    if (!(std::abs(one) <= kFarthestMm))
      throw Error(ErrorCode::Usage,
                  message("'{text}' is more than a kilometre away"_text, text.substr(0, 60)), name,
                  "give places in mm"_text);
}

} // namespace voluta::base
