// A program on disk, with the files that it goes on in.
#pragma once

#include "plan/program.h"
#include "program/dialect.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct FoundProgram {
  const program::Dialect* dialect = nullptr; // never null
  std::vector<plan::ProgramFile> files;      // the one that was named first, each once
};

// Throws Error{UnreadableFile}: a file is missing; Error{UnusableInput}: no known format.
FoundProgram findProgram(const std::filesystem::path& program);
// The same where the first file is read already.
FoundProgram findProgram(const std::filesystem::path& program, std::string text);

} // namespace voluta::pipeline
