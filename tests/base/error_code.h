// The error code that a call throws.
#pragma once

#include "base/error.h"

#include <functional>
#include <gtest/gtest.h>

namespace voluta::test {

inline base::ErrorCode codeOf(const std::function<void()>& f) {
  try {
    f();
  } catch (const base::Error& e) {
    return e.code();
  }
  ADD_FAILURE() << "no Error was thrown";
  return base::ErrorCode::Internal;
}

} // namespace voluta::test
