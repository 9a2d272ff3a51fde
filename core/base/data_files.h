// Data that there is to choose from, one JSON file an entry: the program's own (resources/robots,
// cells, processes), and the user's in folders of the same names below userDataFolder().
#pragma once

#include "base/text.h"

#include <filesystem>
#include <string>
#include <string_view>
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

// A choice of data is an id, or the text of such a file: one of the user's own that goes with the
// project. Returns whether `choice` is a text.
bool isDataText(std::string_view choice);

// Returns the id that is chosen, also that in a text; empty where a text has none.
std::string dataName(const std::string& choice);

struct DataText {
  std::string text;
  std::filesystem::path file; // names the text in errors
};
// Returns the text that `choice` stands for. Throws as dataFile() and readFile().
DataText dataText(const std::string& folder, const std::string& choice, Text unknown);

// Returns whether a choice on the command line is a file's name: it ends with ".json".
bool isDataFileName(const std::string& choice);

} // namespace voluta::base
