// Runs a program and reads what it prints.
#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <sys/wait.h>

namespace voluta::test {

struct ProgramOutput {
  int code = -1; // Exit code
  std::string text;
};

// `command`: of the shell. Only its standard output is read.
inline ProgramOutput outputOf(const std::string& command) {
  ProgramOutput output;
  FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe)
    return output;
  std::array<char, 4096> block{};
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), pipe))
    output.text.append(block.data(), n);
  const int status = ::pclose(pipe);
  if (WIFEXITED(status))
    output.code = WEXITSTATUS(status);
  return output;
}

} // namespace voluta::test
