#include "cli/batch_page.h"

#include "base/duration.h"
#include "base/markup.h"
#include "base/text.h"
#include "cli/exit_code.h"
#include "cli/verdict_words.h"
#include "pipeline/plan_verdict.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

namespace voluta::cli {

namespace {
using Json = nlohmann::ordered_json;
using base::escapedMarkup;

constexpr const char* kStyle =
    "body{font:10pt/1.4 'DejaVu Sans',Verdana,Arial,sans-serif;color:#1c232b;margin:8mm}"
    "table{border-collapse:collapse}th,td{padding:1mm 3mm;text-align:left;vertical-align:top}"
    "th{border-bottom:.4mm solid #5d6773}td{border-top:.2mm solid #d4dae0}"
    ".number{text-align:right;white-space:nowrap}.best{font-weight:bold;color:#1b6b4a}"
    ".passed{background:#e7f3ed}.amber{background:#fbf1dc}.refused{background:#f9e8e8}"
    ".reason,p{color:#5d6773}";

struct Figure {
  const char* title;
  const char* key; // in the row
  double factor;
  const char* unit;
  int decimals;
  bool leastIsBest;
};
constexpr Figure kFigures[] = {{"Material", "materialMm3", 1e-3, "cm³", 2, true},
                               {"Layers", "layers", 1.0, "", 0, false},
                               {"Covered", "coveredFraction", 1e2, "%", 1, false},
                               {"Unsupported", "unsupportedFraction", 1e2, "%", 1, false},
                               {"Overfill", "overfillFraction", 1e2, "%", 1, false},
                               {"Collisions", "collisions", 1.0, "", 0, false},
                               {"Findings", "findings", 1.0, "", 0, false}};
constexpr Figure kTime{"Time", "durationS", 1.0, "", 0, true};

bool passed(const Json& row) {
  return row.at("exitCode") == kDone &&
         row.at("verdict") == pipeline::verdictId(pipeline::PlanVerdict::Passed);
}

struct Outcome {
  const char* style;
  std::string words;
};
Outcome outcomeOf(const Json& row) {
  if (row.at("exitCode").is_null())
    return {"refused", "not planned"};
  if (passed(row))
    return {"passed", "passed"};
  if (row.at("exitCode") == kDone)
    return {"amber", "not verified"};
  if (row.at("exitCode") == kNotAll &&
      row.at("verdict") == pipeline::verdictId(pipeline::PlanVerdict::NotAsAsked))
    return {"amber", "safe to run, not as asked"};
  if (row.at("exitCode") == kNotAll &&
      row.at("verdict") == pipeline::verdictId(pipeline::PlanVerdict::Unchecked))
    return {"amber", verdictWords(pipeline::PlanVerdict::Unchecked)};
  return {"refused", row.at("verdict").is_null() ? "not planned" : "refused"};
}

// Least value by part and key, of the jobs that passed; of parts with several of them.
std::map<std::pair<std::string, std::string>, double> bestOf(const Json& rows) {
  std::map<std::pair<std::string, std::string>, std::pair<double, int>> least;
  for (const Json& row : rows)
    for (const char* key : {kTime.key, kFigures[0].key})
      if (passed(row) && row.at(key).is_number()) {
        auto& [value, count] = least
                                   .try_emplace({row.at("part").get<std::string>(), key},
                                                std::numeric_limits<double>::infinity(), 0)
                                   .first->second;
        value = std::min(value, row.at(key).get<double>());
        ++count;
      }
  std::map<std::pair<std::string, std::string>, double> best;
  for (const auto& [place, value] : least)
    if (value.second > 1)
      best.emplace(place, value.first);
  return best;
}

std::string shown(const Figure& figure, const Json& value) {
  if (!value.is_number())
    return {};
  const double number = figure.factor * value.get<double>();
  if (figure.key == kTime.key)
    return base::english(base::duration(number));
  return fmt::format("{:.{}f}{}{}", number, figure.decimals, *figure.unit ? " " : "", figure.unit);
}

std::string wordsOf(const Json& value) {
  return value.is_null()     ? std::string()
         : value.is_string() ? value.get<std::string>()
                             : value.dump();
}
} // namespace

std::string batchPage(const Json& rows, const std::vector<std::string>& settings) {
  const auto best = bestOf(rows);
  const auto passedCount = std::ranges::count_if(rows, passed);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Batch</title>"
      "<style>{}</style></head><body>\n<h1>{} of {} jobs passed</h1>\n",
      kStyle, passedCount, rows.size());
  page += "<p>Green figures: the least of the jobs of one part that passed.</p>\n<table>\n<tr>"
          "<th>Part</th><th>Job</th>";
  for (const std::string& setting : settings)
    page += "<th>" + escapedMarkup(setting) + "</th>";
  page += "<th>Outcome</th><th>Mode</th>";
  const auto head = [&](const Figure& figure) {
    page += fmt::format("<th class=\"number\">{}</th>", figure.title);
  };
  head(kTime);
  std::ranges::for_each(kFigures, head);
  page += "<th>Reason</th></tr>\n";
  std::vector<const Json*> byPart;
  for (const Json& row : rows)
    byPart.push_back(&row);
  std::ranges::stable_sort(byPart, {},
                           [](const Json* row) { return row->at("part").get<std::string>(); });
  std::string part;
  for (const Json* row : byPart) {
    const std::string path = row->at("part").get<std::string>(), job = wordsOf(row->at("job"));
    const Outcome outcome = outcomeOf(*row);
    const std::string name = std::filesystem::path(path).filename().string();
    page += fmt::format("<tr class=\"{}\"><td title=\"{}\">{}</td><td>", outcome.style,
                        escapedMarkup(path), path == part ? "" : escapedMarkup(name));
    page += row->at("verdict").is_null()
                ? escapedMarkup(job)
                : fmt::format("<a href=\"jobs/{0}\">{0}</a>", escapedMarkup(job));
    page += "</td>";
    part = path;
    for (const std::string& setting : settings)
      page +=
          "<td>" + escapedMarkup(row->contains(setting) ? wordsOf(row->at(setting)) : "") + "</td>";
    page += "<td>" + outcome.words + "</td><td>" + escapedMarkup(wordsOf(row->at("plannedMode"))) +
            "</td>";
    const auto cell = [&](const Figure& figure) {
      const Json& value = row->at(figure.key);
      const auto least = best.find({path, figure.key});
      const bool isBest = figure.leastIsBest && passed(*row) && least != best.end() &&
                          value.is_number() && value.get<double>() <= least->second;
      page += fmt::format("<td class=\"number{}\">{}</td>", isBest ? " best" : "",
                          escapedMarkup(shown(figure, value)));
    };
    cell(kTime);
    std::ranges::for_each(kFigures, cell);
    page += "<td class=\"reason\">" + escapedMarkup(wordsOf(row->at("reason"))) + "</td></tr>\n";
  }
  return page + "</table>\n</body></html>\n";
}

} // namespace voluta::cli
