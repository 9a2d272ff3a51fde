// Names the part in errors of one of several parts.
#pragma once

#include "base/error.h"

#include <string>

namespace voluta::pipeline {

// Calls run(). An error then names the part, if it is one of several.
template <typename Run> auto namingPart(bool isOneOfSeveral, const std::string& part, Run run) {
  try {
    return run();
  } catch (const base::Error& error) {
    const base::Value& place = error.context();
    if (!isOneOfSeveral || error.code() == base::ErrorCode::Internal || place == base::Value(part))
      throw;
    throw base::Error(error.code(), error.message(),
                      place.empty() ? base::Value(part)
                                    : base::message("{part}: {place}"_text, part, place),
                      error.remedy());
  }
}

} // namespace voluta::pipeline
