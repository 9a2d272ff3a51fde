// The preset of a job's choices: its settings in them, and the settings that were changed since.
#pragma once

#include "pipeline/presets/print_preset.h"
#include "project/choices.h"

#include <vector>

namespace voluta::pipeline {

// Returns the settings of the choices' preset; none if it cannot be read.
Settings settingsOfPreset(const project::Choices& choices);
// Returns those of them that each item has, for a new item.
Settings itemSettingsOfPreset(const project::Choices& choices);

struct SettingDifference {
  base::ParameterSpec spec; // with the default of `defaults`
  base::ParameterValue first, second;
};
// Returns the settings of presets that differ, in the order of the table. A setting that one does
// not state has its value in `defaults`.
std::vector<SettingDifference> settingDifferences(const Settings& first, const Settings& second,
                                                  const base::ParameterTable& defaults);

// Returns a table with the values of a preset as defaults.
base::ParameterTable withPresetDefaults(const base::ParameterTable& defaults,
                                        const Settings& preset);

// Returns the choices with a preset and its settings, in all items. Settings that no preset has
// stay. `kept`: settings of each item that stay although the preset has others; empty: none.
// Precondition: `kept` is empty or has an entry for each item. Throws as loadPreset() and
// presetSettings().
project::Choices withPreset(project::Choices choices, const std::string& preset,
                            const std::vector<Settings>& kept = {});

// Returns a preset with other settings, `chosen`: `base` itself if it has that id, else a child of
// `base` with the settings that differ. `defaults`: as for settingDifferences(). Throws as
// presetSettings().
PrintPreset presetWith(const Settings& chosen, const base::ParameterTable& defaults,
                       const PrintPreset& base, const std::string& id, const std::string& label);

} // namespace voluta::pipeline
