// Another program, run to its end under a time limit: for work that may crash or never end.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace voluta::base {

struct ChildResult {
  enum class End { Exited, Crashed, TimedOut, TooMuchOutput, NotStarted } end = End::NotStarted;
  int code = 0;       // with Exited
  std::string output; // what it wrote to its standard output
};

struct ChildLimits {
  std::chrono::milliseconds time{20000};
  std::size_t bytes = std::size_t(1) << 31; // of output
};

// Standard input and error are /dev/null. A program over a limit is killed. Never throws but for
// want of memory; its callers say what its end means.
ChildResult runChild(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments, const ChildLimits& limits);

// A program that comes with this one, in the same folder. Whether it is there, runChild tells.
std::filesystem::path programBeside(const std::string& name);

} // namespace voluta::base
