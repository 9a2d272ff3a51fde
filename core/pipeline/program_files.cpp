#include "pipeline/program_files.h"

#include "base/error.h"
#include "base/files.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace voluta::pipeline {

namespace {

namespace fs = std::filesystem;

// The folder of a program, in which its file names are resolved.
class Folder {
public:
  explicit Folder(const fs::path& file) : folder_(file.parent_path()) {
    const std::string name = file.filename().string();
    refused_ = name.starts_with(kRefusedPrefix);
  }
  // Returns the path of the file that a program's text calls by this name.
  fs::path pathOf(const std::string& name) const {
    const fs::path refused = folder_ / (std::string(kRefusedPrefix) + name);
    return refused_ && fs::exists(refused) ? refused : folder_ / name;
  }

private:
  fs::path folder_;
  bool refused_ = false;
};

// Returns the first file of the program that contains `file`; nullopt if no program does, or if the
// first file does not exist.
std::optional<std::string> firstOf(const fs::path& file,
                                   const std::vector<project::ProgramReport>& written,
                                   const Folder& folder) {
  const auto is = [&](const std::string& name) { return folder.pathOf(name) == file; };
  for (const project::ProgramReport& program : written)
    if (std::ranges::any_of(program.files, is) && fs::exists(folder.pathOf(program.files.front())))
      return program.files.front();
  return std::nullopt;
}

struct Read {
  std::vector<plan::ProgramFile> files;
  std::vector<fs::path> paths;

  void add(const std::string& name, const fs::path& path) {
    files.push_back({name, base::readFile(path)});
    paths.push_back(path);
  }
};

// Returns a file and all files that it continues in, each once.
FoundProgram programFrom(const std::string& name, const fs::path& path, const fs::path& named,
                         const Folder& folder) {
  Read read;
  read.add(name, path);
  const program::Dialect* dialect =
      program::detectDialect(path.filename().string(), read.files.front().text);
  if (!dialect)
    throw base::Error(base::ErrorCode::UnusableInput, "not a program in any known format"_text,
                      path.string(), "see: list formats"_text);
  for (std::size_t i = 0; i < read.files.size(); ++i)
    for (const std::string& next : program::continuationFiles(*dialect, read.files[i].text))
      if (!next.empty() && next == fs::path(next).filename() &&
          std::ranges::find(read.files, next, &plan::ProgramFile::name) == read.files.end())
        read.add(next, folder.pathOf(next));
  const auto at = std::ranges::find(read.paths, named) - read.paths.begin();
  return {dialect, std::move(read.files), static_cast<std::size_t>(at)};
}

} // namespace

FoundProgram findProgram(const fs::path& file, const std::vector<project::ProgramReport>& written) {
  const Folder folder(file);
  if (const std::optional<std::string> first = firstOf(file, written, folder)) {
    FoundProgram whole = programFrom(*first, folder.pathOf(*first), file, folder);
    if (whole.named < whole.files.size())
      return whole; // otherwise a file of that name is unrelated
  }
  return programFrom(file.filename().string(), file, file, folder);
}

fs::path firstProgramIn(const fs::path& folder,
                        const std::vector<project::ProgramReport>& written) {
  for (const project::ProgramReport& program : written)
    if (!program.files.empty() && fs::exists(folder / program.files.front()))
      return folder / program.files.front();
  throw base::Error(base::ErrorCode::UnusableInput,
                    "the folder holds no program of the station"_text, folder.string(),
                    "name a folder that 'together' wrote"_text);
}

} // namespace voluta::pipeline
