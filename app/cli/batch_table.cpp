#include "cli/batch_table.h"

#include "base/error.h"
#include "base/files.h"
#include "cli/batch_page.h"
#include "cli/batch_workflow.h"
#include "cli/exit_code.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

namespace voluta::cli {

namespace fs = std::filesystem;

namespace {
using Json = nlohmann::ordered_json;

struct Column {
  const char* key;
  const char* place; // In report.json
};
constexpr Column kColumns[] = {{"verdict", "/verdict"},
                               {"mode", "/decomposition/mode"},
                               {"plannedMode", "/decomposition/mode"},
                               {"layers", "/layers/count"},
                               {"missedVoxels", "/decomposition/missedAfterSupports"},
                               {"waypoints", "/toolpath/waypoints"},
                               {"lengthMm", "/toolpath/lengthMm"},
                               {"materialMm3", "/toolpath/materialMm3"},
                               {"durationS", "/motion/durationS"},
                               {"coveredFraction", "/replay/coveredFraction"},
                               {"unsupportedFraction", "/replay/unsupportedFraction"},
                               {"overfillFraction", "/replay/overfillFraction"},
                               {"massRatio", "/replay/massRatio"},
                               {"collisions", "/replay/collisions"}};

// Returns null if there is no such file, or if it is no JSON.
Json jsonOf(const fs::path& file) {
  if (!fs::exists(file))
    return {};
  Json json = Json::parse(base::readFile(file), nullptr, false);
  return json.is_discarded() ? Json() : json;
}

std::string lastLine(const fs::path& file) {
  if (!fs::exists(file))
    return {};
  std::string text = base::readFile(file);
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  return text.substr(text.rfind('\n') + 1); // npos + 1 is 0
}

Json rowOf(const fs::path& folder, const std::string& name, const Json& job) {
  Json row{{"job", name}, {"part", job.at("words").at(0)}};
  for (const auto& [key, value] : job.at("settings").items())
    row[key] = value;
  const Json result = jsonOf(folder / "results" / (name + ".json"));
  const bool ended = result.is_object() && result.contains("exitCode");
  row["exitCode"] = ended ? result.at("exitCode") : Json();
  const Json report = ended ? jsonOf(folder / "jobs" / name / "report.json") : Json();
  for (const Column& column : kColumns) {
    const Json::json_pointer place(column.place);
    // A setting of the study has its column; "mode" is also a figure.
    if (!row.contains(column.key))
      row[column.key] = report.contains(place) ? report.at(place) : Json();
  }
  row["findings"] = report.contains("findings") ? Json(report.at("findings").size()) : Json();
  row["reason"] = !ended                     ? "not planned"
                  : row["exitCode"] == kDone ? std::string()
                                             : lastLine(folder / "logs" / (name + ".err"));
  return row;
}

std::string cellOf(const Json& value) {
  if (value.is_null())
    return {};
  if (!value.is_string())
    return value.dump();
  const std::string text = value.get<std::string>();
  if (text.find_first_of(",;\"\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

// Rows of a study may have different settings: columns are those of all rows.
std::string csvOf(const Json& rows, const std::vector<std::string>& settings) {
  std::vector<std::string> keys{"job", "part"};
  keys.insert(keys.end(), settings.begin(), settings.end());
  for (const auto& [key, value] : rows.at(0).items())
    if (std::ranges::find(keys, key) == keys.end())
      keys.push_back(key);
  std::string text;
  const auto add = [&](const std::string& key, std::string cell) {
    text += (key == keys.front() ? "" : ",") + std::move(cell);
  };
  for (const std::string& key : keys)
    add(key, key);
  for (const Json& row : rows) {
    text += '\n';
    for (const std::string& key : keys)
      add(key, row.contains(key) ? cellOf(row.at(key)) : std::string());
  }
  return text + "\n";
}

} // namespace

BatchTable writeBatchTable(const fs::path& folder) {
  const Json config = jsonOf(folder / kBatchConfig);
  if (!config.is_object() || !config.contains("jobs"))
    throw base::Error(base::ErrorCode::UnreadableFile, "the folder holds no batch"_text,
                      folder.string());
  BatchTable table;
  Json rows = Json::array();
  std::vector<std::string> settings;
  for (const auto& [name, job] : config.at("jobs").items()) {
    for (const auto& [key, value] : job.at("settings").items())
      if (std::ranges::find(settings, key) == settings.end())
        settings.push_back(key);
    Json row = rowOf(folder, name, job);
    if (row.at("exitCode").is_null())
      table.missing.push_back(name);
    else if (row.at("exitCode") == kDone)
      ++table.verified;
    else
      table.incomplete.push_back(fmt::format("{}: {}", name, row.at("reason").get<std::string>()));
    rows.push_back(std::move(row));
  }
  base::writeFile(folder / "table.json", rows.dump(2) + "\n");
  base::writeFile(folder / "table.csv", csvOf(rows, settings));
  base::writeFile(folder / "compare.html", batchPage(rows, settings));
  return table;
}

} // namespace voluta::cli
