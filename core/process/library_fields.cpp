#include "process/library_fields.h"

#include "base/error.h"
#include "base/shown_number.h"
#include "process/process_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <locale>
#include <sstream>

namespace voluta::process {

namespace {
using base::ParameterSpec;
using base::ParameterValue;

constexpr double kMaxGPerCm3 = 30.0, kMaxC = 1000.0, kHottestBedC = 250.0;
constexpr double kMaxPrice = 1e6, kMaxMm = 1000.0, kMaxMm3PerS = 1e7, kMaxBridgeWidths = 1000.0;

Process& processOf(LibraryItem& item) {
  return std::get<Process>(item.data);
}
const Process& processOf(const LibraryItem& item) {
  return std::get<Process>(item.data);
}
Material& materialOf(LibraryItem& item) {
  return std::get<Material>(item.data);
}
const Material& materialOf(const LibraryItem& item) {
  return std::get<Material>(item.data);
}

LibraryField labelField() {
  return {
      base::textParameter("label", "Name"_text, "label"_text, "Shown in lists and reports."_text),
      [](const LibraryItem& item) { return ParameterValue(item.label()); },
      [](LibraryItem& item, const ParameterValue& value) {
        item = item.named(item.id(), std::get<std::string>(value));
      }};
}

LibraryField numberField(const ProcessNumber& row) {
  return {base::numberParameter(std::string(row.key), std::string(row.unit),
                                std::max(0.0, row.minimum), row.minimum, row.maximum, row.group,
                                row.label, row.help),
          [at = row.value](const LibraryItem& item) { return ParameterValue(processOf(item).*at); },
          [at = row.value](LibraryItem& item, const ParameterValue& value) {
            processOf(item).*at = std::get<double>(value);
          }};
}

LibraryField featureField(const FeatureNumber& row) {
  const bool isFlow = row.value == &FeatureSettings::flow;
  return {base::numberParameter(
              "features." + std::string(row.featureKey) + "." + std::string(row.key),
              std::string(row.unit), 0.0, row.minimum, row.maximum, "Features"_text, row.label,
              isFlow ? "Factor of the bead's section."_text : "0: as in the process."_text),
          [row](const LibraryItem& item) {
            return ParameterValue(processOf(item).features.of(row.feature).*row.value);
          },
          [row](LibraryItem& item, const ParameterValue& value) {
            processOf(item).features.of(row.feature).*row.value = std::get<double>(value);
          },
          isFlow ? base::Text() : "as in the process"_text};
}

// A process's material: one of the library, or the one that the process has already.
LibraryField materialField(const Process& process) {
  std::vector<base::Choice> choices;
  for (const std::string& id : materialIds())
    choices.push_back({id, {}});
  if (std::ranges::find(choices, process.material.id, &base::Choice::id) == choices.end())
    choices.push_back({process.material.id, {}});
  return {base::choiceParameter("material", process.material.id, std::move(choices),
                                "Material"_text, "material"_text,
                                "Material that the process prints."_text),
          [](const LibraryItem& item) { return ParameterValue(processOf(item).material.id); },
          [own = process.material](LibraryItem& item, const ParameterValue& value) {
            const auto& id = std::get<std::string>(value);
            processOf(item).material = id == own.id ? own : loadMaterial(id);
          }};
}

LibraryField densityField(base::Text group, Material& (*of)(LibraryItem&)) {
  return {base::numberParameter("densityGPerCm3", "g/cm³", 0.0, 0.0, kMaxGPerCm3, group,
                                "density"_text, "Density of the printed material."_text),
          [of](const LibraryItem& item) {
            LibraryItem copy = item;
            return ParameterValue(of(copy).densityGPerCm3);
          },
          [of](LibraryItem& item, const ParameterValue& value) {
            of(item).densityGPerCm3 = std::get<double>(value);
          }};
}

LibraryField overhangField(std::size_t i) {
  static constexpr std::array kLabels{
      "speed of walls, 25 % overhang"_text, "speed of walls, 50 % overhang"_text,
      "speed of walls, 75 % overhang"_text, "speed of walls, 100 % overhang"_text};
  return {base::numberParameter("overhangSpeed[" + std::to_string(i) + "]", "", 1.0, 0.0, 1.0,
                                "Features"_text, kLabels[i],
                                "Share of the speed of a wall that overhangs the layer below by "
                                "that share of its width."_text),
          [i](const LibraryItem& item) {
            return ParameterValue(processOf(item).overhangSpeed.shares[i]);
          },
          [i](LibraryItem& item, const ParameterValue& value) {
            processOf(item).overhangSpeed.shares[i] = std::get<double>(value);
          }};
}

std::vector<LibraryField> processFields(const Process& process) {
  std::vector<LibraryField> fields{labelField()};
  for (const ProcessNumber& row : processNumbers())
    fields.push_back(numberField(row));
  fields.push_back(materialField(process));
  fields.push_back(densityField(
      "Material"_text, [](LibraryItem& item) -> Material& { return processOf(item).material; }));
  for (const FeatureNumber& row : featureNumbers())
    fields.push_back(featureField(row));
  for (std::size_t i = 0; i < OverhangSpeed().shares.size(); ++i)
    fields.push_back(overhangField(i));
  return fields;
}

LibraryField celsiusField(const char* key, int Material::*value, base::Text label,
                          base::Text help) {
  return {base::numberParameter(key, "°C", 0.0, 0.0, kMaxC, "Temperatures"_text, label, help),
          [value](const LibraryItem& item) {
            return ParameterValue(static_cast<double>(materialOf(item).*value));
          },
          [value](LibraryItem& item, const ParameterValue& typed) {
            materialOf(item).*value = static_cast<int>(std::lround(std::get<double>(typed)));
          }};
}

// A number that the material may have. `none`: the minimum's word.
template <typename T>
LibraryField optionalField(ParameterSpec spec, std::optional<T> Material::*value, base::Text none) {
  const double minimum = spec.minimum;
  return {std::move(spec),
          [value, minimum](const LibraryItem& item) {
            const std::optional<T>& has = materialOf(item).*value;
            return ParameterValue(has ? static_cast<double>(*has) : minimum);
          },
          [value, minimum](LibraryItem& item, const ParameterValue& typed) {
            const double number = std::get<double>(typed);
            std::optional<T>& has = materialOf(item).*value;
            if (number <= minimum)
              has = std::nullopt;
            else if constexpr (std::is_integral_v<T>)
              has = static_cast<T>(std::lround(number));
            else
              has = number;
          },
          none};
}

LibraryField materialNumber(ParameterSpec spec, double Material::*value) {
  return {std::move(spec),
          [value](const LibraryItem& item) { return ParameterValue(materialOf(item).*value); },
          [value](LibraryItem& item, const ParameterValue& typed) {
            materialOf(item).*value = std::get<double>(typed);
          }};
}

LibraryField materialText(ParameterSpec spec, std::string Material::*value) {
  return {std::move(spec),
          [value](const LibraryItem& item) { return ParameterValue(materialOf(item).*value); },
          [value](LibraryItem& item, const ParameterValue& typed) {
            materialOf(item).*value = std::get<std::string>(typed);
          }};
}

// "0.45, 20; 1.2, 12"
std::string bridgesText(const std::vector<BridgedLength>& bridges) {
  std::string text;
  for (const BridgedLength& one : bridges)
    text += fmt::format("{}{:.6g}, {:.6g}", text.empty() ? "" : "; ", one.widthMm, one.lengthMm);
  return text;
}

// A pair that cannot be read is no number, which the reader of the file reports.
std::vector<BridgedLength> bridgesOf(const std::string& text) {
  std::vector<BridgedLength> bridges;
  std::istringstream pairs(text);
  for (std::string pair; std::getline(pairs, pair, ';');) {
    std::istringstream numbers(pair);
    numbers.imbue(std::locale::classic());
    BridgedLength one;
    char comma = 0, more = 0;
    if (!(numbers >> one.widthMm >> comma >> one.lengthMm) || comma != ',' || numbers >> more)
      one.widthMm = one.lengthMm = NAN;
    bridges.push_back(one);
  }
  return bridges;
}

std::vector<LibraryField> temperatureFields() {
  return {optionalField(base::numberParameter("nozzleC.default", "°C", 0.0, 0.0, kMaxC,
                                              "Temperatures"_text, "nozzle temperature"_text,
                                              "Usual temperature of the nozzle."_text),
                        &Material::nozzleC, "unknown"_text),
          celsiusField("nozzleC.min", &Material::nozzleMinC, "minimum nozzle temperature"_text,
                       "Colder nozzles do not print it."_text),
          celsiusField("nozzleC.max", &Material::nozzleMaxC, "maximum nozzle temperature"_text,
                       "Hotter nozzles damage it."_text),
          optionalField(base::numberParameter("bedC", "°C", 0.0, -1.0, kHottestBedC,
                                              "Temperatures"_text, "plate temperature"_text,
                                              "Usual temperature of the plate."_text),
                        &Material::bedC, "unknown"_text)};
}

std::vector<LibraryField> materialFields() {
  std::vector<LibraryField> fields{
      labelField(), densityField("Material"_text,
                                 [](LibraryItem& item) -> Material& { return materialOf(item); })};
  for (LibraryField& field : temperatureFields())
    fields.push_back(std::move(field));
  fields.push_back(
      materialNumber(base::numberParameter("fan", "", 0.0, 0.0, 1.0, "Cooling"_text, "fan"_text,
                                           "Part cooling from the second layer on, 0 to 1."_text),
                     &Material::fan));
  fields.push_back(optionalField(base::numberParameter("bridgeFan", "", 0.0, -1.0, 1.0,
                                                       "Cooling"_text, "fan on bridges"_text,
                                                       "Part cooling of bridges, 0 to 1."_text),
                                 &Material::bridgeFan, "as elsewhere"_text));
  fields.push_back(
      optionalField(base::numberParameter("maxFlowMm3PerS", "mm³/s", 0.0, 0.0, kMaxMm3PerS,
                                          "Limits"_text, "maximum flow"_text,
                                          "Melted at most, whatever the process allows."_text),
                    &Material::maxFlowMm3PerS, "any"_text));
  fields.push_back(materialNumber(
      base::numberParameter("bridgeWidths", "", 0.0, 0.0, kMaxBridgeWidths, "Limits"_text,
                            "bridge length in bead widths"_text,
                            "Length that a bead bridges, unless the process states it."_text),
      &Material::bridgeWidths));
  fields.push_back(optionalField(base::numberParameter("bridgeMm", "mm", 0.0, -1.0, kMaxMm,
                                                       "Limits"_text, "longest bridge"_text,
                                                       "Whatever the process allows."_text),
                                 &Material::bridgeMm, "any"_text));
  fields.push_back(
      {base::textParameter("bridges", "Limits"_text, "bridges with a little sag"_text,
                           "Bead width, length that it bridges with a sag of up to 0.2 mm; and so "
                           "on, in mm. Quality usual and draft accept it. Those of the program's "
                           "materials are estimates: replace them by those of a test print."_text),
       [](const LibraryItem& item) {
         return ParameterValue(bridgesText(materialOf(item).bridges));
       },
       [](LibraryItem& item, const ParameterValue& typed) {
         materialOf(item).bridges = bridgesOf(std::get<std::string>(typed));
       }});
  fields.push_back(
      optionalField(base::numberParameter("minLayerTimeS", "s", 0.0, 0.0, 3600.0,
                                          "Layer times"_text, "minimum layer time"_text,
                                          "Time that a bead needs before the next layer covers "
                                          "it, unless the job states it."_text),
                    &Material::minLayerTimeS, "any"_text));
  fields.push_back(
      optionalField(base::numberParameter("maxLayerTimeS", "s", 0.0, 0.0, 36000.0,
                                          "Layer times"_text, "maximum layer time"_text,
                                          "Age up to which a bead bonds with the next layer, "
                                          "unless the job states it."_text),
                    &Material::maxLayerTimeS, "any"_text));
  fields.push_back(materialNumber(base::numberParameter("pricePerKg", "", 0.0, 0.0, kMaxPrice,
                                                        "Other"_text, "price per kg"_text,
                                                        "In your currency. 0: unknown."_text),
                                  &Material::pricePerKg));
  fields.push_back(materialText(
      base::textParameter("colour", "Other"_text, "colour"_text, "#RRGGBB, for the view."_text),
      &Material::colour));
  fields.push_back(materialText(base::textParameter("notes", "Other"_text, "notes"_text,
                                                    "For people, for example how to dry it."_text),
                                &Material::notes));
  return fields;
}

// Returns the key of the field that a key in the file belongs to.
std::string fieldKey(const LibraryItem& item, std::string key) {
  constexpr std::string_view kOwnMaterial = "ownMaterial.";
  if (key.starts_with(kOwnMaterial))
    key.erase(0, kOwnMaterial.size());
  if (key.starts_with("head"))
    return "head";
  if (key.starts_with("bridges["))
    return "bridges";
  for (const LibraryField& field : libraryFields(item))
    if (field.spec.key == key || field.spec.key == key + ".default")
      return field.spec.key;
  return {};
}
} // namespace

std::vector<LibraryField> libraryFields(const LibraryItem& item) {
  return item.process() ? processFields(*item.process()) : materialFields();
}

std::optional<FieldProblem> problemOf(const LibraryItem& item) {
  try {
    readItem(item.shelf(), itemText(item), item.id());
    return std::nullopt;
  } catch (const base::Error& error) {
    const std::vector<base::Value>& values = error.message().values;
    const auto* key =
        values.size() == 2 ? std::get_if<std::string>(&values.front().data()) : nullptr;
    const std::string field = key ? fieldKey(item, *key) : std::string();
    return FieldProblem{field, field.empty() ? base::Value(error.message()) : values.back()};
  }
}

std::string headText(const HeadShape& head) {
  std::string text;
  for (const HeadSection& section : head.sections)
    text +=
        fmt::format("{}{:.6g}, {:.6g}", text.empty() ? "" : "; ", section.zMm, section.radiusMm);
  return text;
}

std::vector<FieldDifference> differences(const LibraryItem& first, const LibraryItem& second) {
  base::require(first.shelf() == second.shelf(), "differences: of the same shelf");
  std::vector<FieldDifference> all;
  for (const LibraryField& field : libraryFields(first))
    if (const auto a = field.get(first), b = field.get(second); a != b)
      all.push_back({field.spec, field.none, a, b});
  if (!first.process())
    return all;
  const std::string a = headText(first.process()->head), b = headText(second.process()->head);
  if (a != b)
    all.push_back({base::textParameter("head", "Head"_text, "head"_text,
                                       "Height and radius of its sections, in mm."_text),
                   {},
                   a,
                   b});
  return all;
}

} // namespace voluta::process
