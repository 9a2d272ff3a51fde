// Reads a program from disk with the files that it continues in.
#pragma once

#include "plan/program.h"
#include "program/dialect.h"
#include "project/report.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

// Prefix of the file names of programs that the replay refused.
inline constexpr std::string_view kRefusedPrefix = "refused-";

struct FoundProgram {
  const program::Dialect* dialect = nullptr; // never null
  std::vector<plan::ProgramFile> files;      // each once, in the order of execution
  std::size_t named = 0;                     // index of the requested file
};

// Returns the program that contains a file: all files of the program in `written` (of a job) that
// has a file of this name, if its first file is in the same folder; otherwise the file and those it
// continues in. Files of a refused program are returned under the names by which they call each
// other. Throws Error{UnreadableFile} if a file is missing; Error{UnusableInput} for an unknown
// format.
FoundProgram findProgram(const std::filesystem::path& file,
                         const std::vector<project::ProgramReport>& written);

// Returns the first file of the first program in `written` that the folder holds. Throws
// Error{UnusableInput} if it holds none.
std::filesystem::path firstProgramIn(const std::filesystem::path& folder,
                                     const std::vector<project::ProgramReport>& written);

} // namespace voluta::pipeline
