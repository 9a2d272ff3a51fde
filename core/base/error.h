// Errors that stop a stage (docs/design.md, Errors): broken preconditions and what cannot go on.
// What cannot be printed, reached or verified is never an error but a plan::Finding.
#pragma once

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

// What cannot go on. `message` says what, `context` where (a file, a line, a key), `remedy` what
// would help; the latter two may be empty. what() is "context: message (remedy)", in one line.
class Error : public std::exception {
public:
  Error(ErrorCode code, std::string message, std::string context = {}, std::string remedy = {});

  ErrorCode code() const { return code_; }
  const std::string& message() const { return message_; }
  const std::string& context() const { return context_; }
  const std::string& remedy() const { return remedy_; }
  const char* what() const noexcept override { return line_.c_str(); }

private:
  ErrorCode code_;
  std::string message_, context_, remedy_, line_;
};

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
