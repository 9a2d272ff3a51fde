#include "pipeline/program_files.h"

#include "base/error.h"
#include "base/files.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {
// `program` and the files beside it that it goes on in, each once.
std::vector<plan::ProgramFile> filesOf(const std::filesystem::path& program,
                                       const program::Dialect& dialect, std::string text) {
  std::vector<plan::ProgramFile> files{{program.filename().string(), std::move(text)}};
  for (std::size_t i = 0; i < files.size(); ++i)
    for (const std::string& name : program::goesOnIn(dialect, files[i].text)) {
      const bool known = std::any_of(files.begin(), files.end(),
                                     [&](const plan::ProgramFile& f) { return f.name == name; });
      if (!known && !name.empty() && name == std::filesystem::path(name).filename())
        files.push_back({name, base::readFile(program.parent_path() / name)});
    }
  return files;
}
} // namespace

FoundProgram findProgram(const std::filesystem::path& program) {
  return findProgram(program, base::readFile(program));
}

FoundProgram findProgram(const std::filesystem::path& program, std::string text) {
  const program::Dialect* dialect = program::detectDialect(program.filename().string(), text);
  if (!dialect)
    throw base::Error(base::ErrorCode::UnusableInput, "not a program in any known format"_text,
                      program.string(), "see: list formats"_text);
  return {dialect, filesOf(program, *dialect, std::move(text))};
}

} // namespace voluta::pipeline
