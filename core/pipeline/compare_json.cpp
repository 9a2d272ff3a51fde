#include "base/data_files.h"
#include "pipeline/compare_figures.h"
#include "project/version.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace voluta::pipeline {

namespace {
using Json = nlohmann::ordered_json;

template <typename T> Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}
Json orNull(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

// Counts are written as integers.
Json number(const std::optional<double>& value, bool count) {
  if (!value)
    return Json();
  return count ? Json(static_cast<long long>(*value)) : Json(*value);
}

Json numbersOf(const std::vector<std::size_t>& rows) {
  Json numbers = Json::array();
  for (const std::size_t row : rows)
    numbers.push_back(row + 1);
  return numbers;
}

Json rowJson(std::size_t index, const CompareRow& row, const std::optional<double>& score,
             const RowFiles& files) {
  const project::DecompositionReport& d = row.report.item().decomposition;
  Json json{{"number", index + 1},
            {"mode", row.combination.mode},
            {"growth", row.combination.growth ? Json(row.combination.growth->id()) : Json()},
            {"scheme", orNull(d.growth)},
            {"platform", row.combination.platform.text()},
            {"state", stateName(row.state())},
            {"reason", orNull(base::english(row.reason()))},
            {"blocking", row.blocking()},
            {"score", orNull(score)}};
  if (!row.combination.cell.empty())
    json["cell"] = base::dataName(row.combination.cell);
  for (const Figure& figure : figures())
    json[std::string(figure.key)] = number(figure.of(row), figure.unit.empty());
  json["growthLayers"] = d.layers > 0 ? Json(d.layers) : Json();
  json["uniformMisses"] = number(uniformMisses(row), true);
  json["replayPassed"] = orNull(replayPassed(row));
  json["reached"] = row.reached ? Json(project::stageName(*row.reached)) : Json();
  json["seconds"] = row.seconds;
  json["folder"] = files.folder;
  json["pictures"] = files.pictures;
  return json;
}

} // namespace

std::string compareJson(const Comparison& comparison, const Weights& weights,
                        const std::vector<RowFiles>& files) {
  base::require(files.size() == comparison.rows.size(), "compareJson: files of every row");
  const Ranking ranking = rank(comparison.rows, weights);
  Json weightsJson = Json::object();
  for (const Figure& figure : figures()) {
    const auto set = weights.find(figure.key);
    weightsJson[std::string(figure.key)] = set == weights.end() ? figure.weight : set->second;
  }
  Json rows = Json::array();
  for (std::size_t i = 0; i < comparison.rows.size(); ++i)
    rows.push_back(rowJson(i, comparison.rows[i], ranking.score[i], files[i]));
  const project::Choices& c = comparison.choices;
  const Json all{{"part", comparison.part},
                 {"cell", base::dataName(c.cell)},
                 {"process", base::dataName(c.tool().process)},
                 {"scale", c.item().scale},
                 {"until", project::stageName(comparison.until)},
                 {"threads", comparison.threads},
                 {"seconds", comparison.seconds},
                 {"version", project::kVersion},
                 {"rule", {{"text", ruleText(weights)}, {"weights", weightsJson}}},
                 {"best", ranking.best ? Json(*ranking.best + 1) : Json()},
                 {"tied", numbersOf(ranking.tied)},
                 {"ranking", numbersOf(ranking.order)},
                 {"rows", rows}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string rowFolder(std::size_t index, const Combination& combination) {
  return fmt::format("{}-{}{}{}", index + 1, combination.mode,
                     combination.growth ? "-" + combination.growth->id() : std::string(),
                     combination.cell.empty() ? std::string()
                                              : "-" + base::dataName(combination.cell));
}

std::string_view stateName(RowState state) {
  switch (state) {
  case RowState::Clear:
    return "clear";
  case RowState::Blocked:
    return "blocked";
  case RowState::Failed:
    break;
  }
  return "failed";
}

} // namespace voluta::pipeline
