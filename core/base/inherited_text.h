// Data files (data_files.h) that state only the differences from another one: its parent, named by
// the key "inherits".
#pragma once

#include <string>

namespace voluta::base {

// Returns the id of the parent of a file's text; empty: it has none, or is no JSON object.
std::string parentOf(const std::string& text);

// Returns the text with all values: those that it does not state are its parent's, and null states
// that there is none. "basedOn" then names the parent. A text without a parent is returned
// unchanged. `folder`: as for dataFile(); `name` names the text in errors. Throws
// Error{UnusableInput} if a parent does not exist or files are each other's parents; as readFile().
std::string wholeText(const std::string& folder, const std::string& text, const std::string& name);

// Returns the text of a file that inherits from `parent`, whose whole text is `parentText`:
// wholeText() of it has the values of `text`. Id and label are always stated.
// Precondition (Error{Internal}): both texts are JSON objects.
std::string textOfDifferences(const std::string& text, const std::string& parent,
                              const std::string& parentText);

} // namespace voluta::base
