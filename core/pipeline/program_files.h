// A program on disk, with the files that it goes on in.
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

// Before the names of a program's files where the replay refused it.
inline constexpr std::string_view kRefusedPrefix = "refused-";

struct FoundProgram {
  const program::Dialect* dialect = nullptr; // never null
  std::vector<plan::ProgramFile> files;      // each once; what is run first
  std::size_t named = 0;                     // of these the one that was asked for
};

// The program that a file is of: all files of the one among `written`, of a job, that has a file of
// this name, where its first file lies beside it; else the file and what it goes on in. Files of a
// refused program bear the names by which they call each other.
// Throws Error{UnreadableFile}: a file is missing; Error{UnusableInput}: no known format.
FoundProgram findProgram(const std::filesystem::path& file,
                         const std::vector<project::ProgramReport>& written);

} // namespace voluta::pipeline
