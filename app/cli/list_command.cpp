#include "base/nearest_name.h"
#include "cli/commands.h"
#include "modes/mode_table.h"
#include "pipeline/presets/print_preset.h"
#include "pipeline/stage_options.h"
#include "process/library.h"
#include "program/dialect.h"
#include "project/choices.h"
#include "project/part_formats.h"
#include "robot/cell.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <nlohmann/json.hpp>

namespace voluta::cli {

namespace {
using Json = nlohmann::ordered_json;

Json listModes() {
  Json rows = Json::array();
  for (const modes::Mode& mode : modes::modeTable())
    rows.push_back(Json{{"id", mode.id}, {"label", base::english(mode.label)}});
  return rows;
}

Json listCells() {
  Json rows = Json::array();
  for (const std::string& id : robot::cellIds()) {
    const robot::Cell cell =
        robot::loadCell(id, process::loadProcess(project::Choices().tool().process),
                        {{-40, -40}, {40, -40}, {40, 40}, {-40, 40}});
    rows.push_back(Json{{"id", id}, {"label", cell.label()}, {"robot", cell.robot().id}});
  }
  return rows;
}

Json listRobots() {
  Json rows = Json::array();
  for (const std::string& id : robot::robotIds()) {
    const robot::RobotModel model = robot::loadRobot(id);
    rows.push_back(Json{{"id", id},
                        {"label", model.label},
                        {"maker", model.maker},
                        {"controller", model.controller},
                        {"assumed", model.assumed}});
  }
  return rows;
}

Json listFormats() {
  Json rows = Json::array();
  for (const program::Dialect& dialect : program::dialects()) {
    Json options = Json::array(); // Keys of parameters
    for (const base::ParameterSpec& option : program::optionsOf(dialect))
      options.push_back(option.key);
    rows.push_back(Json{{"id", dialect.id},
                        {"label", base::english(dialect.label)},
                        {"extension", dialect.extension},
                        {"options", std::move(options)}});
  }
  return rows;
}

Json listParts() {
  Json rows = Json::array();
  for (const project::PartFormat& format : project::partFormats())
    rows.push_back(Json{
        {"id", format.ending}, {"label", format.name}, {"holds", base::english(format.holds)}});
  return rows;
}

Json listProcesses() {
  Json rows = Json::array();
  for (const std::string& id : process::processIds()) {
    const bool own = !process::comesWithProgram(process::Shelf::Processes, id);
    const std::string label = process::labelOrProblem(process::Shelf::Processes, id);
    rows.push_back(Json{{"id", id}, {"label", label}, {"own", own}});
  }
  return rows;
}

Json listMaterials() {
  Json rows = Json::array();
  for (const std::string& id : process::materialIds()) {
    const process::Material m = process::loadMaterial(id);
    Json row{{"id", id},
             {"label", m.label},
             {"densityGPerCm3", m.densityGPerCm3},
             {"fan", m.fan},
             {"pricePerKg", m.pricePerKg},
             {"colour", m.colour},
             {"own", !m.comesWithProgram}};
    if (m.nozzleC)
      row["nozzleC"] = *m.nozzleC;
    if (m.bedC)
      row["bedC"] = *m.bedC;
    rows.push_back(std::move(row));
  }
  return rows;
}

Json listPresets() {
  Json rows = Json::array();
  for (const std::string& id : pipeline::presetIds()) {
    Json row{{"id", id}, {"label", ""}, {"own", !pipeline::presetComesWithProgram(id)}};
    try {
      const pipeline::PrintPreset preset = pipeline::loadPreset(id);
      row["label"] = preset.label;
      row["parent"] = preset.parent;
      row["settings"] = pipeline::presetSettings(preset);
    } catch (const base::Error& error) {
      row["label"] = error.what();
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Json valueJson(const base::ParameterValue& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

Json listParameters() {
  const std::vector<std::string> types{"number", "integer", "boolean", "choice", "text"};
  const base::ParameterTable table = pipeline::allParameters();
  Json rows = Json::array();
  for (const base::ParameterSpec& spec : table.specs()) {
    Json row{{"id", spec.key},
             {"label", base::english(spec.label)},
             {"group", base::english(spec.group)},
             {"type", types[static_cast<std::size_t>(spec.type)]},
             {"unit", spec.unit},
             {"default", valueJson(spec.defaultValue)}};
    if (spec.type == base::ParameterType::Number || spec.type == base::ParameterType::Integer) {
      row["min"] = spec.minimum;
      row["max"] = spec.maximum;
    }
    for (const base::Choice& choice : spec.choices)
      row["choices"].push_back(choice.id);
    row["simple"] = spec.simple;
    row["help"] = base::english(spec.help);
    rows.push_back(std::move(row));
  }
  return rows;
}

struct Listing {
  std::string_view what;
  Json (*rows)();
};
constexpr Listing kListings[] = {{"modes", listModes},           {"cells", listCells},
                                 {"robots", listRobots},         {"formats", listFormats},
                                 {"processes", listProcesses},   {"materials", listMaterials},
                                 {"presets", listPresets},       {"parameters", listParameters},
                                 {"parts", listParts}};

std::string materialText(const Json& row) {
  std::string text = fmt::format(", {} g/cm3", row.at("densityGPerCm3").get<double>());
  if (row.contains("nozzleC"))
    text += fmt::format(", nozzle {} °C", row.at("nozzleC").get<int>());
  if (row.contains("bedC"))
    text += fmt::format(", bed {} °C", row.at("bedC").get<int>());
  text += fmt::format(", fan {:.0f} %", 100.0 * row.at("fan").get<double>());
  if (const double price = row.at("pricePerKg").get<double>(); price > 0.0)
    text += fmt::format(", {} per kg", price);
  return text;
}

std::string textOf(const Json& row) {
  std::string text =
      fmt::format("{:<18} {}", row.at("id").get<std::string>(), row.at("label").get<std::string>());
  if (row.contains("default"))
    text += fmt::format(" = {} {}", row.at("default").dump(), row.at("unit").get<std::string>());
  if (row.contains("densityGPerCm3"))
    text += materialText(row);
  if (row.contains("min"))
    text += fmt::format(" [{} to {}]", row.at("min").dump(), row.at("max").dump());
  if (row.contains("holds"))
    text += ": " + row.at("holds").get<std::string>();
  if (row.contains("choices"))
    text += " " + row.at("choices").dump();
  return text;
}
} // namespace

std::vector<std::string> listedKinds() {
  std::vector<std::string> kinds;
  for (const Listing& listing : kListings)
    kinds.emplace_back(listing.what);
  return kinds;
}

ExitCode listCommand(const ListOptions& options) {
  for (const Listing& listing : kListings) {
    if (options.what != listing.what)
      continue;
    const Json rows = listing.rows();
    if (options.json) {
      fmt::print("{}\n", rows.dump(2));
      return kDone;
    }
    for (const Json& row : rows)
      fmt::print("{}\n", textOf(row));
    return kDone;
  }
  throw base::Error(base::ErrorCode::Usage,
                    base::message("cannot list '{what}'"_text, options.what), {},
                    base::didYouMean(options.what, listedKinds()));
}

} // namespace voluta::cli
