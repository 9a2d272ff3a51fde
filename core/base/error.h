// Errors that stop a stage (docs/design.md, Errors): broken preconditions and what cannot go on.
// What cannot be printed, reached or verified is never an error but a plan::Finding.
#pragma once

#include "base/text.h"

#include <exception>
#include <string>
#include <string_view>

namespace voluta::base {

enum class ErrorCode {
  Usage,          // the request itself is wrong: unknown key, value out of range
  UnreadableFile, // missing, a directory, cut short, not of its format
  UnusableInput,  // read, but nothing can be built from it
  CannotWrite,    // target folder or file cannot be written, disk full
  SolverFailure,  // a numerical step did not end with a usable result
  Internal        // a broken precondition: a mistake in the program
};

// What cannot go on. `message` says what, `context` where (a file, a line, a key: a name, or a
// sentence of names), `remedy` what would help; the latter two may be empty. what() is
// "context: message (remedy)" in English, in one line.
class Error : public std::exception {
public:
  Error(ErrorCode code, Message message, Value context = {}, Message remedy = {});

  ErrorCode code() const { return code_; }
  const Message& message() const { return message_; }
  const Value& context() const { return context_; }
  const Message& remedy() const { return remedy_; }
  // All of it, to be told in any language.
  Message whole() const;
  const char* what() const noexcept override { return line_.c_str(); }

private:
  ErrorCode code_;
  Message message_;
  Value context_;
  Message remedy_;
  std::string line_;
};

// The context "file, line 12". Lines are counted as editors count them, in every language.
Message lineOf(std::string_view file, long long line);

// Thrown by RunContext::checkpoint() once the run was cancelled. Not an Error.
struct Cancelled {};

// Always on, in release builds too. Throws Error{Internal} when `condition` does not hold.
inline void require(bool condition, std::string_view what);
[[noreturn]] void failPrecondition(std::string_view what);

inline void require(bool condition, std::string_view what) {
  if (!condition)
    failPrecondition(what);
}

} // namespace voluta::base
