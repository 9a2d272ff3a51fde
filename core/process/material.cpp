#include "process/material.h"

#include "base/data_files.h"
#include "base/files.h"
#include "base/inherited_text.h"
#include "base/json_node.h"
#include "base/lower_case.h"
#include "process/chosen_range.h"
#include "process/material_node.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace voluta::process {

namespace {
using base::JsonNode;

constexpr const char* kFolder = "materials";                // of base::dataFile()
constexpr int kColdestNozzleC = 100, kHottestNozzleC = 450; // that print heads withstand
constexpr double kMinNozzleC = 1.0, kMaxNozzleC = 1000.0;   // Of any material
constexpr double kHottestBedC = 250.0;
constexpr double kOldBridgeWidthMm = 0.45; // that older files state a single length for
constexpr double kLongestMinS = 3600.0, kLongestMaxS = 36000.0; // as the parameters of a job

bool isColour(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(),
                     [](unsigned char c) { return std::isxdigit(c) != 0; });
}

void readNozzle(const JsonNode& node, Material& m) {
  const ChosenRange range = readRange(node);
  if (range.minimum < kMinNozzleC)
    node.at("min").fail("is below 1"_text);
  if (range.maximum > kMaxNozzleC)
    node.at("max").fail("is above 1000"_text);
  m.nozzleC = static_cast<int>(range.usual);
  m.nozzleMinC = static_cast<int>(range.minimum);
  m.nozzleMaxC = static_cast<int>(range.maximum);
}

double readShare(const JsonNode& node) {
  const double share = node.notNegative();
  if (share > 1.0)
    node.fail("is above 1"_text);
  return share;
}

// Temperatures that no file states: any that heads withstand.
void forgetTemperatures(Material& m) {
  m.nozzleC = m.bedC = std::nullopt;
  m.nozzleMinC = kColdestNozzleC;
  m.nozzleMaxC = kHottestNozzleC;
}

void readTemperatures(const JsonNode& top, Material& m) {
  forgetTemperatures(m);
  if (top.has("nozzleC"))
    readNozzle(top.at("nozzleC"), m);
  if (!top.has("bedC"))
    return;
  const double bed = top.at("bedC").notNegative();
  if (bed > kHottestBedC)
    top.at("bedC").fail("is above 250"_text);
  m.bedC = static_cast<int>(bed);
}

constexpr double kMaxPoisson = 0.45; // Rubber has more

constexpr double kMaxMm = 1000.0; // More is a wrong unit

double readMm(const JsonNode& node) {
  const double mm = node.notNegative();
  if (mm > kMaxMm)
    node.fail("is above 1000 mm: check the unit"_text);
  return mm;
}

std::vector<BridgedLength> readBridges(const JsonNode& list) {
  std::vector<BridgedLength> bridges;
  for (const JsonNode& item : list.items()) {
    const std::vector<JsonNode> pair = item.items();
    if (pair.size() != 2)
      item.fail("must be a pair of bead width and length"_text);
    pair[0].positive();
    const BridgedLength one{readMm(pair[0]), readMm(pair[1])};
    if (!bridges.empty() && one.widthMm <= bridges.back().widthMm)
      item.fail("is not wider than the bead before it"_text);
    bridges.push_back(one);
  }
  return bridges;
}

void readLimits(const JsonNode& top, Material& m) {
  m.fan = top.has("fan") ? readShare(top.at("fan")) : 0.0;
  if (top.has("bridgeFan"))
    m.bridgeFan = readShare(top.at("bridgeFan"));
  if (top.has("maxFlowMm3PerS"))
    m.maxFlowMm3PerS = top.at("maxFlowMm3PerS").positive();
  if (top.has("bridgeWidths"))
    m.bridgeWidths = top.at("bridgeWidths").notNegative();
  if (top.has("bridgeMm"))
    m.bridgeMm = top.at("bridgeMm").notNegative();
  m.bridges.clear();
  if (top.has("bridges"))
    m.bridges = readBridges(top.at("bridges"));
  else if (top.has("bridgeSagMm")) // of older files
    m.bridges = {{kOldBridgeWidthMm, readMm(top.at("bridgeSagMm"))}};
}

double readLayerTime(const JsonNode& node, double longestS) {
  const double time = node.positive();
  if (time > longestS)
    node.fail(base::message("is above {limit:.0f}"_text, base::number(longestS)));
  return time;
}

void readLayerTimes(const JsonNode& top, Material& m) {
  if (top.has("minLayerTimeS"))
    m.minLayerTimeS = readLayerTime(top.at("minLayerTimeS"), kLongestMinS);
  if (top.has("maxLayerTimeS"))
    m.maxLayerTimeS = readLayerTime(top.at("maxLayerTimeS"), kLongestMaxS);
  if (m.minLayerTimeS && m.maxLayerTimeS && *m.minLayerTimeS > *m.maxLayerTimeS)
    top.at("minLayerTimeS").fail("is longer than maxLayerTimeS"_text);
}

