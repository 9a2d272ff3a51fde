// Errors that stop a stage (docs/design.md, Errors): broken preconditions and unusable inputs. A
// place that cannot be printed, reached or verified is never an error but a plan::Finding.
#pragma once

#include "base/text.h"

#include <exception>
#include <string>
#include <string_view>

namespace voluta::base {

enum class ErrorCode {
  Usage,          // The request itself is wrong: unknown key, value out of range
  UnreadableFile, // Missing, a directory, cut short, not of its format
  UnusableInput,  // Read, but nothing can be built from it
  CannotWrite,    // Target folder or file cannot be written, disk full
  SolverFailure,  // A numerical step did not end with a usable result
  Internal        // A broken precondition: a bug in the program
};

// An error. `message` says what failed, `context` where (a file, a line, a key: a name, or a
// sentence of names), `remedy` how to fix it; the latter two may be empty. what() is "context:
// message (remedy)" in English, in one line.
class Error : public std::exception {
public:
  Error(ErrorCode code, Message message, Value context = {}, Message remedy = {});

  ErrorCode code() const { return code_; }
  const Message& message() const { return message_; }
  const Value& context() const { return context_; }
  const Message& remedy() const { return remedy_; }
  // Returns all three parts, for display in any language.
  Message whole() const;
  const char* what() const noexcept override { return line_.c_str(); }

private:
  ErrorCode code_;
  Message message_;
  Value context_;
  Message remedy_;
  std::string line_;
};

// Returns the context "file, line 12". The line number is written without digit grouping in every
// language, as editors show it.
Message lineOf(std::string_view file, long long line);

// Thrown by RunContext::checkpoint() once the run was cancelled. Not an Error.
struct Cancelled {};

// Always on, in release builds too. Throws Error{Internal} if `condition` is false.
inline void require(bool condition, std::string_view what);
[[noreturn]] void failPrecondition(std::string_view what);

inline void require(bool condition, std::string_view what) {
  if (!condition)
    failPrecondition(what);
}

} // namespace voluta::base
