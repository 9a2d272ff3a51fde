// Data that there is to choose from, one JSON file an entry: the program's own (resources/robots,
// cells, processes), and the user's in folders of the same names below userDataFolder().
#pragma once

#include "base/text.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::base {

// VOLUTA_DATA if set, else "voluta" in XDG_DATA_HOME, else ~/.local/share/voluta. It need not be
// there. Empty: none of these is set.
std::filesystem::path userDataFolder();

// Ids (file names without .json) in a folder of resourceFolder() and of userDataFolder(), sorted,
// each once.
std::vector<std::string> dataFileIds(const std::string& folder);

// The file of `id`; of two the program's own, which the user's cannot take the place of. Throws
// Error{Usage} that says `unknown`, "unknown robot '{id}'"_text, and names the nearest.
std::filesystem::path dataFile(const std::string& folder, const std::string& id, Text unknown);

} // namespace voluta::base