Elasticity readElasticity(const JsonNode& node) {
  node.allowOnly({"alongMPa", "acrossMPa", "shearMPa", "poisson"});
  Elasticity e{.alongMPa = node.at("alongMPa").positive(),
               .acrossMPa = node.at("acrossMPa").positive(),
               .shearMPa = node.at("shearMPa").positive()};
  if (node.has("poisson"))
    e.poisson = node.at("poisson").notNegative();
  if (e.poisson > kMaxPoisson)
    node.at("poisson").fail(base::message("is above {limit}"_text, base::number(kMaxPoisson)));
  if (e.acrossMPa > e.alongMPa)
    node.at("acrossMPa").fail("is above 'alongMPa'"_text);
  return e;
}

void readLooks(const JsonNode& top, Material& m) {
  m.pricePerKg = top.has("pricePerKg") ? top.at("pricePerKg").notNegative() : 0.0;
  if (top.has("colour"))
    m.colour = top.at("colour").text();
  if (!isColour(m.colour))
    top.at("colour").fail("must be #RRGGBB"_text);
  if (top.has("notes"))
    m.notes = top.at("notes").text();
}

Material loadFile(const std::filesystem::path& file) {
  Material m = readMaterialText(base::readFile(file), file.string());
  m.comesWithProgram = file.parent_path() == base::resourceFolder() / kFolder;
  return m;
}
} // namespace

double readDensity(const JsonNode& node) {
  constexpr double kMaxGPerCm3 = 30.0; // Above all metals
  const double density = node.positive();
  if (density > kMaxGPerCm3)
    node.fail("is above 30 g/cm3: check the unit"_text);
  return density;
}

bool prints(const Material& material, double nozzleC) {
  return nozzleC >= material.nozzleMinC && nozzleC <= material.nozzleMaxC;
}

std::vector<BridgedLength> bridgesOfPla() {
  return {{0.45, 20.0}, {1.2, 12.0}, {4.8, 8.0}};
}

double bridgedMm(const Material& material, double beadWidthMm) {
  constexpr double kPower = -0.375;
  const std::vector<BridgedLength>& rows = material.bridges;
  if (rows.empty())
    return 0.0;
  const auto next = std::ranges::lower_bound(rows, beadWidthMm, {}, &BridgedLength::widthMm);
  if (next == rows.end())
    return rows.back().lengthMm * std::pow(beadWidthMm / rows.back().widthMm, kPower);
  if (next == rows.begin())
    return next->lengthMm;
  const BridgedLength& before = *(next - 1);
  return std::lerp(before.lengthMm, next->lengthMm,
                   (beadWidthMm - before.widthMm) / (next->widthMm - before.widthMm));
}

Material readMaterialText(const std::string& text, const std::string& name) {
  return readMaterialNode(JsonNode::parse(base::wholeText(kFolder, text, name), name));
}

Material readMaterialNode(const JsonNode& top) {
  top.allowOnly({"id", "label", "densityGPerCm3", "nozzleC", "bedC", "fan", "bridgeFan",
                 "maxFlowMm3PerS", "bridgeWidths", "bridgeMm", "bridges", "bridgeSagMm",
                 "minLayerTimeS", "maxLayerTimeS", "pricePerKg", "colour", "notes", "basedOn",
                 "elasticity"});
  Material m;
  m.id = top.at("id").text();
  m.label = top.at("label").text();
  if (m.label.empty())
    top.at("label").fail("must not be empty"_text);
  m.densityGPerCm3 = readDensity(top.at("densityGPerCm3"));
  readTemperatures(top, m);
  readLimits(top, m);
  readLayerTimes(top, m);
  readLooks(top, m);
  m.elasticity.reset();
  if (top.has("elasticity"))
    m.elasticity = readElasticity(top.at("elasticity"));
  m.comesWithProgram = false;
  return m;
}

std::string materialText(const Material& m) {
  nlohmann::ordered_json json = {
      {"id", m.id}, {"label", m.label}, {"densityGPerCm3", m.densityGPerCm3}};
  if (m.nozzleC)
    json["nozzleC"] = {{"default", *m.nozzleC}, {"min", m.nozzleMinC}, {"max", m.nozzleMaxC}};
  const auto write = [&json](const char* key, const auto& value) {
    if (value)
      json[key] = *value;
  };
  write("bedC", m.bedC);
  json["fan"] = m.fan;
  write("bridgeFan", m.bridgeFan);
  write("maxFlowMm3PerS", m.maxFlowMm3PerS);
  json["bridgeWidths"] = m.bridgeWidths;
  write("bridgeMm", m.bridgeMm);
  for (const BridgedLength& one : m.bridges)
    json["bridges"].push_back({one.widthMm, one.lengthMm});
  write("minLayerTimeS", m.minLayerTimeS);
  write("maxLayerTimeS", m.maxLayerTimeS);
  json["pricePerKg"] = m.pricePerKg;
  json["colour"] = m.colour;
  if (m.elasticity)
    json["elasticity"] = {{"alongMPa", m.elasticity->alongMPa},
                          {"acrossMPa", m.elasticity->acrossMPa},
                          {"shearMPa", m.elasticity->shearMPa},
                          {"poisson", m.elasticity->poisson}};
  if (!m.notes.empty())
    json["notes"] = m.notes;
  return json.dump(2) + "\n";
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
  forgetTemperatures(unknown);
  unknown.fan = 0.0;
  unknown.bridges.clear();
  unknown.elasticity.reset();
  unknown.pricePerKg = 0.0;
  unknown.comesWithProgram = false;
  return unknown;
}

} // namespace voluta::process
