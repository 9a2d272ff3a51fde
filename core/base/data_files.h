// The program's own data, one JSON file an entry: resources/robots, cells, processes.
#pragma once

#include "base/text.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::base {

// Ids (file names without .json) in a folder of resourceFolder(), sorted.
std::vector<std::string> dataFileIds(const std::string& folder);

// The file of `id`. Throws Error{Usage} that says `unknown`, "unknown robot '{id}'"_text, and names
// the nearest.
std::filesystem::path dataFile(const std::string& folder, const std::string& id, Text unknown);

} // namespace voluta::base
