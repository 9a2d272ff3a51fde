// What the command line ends with (docs/design.md, Command line).
#pragma once

#include "base/error.h"

namespace voluta::cli {

enum ExitCode {
  kDone = 0,          // done and verified
  kInternal = 1,      // a mistake of the program
  kUsage = 2,         // the request is wrong
  kUnusableInput = 3, // the input cannot be used
  kNotAll = 4,        // planned, but something can't be printed, reached or verified
  kCancelled = 5
};

inline ExitCode exitCodeOf(base::ErrorCode code) {
  switch (code) {
  case base::ErrorCode::Usage:
  case base::ErrorCode::CannotWrite:
    return kUsage;
  case base::ErrorCode::UnreadableFile:
  case base::ErrorCode::UnusableInput:
    return kUnusableInput;
  case base::ErrorCode::SolverFailure:
  case base::ErrorCode::Internal:
    break;
  }
  return kInternal;
}

} // namespace voluta::cli
