#include "base/data_files.h"

#include "base/error.h"
#include "base/files.h"
#include "base/nearest_name.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace voluta::base {

std::filesystem::path userDataFolder() {
  const auto set = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value ? std::filesystem::path(value) : std::filesystem::path();
  };
  if (auto chosen = set("VOLUTA_DATA"); !chosen.empty())
    return chosen;
  if (auto data = set("XDG_DATA_HOME"); !data.empty())
    return data / "voluta";
  if (auto home = set("HOME"); !home.empty())
    return home / ".local" / "share" / "voluta";
  return {};
}

std::vector<std::string> dataFileIds(const std::string& folder) {
  std::vector<std::string> ids;
  for (const std::filesystem::path& data : {resourceFolder(), userDataFolder()}) {
    std::error_code none;
    if (data.empty())
      continue;
    for (const auto& entry : std::filesystem::directory_iterator(data / folder, none))
      if (entry.path().extension() == ".json")
        ids.push_back(entry.path().stem().string());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::filesystem::path dataFile(const std::string& folder, const std::string& id, Text unknown) {
  const std::vector<std::string> ids = dataFileIds(folder);
  if (std::find(ids.begin(), ids.end(), id) == ids.end())
    throw Error(ErrorCode::Usage, Message(unknown, {id}), {}, didYouMean(id, ids));
  const std::filesystem::path name = std::filesystem::path(folder) / (id + ".json");
  std::error_code none;
  const std::filesystem::path own = resourceFolder() / name;
  return std::filesystem::exists(own, none) ? own : userDataFolder() / name;
}

bool isDataText(std::string_view choice) {
  const std::size_t first = choice.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && choice[first] == '{';
}

std::string dataName(const std::string& choice) {
  if (!isDataText(choice))
    return choice;
  const auto json = nlohmann::json::parse(choice, nullptr, false);
  const auto id = json.is_object() ? json.find("id") : json.end();
  return id != json.end() && id->is_string() ? id->get<std::string>() : std::string();
}

DataText dataText(const std::string& folder, const std::string& choice, Text unknown) {
  if (isDataText(choice))
    return {choice, dataName(choice) + ".json"};
  const std::filesystem::path file = dataFile(folder, choice, unknown);
  return {readFile(file), file};
}

bool isDataFileName(const std::string& choice) {
  return !isDataText(choice) && std::filesystem::path(choice).extension() == ".json";
}

} // namespace voluta::base
