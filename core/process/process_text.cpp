#include "process/process_text.h"

#include "process/bead_model.h"
#include "process/process_numbers.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

namespace voluta::process {

namespace {
using Json = nlohmann::ordered_json;

void writeNumbers(const Process& p, Json& json) {
  for (const ProcessNumber& row : processNumbers()) {
    if ((p.tape && isOfTape(row)) || (row.omitDefault && p.*row.value == Process().*row.value))
      continue;
    const std::size_t dot = row.key.find('.');
    Json& node =
        dot == std::string_view::npos
            ? json[std::string(row.key)]
            : json[std::string(row.key.substr(0, dot))][std::string(row.key.substr(dot + 1))];
    node = p.*row.value;
  }
}

// Returns whether the process's file can state the material by its name and density alone.
bool isNamed(const Material& material) {
  if (material.comesWithProgram)
    return true;
  Material named = materialNamed(material.label);
  const bool hasFile = named.densityGPerCm3 > 0.0;
  named.densityGPerCm3 = material.densityGPerCm3;
  return !hasFile && named == material;
}

void writeMaterial(const Material& material, Json& json) {
  json["material"] = material.comesWithProgram ? material.id : material.label;
  if (isNamed(material))
    json["densityGPerCm3"] = material.densityGPerCm3;
  else
    json["ownMaterial"] = Json::parse(materialText(material));
}

void writeTape(const Process& p, Json& json) {
  const Tape& tape = *p.tape;
  json["material"] = p.material.label;
  json["tape"] = {{"widthMm", tape.widthMm},
                  {"thicknessMm", tape.thicknessMm},
                  {"leastLengthMm", tape.minLengthMm},
                  {"leastBendRadiusMm", tape.minBendRadiusMm},
                  {"cutAheadMm", tape.cutAheadMm},
                  {"ironSpeedMmPerS", p.speedMmPerS},
                  {"densityGPerCm3", p.material.densityGPerCm3}};
  if (tape.fibreMPa > 0.0)
    json["tape"]["fibreMPa"] = tape.fibreMPa;
  if (tape.fibreShare > 0.0)
    json["tape"]["fibreShare"] = tape.fibreShare;
}

// The file states the widths of single beads.
void writeOverlap(const Process& p, Json& json) {
  constexpr double kDigits = 1e9; // As many as a file has, so that it is read back unchanged
  json["overlapFactor"] = p.overlapFactor;
  for (auto& [key, width] : json["beadWidthMm"].items())
    width = std::round(kDigits * hatchOf(width.get<double>(), p.layerHeightMm) / p.overlapFactor) /
            kDigits;
}

void writeMachineLaws(const Process& p, Json& json) {
  if (p.lag.startS > 0.0)
    json["startLagS"] = p.lag.startS;
  if (p.lag.stopS > 0.0)
    json["stopLagS"] = p.lag.stopS;
  if (p.overlapFactor != 1.0)
    writeOverlap(p, json);
  for (const BeadWords& words : p.beadWords)
    json["beadWords"].push_back(
        {{"format", words.format}, {"start", words.start}, {"end", words.end}});
}

void writeFeatures(const FeatureTable& features, Json& json) {
  const FeatureSettings neutral;
  for (const FeatureNumber& row : featureNumbers())
    if (const double value = features.of(row.feature).*row.value; value != neutral.*row.value)
      json["features"][std::string(row.featureKey)][std::string(row.key)] = value;
}

// Returns the text with the head in one line, as in the files that come with the program.
std::string dumped(Json json, const HeadShape& head) {
  constexpr std::string_view kPlace = "\n  \"head\": null";
  Json list = Json::array();
  for (const HeadSection& section : head.sections)
    list.push_back({section.zMm, section.radiusMm});
  json["head"] = nullptr;
  std::string text = json.dump(2) + "\n";
  const std::size_t at = text.find(kPlace); // No other: texts have no line breaks of their own
  return text.replace(at, kPlace.size(), "\n  \"head\": " + list.dump());
}
} // namespace

std::string processText(const Process& process) {
  Json json = {{"id", process.id}, {"label", process.label}};
  writeNumbers(process, json);
  if (process.tape)
    writeTape(process, json);
  else
    writeMaterial(process.material, json);
  writeMachineLaws(process, json);
  writeFeatures(process.features, json);
  if (process.overhangSpeed != OverhangSpeed())
    json["overhangSpeed"] = process.overhangSpeed.shares;
  return dumped(std::move(json), process.head);
}

bool sameProcess(const Process& a, const Process& b) {
  if (a.id != b.id || a.label != b.label || !(a.material == b.material) || a.tape != b.tape ||
      a.lag != b.lag || a.overhangSpeed != b.overhangSpeed || a.overlapFactor != b.overlapFactor ||
      a.beadWords != b.beadWords)
    return false;
  for (const ProcessNumber& row : processNumbers())
    if (a.*row.value != b.*row.value)
      return false;
  for (const FeatureNumber& row : featureNumbers())
    if (a.features.of(row.feature).*row.value != b.features.of(row.feature).*row.value)
      return false;
  return std::ranges::equal(a.head.sections, b.head.sections,
                            [](const HeadSection& one, const HeadSection& other) {
                              return one.zMm == other.zMm && one.radiusMm == other.radiusMm;
                            });
}

} // namespace voluta::process
