// Data sets to choose from, one JSON file each: the program's own (resources/robots, cells,
// processes), and the user's in folders of the same names below userDataFolder().
#pragma once

#include "base/text.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {

// Returns VOLUTA_DATA if set, else "voluta" in XDG_DATA_HOME, else ~/.local/share/voluta. The
// folder need not exist. Returns an empty path if none of these is set.
std::filesystem::path userDataFolder();

// Returns the ids (file names without .json) in a folder of resourceFolder() and of
// userDataFolder(), sorted, without duplicates.
std::vector<std::string> dataFileIds(const std::string& folder);

// Returns the file of `id`; the program's own file takes precedence over the user's. Throws
// Error{Usage} with the text `unknown`, e.g. "unknown robot '{id}'"_text, and the nearest id.
std::filesystem::path dataFile(const std::string& folder, const std::string& id, Text unknown);

// A choice of data is an id, or the text of such a file: one of the user's own that is stored in
// the project. Returns whether `choice` is a text.
bool isDataText(std::string_view choice);

// Returns the chosen id, also if it is within a text; empty if a text has none.
std::string dataName(const std::string& choice);

struct DataText {
  std::string text;
  std::filesystem::path file; // Names the text in errors
};
// Returns the text of `choice`. Throws as dataFile() and readFile().
DataText dataText(const std::string& folder, const std::string& choice, Text unknown);

// Returns whether a choice on the command line is a file name: it ends with ".json".
bool isDataFileName(const std::string& choice);

} // namespace voluta::base
