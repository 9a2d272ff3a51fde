// Files that a command writes under the name given to it.
#pragma once

#include "base/error.h"

#include <CLI/CLI.hpp>
#include <filesystem>

namespace voluta::cli {

inline void addReplaceFile(CLI::App& command, bool& replace) {
  command.add_flag("--replace", replace, "replace the file if it exists");
}

// Without `replace`, throws Error{CannotWrite} if the file exists. A file without a name is new.
inline void requireNewFile(const std::filesystem::path& file, bool replace) {
  std::error_code none;
  if (!replace && std::filesystem::exists(file, none))
    throw base::Error(base::ErrorCode::CannotWrite, "exists already"_text, file.string(),
                      "choose another name, or give --replace"_text);
}

} // namespace voluta::cli
