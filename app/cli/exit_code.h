// Exit codes of the command line (docs/design.md, Command line).
#pragma once

#include "base/error.h"

namespace voluta::cli {

enum ExitCode {
  kDone = 0,          // Done and verified
  kInternal = 1,      // A bug in the program
  kUsage = 2,         // The request is invalid
  kUnusableInput = 3, // The input cannot be used
  kNotAll = 4,        // Planned, but part of it cannot be printed, reached or verified
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
