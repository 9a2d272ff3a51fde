// Presets of printing: named settings of layers, walls, infill, supports, seam, speeds and quality.
// A preset states its parent and the settings that differ from the parent's. Those that come with
// the program are read-only; the user's own are one JSON file each in userDataFolder()/presets.
#pragma once

#include "base/parameters.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace voluta::pipeline {

using Settings = std::map<std::string, std::string>; // by key, as texts of base::ParameterTable

struct PrintPreset {
  std::string id, label;
  std::string parent; // an id; empty: none
  Settings settings;  // those that differ from the parent's

  bool operator==(const PrintPreset&) const = default;
};

// Returns the settings that a preset may have: those of allParameters() below the headings Layers,
// Beads, Tool-paths, Cooling and Quality. It has none about the part (its size, its mesh, planes
// and files for it), the tools, the program, the outputs, or the clearances and the model of
// collisions.
const base::ParameterTable& presetParameters();

// Returns the ids of all presets, sorted.
std::vector<std::string> presetIds();
bool presetComesWithProgram(const std::string& id);

// Reads the text of a preset's file; `name` names it in errors. Accepts old keys of renamed
// settings. Throws Error{UnreadableFile, UnusableInput}: no JSON, an unknown key or setting (names
// the nearest), an invalid value.
PrintPreset readPreset(const std::string& text, const std::string& name);
std::string presetText(const PrintPreset& preset);
// `choice`: an id, a label, a file that ends with ".json", or the text of one. Throws Error{Usage}
// for an unknown one, naming the nearest; else as readPreset().
PrintPreset loadPreset(const std::string& choice);

// Returns the settings of a preset with those of its parents. Throws Error{UnusableInput} if a
// parent does not exist or presets are each other's parents; else as loadPreset().
Settings presetSettings(const PrintPreset& preset);
// Returns the choice that a job stores for a preset: the id of one that comes with the program.
// That of an own one is a text with the settings of its own parents, so that projects need no file
// of the user's. Throws as presetSettings().
std::string presetChoice(const PrintPreset& preset);

// Throws Error{UnusableInput} if an own preset cannot have that label: it is blank, or another
// preset has it. `id`: of the preset that is to have it.
void checkPresetLabel(const std::string& label, const std::string& id);
// Returns an id for a new preset with that label.
std::string freePresetId(const std::string& label);

// Writes an own preset, replacing one with the same id, and returns its file. Throws
// Error{UnusableInput} if the id is no file name or that of a preset that comes with the program;
// as checkPresetLabel() and presetSettings(); Error{CannotWrite}.
std::filesystem::path saveOwnPreset(const PrintPreset& preset);
// Reads a file and checks that it can be saved as own preset. Throws as readPreset() and
// saveOwnPreset().
PrintPreset importablePreset(const std::filesystem::path& file);
// Deletes the file of an own preset. Own presets that it is the parent of keep their settings.
// Throws Error{UnusableInput} for one that comes with the program, Error{CannotWrite}.
void removeOwnPreset(const std::string& id);

} // namespace voluta::pipeline
