#include "pipeline/presets/print_preset.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "base/json_node.h"
#include "base/lower_case.h"
#include "base/nearest_name.h"
#include "pipeline/stage_options.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

namespace voluta::pipeline {

namespace {
using Json = nlohmann::ordered_json;

constexpr const char* kFolder = "presets";

// The headings of the form whose settings presets hold. Others are about the part, its tools, the
// outputs, or the safety of the motion.
constexpr base::Text kHeadings[] = {"Layers"_text, "Beads"_text, "Tool-paths"_text, "Cooling"_text,
                                    "Quality"_text};
// Settings of the part below these headings.
constexpr std::string_view kOfThePart[] = {"givenToolPaths", "voxelMm"};

std::filesystem::path fileIn(const std::filesystem::path& folder, const std::string& id) {
  return folder / kFolder / (id + ".json");
}

base::Error unusable(const base::Message& why, const std::string& where,
                     const base::Message& remedy = {}) {
  return base::Error(base::ErrorCode::UnusableInput, why, where, remedy);
}

bool isFileName(const std::string& id) {
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyz0123456789-_.";
  return !id.empty() && id.front() != '.' && id.find_first_not_of(kAllowed) == std::string::npos;
}

void checkOwnId(const std::string& id) {
  if (!isFileName(id))
    throw unusable(base::message("'{id}' cannot be a preset's id"_text, id), {},
                   "use small letters, digits, '-', '_' and '.'"_text);
  if (presetComesWithProgram(id))
    throw unusable(base::message("a preset '{id}' comes with the program"_text, id), {},
                   "choose another id"_text);
}

// Returns the text of a setting's value in JSON. A string is a text as it is.
std::string textOf(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

Json valueOf(const base::ParameterSpec& spec, const std::string& text) {
  return std::visit([](const auto& value) { return Json(value); },
                    base::parseParameter(spec, text));
}

// Adds a setting of a file. Settings of older versions that no longer exist have no effect.
void addSetting(Settings& settings, const base::ParameterTable& table, const std::string& key,
                const Json& value, const std::string& name) {
  if (std::ranges::find(base::droppedKeys(), key) != base::droppedKeys().end())
    return;
  const base::ParameterSpec* spec = table.find(base::currentKey(key));
  if (!spec) {
    if (allParameters().find(base::currentKey(key)))
      throw unusable(
          base::message("'{key}' is not a setting of presets"_text, key), name,
          "presets hold settings of layers, beads, tool-paths, cooling and quality"_text);
    std::vector<std::string> keys;
    for (const base::ParameterSpec& known : table.specs())
      keys.push_back(known.key);
    throw unusable(base::message("'{key}' is not a setting of presets"_text, key), name,
                   base::didYouMean(key, keys));
  }
  try {
    settings[spec->key] = base::formatParameter(base::parseParameter(*spec, textOf(value)));
  } catch (const base::Error& error) {
    throw unusable(base::message("{key}: {reason}"_text, key, error.message()), name,
                   error.remedy());
  }
}

// Returns whether a preset that can be read has that label, ignoring case.
bool hasLabel(const std::string& id, const std::string& label) {
  try {
    return base::lowerCase(loadPreset(id).label) == base::lowerCase(label);
  } catch (const base::Error&) {
    return false;
  }
}

// Returns the choice itself if it is an id, or the id of the preset with that label.
std::string idOf(const std::string& choice) {
  const std::vector<std::string> ids = presetIds();
  if (std::ranges::find(ids, choice) != ids.end())
    return choice;
  for (const std::string& id : ids)
    if (hasLabel(id, choice))
      return id;
  throw base::Error(base::ErrorCode::Usage, base::message("unknown preset '{id}'"_text, choice), {},
                    base::didYouMean(choice, ids));
}

// Returns the presets from the first parent to the preset itself.
std::vector<PrintPreset> lineOf(const PrintPreset& preset) {
  std::vector<PrintPreset> line{preset};
  std::set<std::string> seen{preset.id};
  const std::vector<std::string> ids = presetIds();
  while (!line.back().parent.empty()) {
    const std::string parent = line.back().parent;
    if (std::ranges::find(ids, parent) == ids.end())
      throw unusable(base::message("the parent '{parent}' of preset '{id}' does not exist"_text,
                                   parent, line.back().id),
                     {}, "import the parent first, or name another one"_text);
    if (!seen.insert(parent).second)
      throw unusable(
          base::message("preset '{id}' is its own parent, through its parents"_text, parent), {},
          "name another parent"_text);
    line.push_back(loadPreset(parent));
  }
  std::ranges::reverse(line);
  return line;
}

Settings joined(const std::vector<PrintPreset>& line) {
  Settings all;
  for (const PrintPreset& preset : line)
    for (const auto& [key, text] : preset.settings)
      all[key] = text;
  return all;
}

bool isBlank(const std::string& label) {
  return label.find_first_not_of(" \t\r\n") == std::string::npos;
}

void checkCanBeSaved(const PrintPreset& preset) {
  checkOwnId(preset.id);
  checkPresetLabel(preset.label, preset.id);
  presetSettings(preset);
}

base::ParameterTable settingsOfPrinting() {
  std::vector<base::ParameterSpec> specs = allParameters().specs();
  // Texts are planes, curves, points and files, all in the frame of one part.
  std::erase_if(specs, [](const base::ParameterSpec& spec) {
    return spec.type == base::ParameterType::Text ||
           std::ranges::find(kHeadings, spec.group) == std::end(kHeadings) ||
           std::ranges::find(kOfThePart, spec.key) != std::end(kOfThePart);
  });
  return base::ParameterTable(std::move(specs));
}
} // namespace

const base::ParameterTable& presetParameters() {
  static const base::ParameterTable table = settingsOfPrinting();
  return table;
}

std::vector<std::string> presetIds() {
  return base::dataFileIds(kFolder);
}

bool presetComesWithProgram(const std::string& id) {
  std::error_code none;
  return !id.empty() && std::filesystem::exists(fileIn(base::resourceFolder(), id), none);
}

PrintPreset readPreset(const std::string& text, const std::string& name) {
  const base::JsonNode node = base::JsonNode::parse(text, name);
  node.allowOnly({"id", "label", "parent", "settings"});
  PrintPreset preset{node.at("id").text(), node.at("label").text(), {}, {}};
  if (isBlank(preset.label))
    node.at("label").fail("must not be blank"_text);
  if (node.has("parent"))
    preset.parent = node.at("parent").text();
  const base::JsonNode given = node.at("settings");
  const Json json = Json::parse(text);
  const Json& settings = json.at("settings");
  if (!settings.is_object())
    given.fail("must be an object"_text);
  const base::ParameterTable& table = presetParameters();
  for (const auto& [key, value] : settings.items())
    addSetting(preset.settings, table, key, value, name);
  return preset;
}

std::string presetText(const PrintPreset& preset) {
  Json json{{"id", preset.id}, {"label", preset.label}};
  if (!preset.parent.empty())
    json["parent"] = preset.parent;
  Json settings = Json::object();
  const base::ParameterTable& table = presetParameters();
  for (const base::ParameterSpec& spec : table.specs())
    if (const auto at = preset.settings.find(spec.key); at != preset.settings.end())
      settings[spec.key] = valueOf(spec, at->second);
  json["settings"] = std::move(settings);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

PrintPreset loadPreset(const std::string& choice) {
  if (base::isDataFileName(choice))
    return readPreset(base::readFile(choice), choice);
  if (base::isDataText(choice))
    return readPreset(choice, base::dataName(choice) + ".json");
  const std::string id = idOf(choice);
  const auto file =
      fileIn(presetComesWithProgram(id) ? base::resourceFolder() : base::userDataFolder(), id);
  PrintPreset preset = readPreset(base::readFile(file), file.string());
  if (preset.id != id)
    throw unusable(base::message("the id '{id}' is not the name of the file"_text, preset.id),
                   file.string(), base::message("name it '{id}'"_text, id));
  return preset;
}

Settings presetSettings(const PrintPreset& preset) {
  return joined(lineOf(preset));
}

std::string presetChoice(const PrintPreset& preset) {
  if (presetComesWithProgram(preset.id) && loadPreset(preset.id) == preset)
    return preset.id;
  const std::vector<PrintPreset> line = lineOf(preset);
  const auto own = std::find_if(line.begin(), line.end() - 1, [](const PrintPreset& parent) {
    return !presetComesWithProgram(parent.id);
  });
  return presetText({preset.id, preset.label, own == line.begin() ? std::string() : (own - 1)->id,
                     joined({own, line.end()})});
}

void checkPresetLabel(const std::string& label, const std::string& id) {
  if (isBlank(label))
    throw unusable("a preset needs a name"_text, {}, "type a name"_text);
  for (const std::string& other : presetIds())
    if (other != id && hasLabel(other, label))
      throw unusable(presetComesWithProgram(other)
                         ? base::message("a preset '{label}' comes with the program"_text, label)
                         : base::message("there is a preset '{label}' already"_text, label),
                     {}, "choose another name"_text);
}

std::string freePresetId(const std::string& label) {
  std::string stem;
  for (const char c : base::lowerCase(label))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      stem += c;
    else if (!stem.empty() && stem.back() != '-')
      stem += '-';
  if (!stem.empty() && stem.back() == '-')
    stem.pop_back();
  if (stem.empty())
    stem = "own";
  constexpr std::size_t kLongest = 60; // letters; names of files have 255 at most
  stem.resize(std::min(stem.size(), kLongest));
  const std::vector<std::string> ids = presetIds();
  std::string id = stem;
  for (int count = 2; std::ranges::find(ids, id) != ids.end(); ++count)
    id = stem + "-" + std::to_string(count);
  return id;
}

std::filesystem::path saveOwnPreset(const PrintPreset& preset) {
  checkCanBeSaved(preset);
  const std::filesystem::path file = fileIn(base::userDataFolder(), preset.id);
  std::error_code none;
  std::filesystem::create_directories(file.parent_path(), none); // writeFile() reports a failure
  base::writeFile(file, presetText(preset));
  return file;
}

PrintPreset importablePreset(const std::filesystem::path& file) {
  PrintPreset preset = readPreset(base::readFile(file), file.string());
  try {
    checkCanBeSaved(preset);
  } catch (const base::Error& error) {
    throw base::Error(error.code(), error.message(), file.string(), error.remedy());
  }
  return preset;
}

namespace {
// Makes the children of an own preset, which will be deleted, those of its parent.
void handDown(const PrintPreset& removed) {
  for (const std::string& id : presetIds()) {
    if (presetComesWithProgram(id) || id == removed.id)
      continue;
    try {
      PrintPreset child = loadPreset(id);
      if (child.parent != removed.id)
        continue;
      child.settings.insert(removed.settings.begin(), removed.settings.end());
      child.parent = removed.parent;
      base::writeFile(fileIn(base::userDataFolder(), id), presetText(child));
    } catch (const base::Error& error) {
      if (error.code() == base::ErrorCode::CannotWrite)
        throw;
    }
  }
}
} // namespace

void removeOwnPreset(const std::string& id) {
  checkOwnId(id);
  try {
    handDown(loadPreset(id));
  } catch (const base::Error& error) {
    if (error.code() == base::ErrorCode::CannotWrite)
      throw; // One that cannot be read has nothing to hand down
  }
  const std::filesystem::path file = fileIn(base::userDataFolder(), id);
  std::error_code failure;
  std::filesystem::remove(file, failure);
  if (failure)
    throw base::Error(base::ErrorCode::CannotWrite, "cannot be deleted"_text, file.string());
}

} // namespace voluta::pipeline
