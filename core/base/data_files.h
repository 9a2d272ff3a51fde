// The program's own data, one JSON file an entry: resources/robots, cells, processes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::base {

// Ids (file names without .json) in a folder of resourceFolder(), sorted.
std::vector<std::string> dataFileIds(const std::string& folder);

// The file of `id`. Throws Error{Usage} "unknown <what> 'id'" that names the nearest.
std::filesystem::path dataFile(const std::string& folder, const std::string& id,
                               const std::string& what);

} // namespace voluta::base
