// Runs another program to its end under a time limit, for work that may crash or never end.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace voluta::base {

struct ChildResult {
  enum class End {
    Exited,
    Crashed,
    TimedOut,
    Cancelled,
    TooMuchOutput,
    NotStarted
  } end = End::NotStarted;
  int code = 0;       // Set with Exited
  std::string output; // Its standard output
};

struct ChildLimits {
  std::chrono::milliseconds time{20000};
  std::size_t bytes = std::size_t(1) << 31; // Of output
  // Asked every 50 ms; the program is killed once it returns true. Empty: never
  std::function<bool()> cancelled = {};
};

// Standard input and error are /dev/null. A program that exceeds a limit is killed. Throws only if
// memory runs out; callers interpret how the program ended.
ChildResult runChild(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments, const ChildLimits& limits);

// Returns the path of a companion program: in the folder of this one or, if it is not there, in
// ../libexec/voluta, where it is installed. runChild reports whether it exists.
std::filesystem::path programBeside(const std::string& name);

} // namespace voluta::base
