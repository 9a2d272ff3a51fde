#include "pipeline/presets/chosen_preset.h"

#include "base/error.h"
#include "pipeline/stage_options.h"

namespace voluta::pipeline {

namespace {
using base::ParameterScope;

// Returns the value of a setting; the default if there is none, or none that can be parsed.
base::ParameterValue valueIn(const Settings& settings, const base::ParameterSpec& spec) {
  const auto at = settings.find(spec.key);
  try {
    return at == settings.end() ? spec.defaultValue : base::parseParameter(spec, at->second);
  } catch (const base::Error&) {
    return spec.defaultValue;
  }
}

// Replaces the settings of presets that the job has, or its items.
void replace(Settings& given, const base::ParameterTable& table, bool ofJob, const Settings& preset,
             const Settings& kept) {
  for (const base::ParameterSpec& spec : table.specs()) {
    if ((spec.scope == ParameterScope::Job) != ofJob)
      continue;
    given.erase(spec.key);
    if (const auto stays = kept.find(spec.key); stays != kept.end())
      given.insert(*stays);
    else if (const auto set = preset.find(spec.key); set != preset.end())
      given.insert(*set);
  }
}
} // namespace

Settings settingsOfPreset(const project::Choices& choices) {
  try {
    return presetSettings(loadPreset(choices.preset));
  } catch (const base::Error&) {
    return {};
  }
}

Settings itemSettingsOfPreset(const project::Choices& choices) {
  Settings settings = settingsOfPreset(choices);
  const base::ParameterTable& table = presetParameters();
  std::erase_if(settings, [&](const auto& setting) {
    const base::ParameterSpec* spec = table.find(setting.first);
    return !spec || spec->scope == ParameterScope::Job;
  });
  return settings;
}

std::vector<SettingDifference> settingDifferences(const Settings& first, const Settings& second,
                                                  const base::ParameterTable& defaults) {
  std::vector<SettingDifference> differences;
  for (const base::ParameterSpec& known : presetParameters().specs()) {
    const base::ParameterSpec* found = defaults.find(known.key);
    const base::ParameterSpec& spec = found ? *found : known;
    const base::ParameterValue a = valueIn(first, spec), b = valueIn(second, spec);
    if (a != b)
      differences.push_back({spec, a, b});
  }
  return differences;
}

base::ParameterTable withPresetDefaults(const base::ParameterTable& defaults,
                                        const Settings& preset) {
  std::vector<base::ParameterSpec> specs = defaults.specs();
  for (base::ParameterSpec& spec : specs)
    spec.defaultValue = valueIn(preset, spec);
  return base::ParameterTable(std::move(specs));
}

project::Choices withPreset(project::Choices choices, const std::string& preset,
                            const std::vector<Settings>& kept) {
  base::require(kept.empty() || kept.size() == choices.items.size(), "withPreset: kept of items");
  const PrintPreset chosen = loadPreset(preset);
  const Settings settings = presetSettings(chosen);
  const base::ParameterTable& table = presetParameters();
  const auto keptOf = [&](std::size_t item) { return kept.empty() ? Settings() : kept[item]; };
  choices.preset = presetChoice(chosen);
  replace(choices.parameters, table, true, settings, keptOf(0));
  for (std::size_t i = 0; i < choices.items.size(); ++i)
    replace(choices.item(i).parameters, table, false, settings, keptOf(i));
  return choices;
}

PrintPreset presetWith(const Settings& chosen, const base::ParameterTable& defaults,
                       const PrintPreset& base, const std::string& id, const std::string& label) {
  const bool isSame = id == base.id;
  PrintPreset made{id, label, isSame ? base.parent : base.id, isSame ? base.settings : Settings()};
  const Settings inherited =
      made.parent.empty() ? Settings() : presetSettings(loadPreset(made.parent));
  for (const SettingDifference& change : settingDifferences(presetSettings(base), chosen, defaults))
    if (valueIn(inherited, change.spec) == change.second)
      made.settings.erase(change.spec.key);
    else
      made.settings[change.spec.key] = base::formatParameter(change.second);
  return made;
}

} // namespace voluta::pipeline
