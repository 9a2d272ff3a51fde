#include "process/material.h"

#include "base/data_files.h"
#include "base/files.h"
#include "base/json_node.h"
#include "base/lower_case.h"
#include "process/chosen_range.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace voluta::process {

namespace {
using base::JsonNode;

constexpr const char* kFolder = "materials";                // of base::dataFile()
constexpr int kColdestNozzleC = 100, kHottestNozzleC = 450; // that print heads withstand

bool isColour(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(),
                     [](unsigned char c) { return std::isxdigit(c) != 0; });
}

void readNozzle(const JsonNode& node, Material& m) {
  const ChosenRange range = readRange(node);
  m.nozzleC = static_cast<int>(range.usual);
  m.nozzleMinC = static_cast<int>(range.least);
  m.nozzleMaxC = static_cast<int>(range.most);
}

Material loadFile(const std::filesystem::path& file) {
  Material m = readMaterialText(base::readFile(file), file.string());
  m.comesWithProgram = file.parent_path() == base::resourceFolder() / kFolder;
  return m;
}
} // namespace

bool prints(const Material& material, double nozzleC) {
  return nozzleC >= material.nozzleMinC && nozzleC <= material.nozzleMaxC;
}

Material readMaterialText(const std::string& text, const std::string& name) {
  const JsonNode top = JsonNode::parse(text, name);
  top.allowOnly({"id", "label", "densityGPerCm3", "nozzleC", "bedC", "fan", "bridgeWidths",
                 "pricePerKg", "colour"});
  Material m;
  m.id = top.at("id").text();
  m.label = top.at("label").text();
  m.densityGPerCm3 = top.at("densityGPerCm3").positive();
  readNozzle(top.at("nozzleC"), m);
  m.bedC = static_cast<int>(top.at("bedC").notNegative());
  m.fan = top.at("fan").notNegative();
  if (m.fan > 1.0)
    top.at("fan").fail("is above 1"_text);
  m.bridgeWidths = top.at("bridgeWidths").notNegative();
  m.pricePerKg = top.at("pricePerKg").notNegative();
  m.colour = top.at("colour").text();
  if (!isColour(m.colour))
    top.at("colour").fail("must be #RRGGBB"_text);
  m.comesWithProgram = false;
  return m;
}

std::vector<std::string> materialIds() {
  return base::dataFileIds(kFolder);
}

Material loadMaterial(const std::string& id) {
  return loadFile(base::dataFile(kFolder, id, "unknown material '{id}'"_text));
}

Material materialNamed(const std::string& name) {
  const std::string wanted = base::lowerCase(name);
  for (const std::string& id : materialIds())
    if (base::lowerCase(id) == wanted)
      return loadMaterial(id);
  Material unknown;
  unknown.id = unknown.label = name;
  unknown.densityGPerCm3 = 0.0;
  unknown.nozzleC = unknown.bedC = std::nullopt;
  unknown.nozzleMinC = kColdestNozzleC;
  unknown.nozzleMaxC = kHottestNozzleC;
  unknown.pricePerKg = 0.0;
  unknown.comesWithProgram = false;
  return unknown;
}

} // namespace voluta::process
