// Materials of the user's own: one JSON file each in userDataFolder()/materials, read, imported and
// exported in the same form.
#pragma once

#include "process/material.h"

#include <filesystem>
#include <string>

namespace voluta::process {

// Returns the material with that id, or that of the file if `choice` is a file's name. Throws as
// loadMaterial() and readMaterialText().
Material chosenMaterial(const std::string& choice);

// Checks a material's file and copies it to the user's materials, replacing one with the same id.
// Returns the copy's path. Throws Error{UnusableInput} if the id is no file name or that of a
// material that comes with the program; else as readMaterialText() and writeFile().
std::filesystem::path importMaterial(const std::filesystem::path& file);

// Writes a material to a file. Throws as loadMaterial() and writeFile().
void exportMaterial(const std::string& id, const std::filesystem::path& file);

// Returns the text of a process's file with another material; its density and bridges are then the
// material's. A material of the user's own is stored within the text, so that projects need no
// other file. `choice`: as for loadProcess(); `material`: as for chosenMaterial(). Throws as both.
std::string processTextWith(const std::string& choice, const std::string& material);

} // namespace voluta::process
