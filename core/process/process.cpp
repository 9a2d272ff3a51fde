#include "process/process.h"

#include "base/data_files.h"
#include "base/files.h"
#include "base/inherited_text.h"
#include "base/json_node.h"
#include "process/bead_model.h"
#include "process/chosen_range.h"
#include "process/material_node.h"
#include "process/process_numbers.h"

#include <algorithm>
#include <vector>

namespace voluta::process {

namespace {
using base::JsonNode;

// Default for processes without a bridge speed, as a share of the usual speed
constexpr double kBridgeSpeed = 0.5;

bool isInRange(const ProcessNumber& row) {
  return row.key.find('.') != std::string_view::npos;
}

// Throws if a number is so large that its unit must be another.
void checkMaximum(const JsonNode& node, double value, const ProcessNumber& row) {
  if (value > row.maximum)
    node.fail(base::message("is above {most} {unit}: check the unit"_text,
                            base::number(row.maximum), row.unit));
}

void readSize(const JsonNode& top, std::string_view key, double& usual, double& minimum,
              double& maximum) {
  const ChosenRange range = readRange(top.at(key));
  usual = range.usual;
  minimum = range.minimum;
  maximum = range.maximum;
}

void readNumbers(const JsonNode& top, Process& p) {
  if (!p.tape) {
    readSize(top, "layerHeightMm", p.layerHeightMm, p.layerHeightMinMm, p.layerHeightMaxMm);
    readSize(top, "beadWidthMm", p.beadWidthMm, p.beadWidthMinMm, p.beadWidthMaxMm);
  }
  for (const ProcessNumber& row : processNumbers()) {
    if (p.tape && isOfTape(row))
      continue;
    if (isInRange(row)) {
      const std::size_t dot = row.key.find('.');
      checkMaximum(top.at(row.key.substr(0, dot)).at(row.key.substr(dot + 1)), p.*row.value, row);
      continue;
    }
    if (row.optional && !top.has(row.key))
      continue;
    const JsonNode node = top.at(row.key);
    p.*row.value = row.minimum != 0.0 ? node.number()
                   : row.mayBeZero    ? node.notNegative()
                                      : node.positive();
    if (p.*row.value < row.minimum)
      node.fail(base::message("is below {least}"_text, base::number(row.minimum)));
    checkMaximum(node, p.*row.value, row);
  }
}

Tape readTape(const JsonNode& node) {
  node.allowOnly({"widthMm", "thicknessMm", "leastLengthMm", "leastBendRadiusMm", "cutAheadMm",
                  "ironSpeedMmPerS", "densityGPerCm3", "fibreMPa", "fibreShare"});
  Tape tape{.widthMm = node.at("widthMm").positive(),
            .thicknessMm = node.at("thicknessMm").positive(),
            .minLengthMm = node.at("leastLengthMm").positive(),
            .minBendRadiusMm = node.at("leastBendRadiusMm").positive(),
            .cutAheadMm = node.at("cutAheadMm").positive()};
  if (node.has("fibreMPa"))
    tape.fibreMPa = node.at("fibreMPa").positive();
  if (node.has("fibreShare"))
    tape.fibreShare = node.at("fibreShare").positive();
  if (tape.fibreShare > 1.0)
    node.at("fibreShare").fail("is above 1"_text);
  if (tape.thicknessMm >= tape.widthMm)
    node.at("thicknessMm").fail("is not less than 'widthMm'"_text);
  if (tape.minBendRadiusMm < 0.5 * tape.widthMm)
    node.at("leastBendRadiusMm").fail("is less than half of 'widthMm'"_text);
  if (tape.cutAheadMm >= tape.minLengthMm)
    node.at("cutAheadMm").fail("is not less than 'leastLengthMm'"_text);
  return tape;
}
// The sizes and the speed of the tape's paths, which have no limits of their own.
void takeTape(const JsonNode& node, Process& p) {
  p.tape = readTape(node);
  const Tape& tape = *p.tape;
  p.layerHeightMm = p.layerHeightMinMm = p.layerHeightMaxMm = tape.thicknessMm;
  p.beadWidthMm = p.beadWidthMinMm = p.beadWidthMaxMm =
      widthOfArea(tape.widthMm * tape.thicknessMm, tape.thicknessMm);
  p.speedMmPerS = p.bridgeSpeedMmPerS = node.at("ironSpeedMmPerS").positive();
  p.bridgeMm = 0.0;
}

HeadShape readHead(const JsonNode& list) {
  HeadShape head;
  for (const JsonNode& item : list.items()) {
    const std::vector<JsonNode> pair = item.items();
    if (pair.size() != 2)
      item.fail("must be a pair of height and radius"_text);
    const HeadSection section{pair[0].notNegative(), pair[1].notNegative()};
    if (head.sections.empty() ? section.zMm != 0.0 : section.zMm < head.sections.back().zMm)
      item.fail("does not rise from z = 0"_text);
    head.sections.push_back(section);
  }
  if (head.sections.size() < 2)
    list.fail("must have at least two sections"_text);
  if (!(head.sections.back().zMm > 0.0))
    list.fail("does not rise from z = 0"_text);
  return head;
}
// A material without a file of its own needs the density here. One of the user's own is within the
// process where that has to do without the user's files.
Material readMaterial(const JsonNode& process) {
  if (process.has("ownMaterial"))
    return readMaterialNode(process.at("ownMaterial"));
  Material material = materialNamed(process.at("material").text());
  if (process.has("tape")) {
    material.densityGPerCm3 = readDensity(process.at("tape").at("densityGPerCm3"));
    return material;
  }
  if (process.has("densityGPerCm3") || material.densityGPerCm3 == 0.0)
    material.densityGPerCm3 = readDensity(process.at("densityGPerCm3"));
  return material;
}

// Throws if two limits contradict each other, naming both.
void checkLimits(const JsonNode& top, const Process& p) {
  if (p.layerHeightMm > p.beadWidthMm)
    top.at("layerHeightMm")
        .fail(
            base::message("is {height} by default, more than the default of beadWidthMm, {width}: "
                          "beads are no higher than wide"_text,
                          base::mm(p.layerHeightMm), base::mm(p.beadWidthMm)));
  if (p.contactToleranceMm >= p.layerHeightMaxMm)
    top.at("contactToleranceMm")
        .fail(base::message("is {tolerance}, not less than the maximum of layerHeightMm, {height}: "
                            "the head would pass through a layer"_text,
                            base::mm(p.contactToleranceMm), base::mm(p.layerHeightMaxMm)));
  if (const double flow = p.speedMmPerS * beadArea(p.beadWidthMinMm, p.layerHeightMinMm);
      flow > p.maxFlowMm3PerS)
    top.at("maxFlowMm3PerS")
        .fail(base::message("is {most:.3g} mm3/s, less than the smallest bead needs at "
                            "speedMmPerS, {flow:.3g} mm3/s"_text,
                            base::number(p.maxFlowMm3PerS), base::number(flow)));
}

// With an overlap factor, the file's widths are those of single beads; everything plans with the
// width of beads that fill a layer at this share of them.
void setMachineLaws(MachineLaws laws, Process& p) {
  p.lag = laws.lag;
  p.overlapFactor = laws.overlapFactor;
  p.beadWords = std::move(laws.beadWords);
  if (p.overlapFactor == 1.0)
    return;
  for (double* width : {&p.beadWidthMm, &p.beadWidthMinMm, &p.beadWidthMaxMm})
    *width = widthOfHatch(p.overlapFactor * *width, p.layerHeightMm);
}
} // namespace

HeadShape erodedHead(const HeadShape& head, double toleranceMm) {
  HeadShape eroded = head;
  for (HeadSection& s : eroded.sections) {
    s.zMm += toleranceMm;
    s.radiusMm = std::max(0.0, s.radiusMm - toleranceMm);
  }
  return eroded;
}

double saggingBridgeMm(const Process& process, double beadWidthMm) {
  const Material& m = process.material;
  const double stated = bridgedMm(m, beadWidthMm);
  return std::max(process.bridgeMm, m.bridgeMm ? std::min(stated, *m.bridgeMm) : stated);
}

double saggingBridgeMm(const Process& process) {
  return saggingBridgeMm(process, process.beadWidthMm);
}

double flowLimit(const Process& process) {
  return std::min(process.maxFlowMm3PerS,
                  process.material.maxFlowMm3PerS.value_or(process.maxFlowMm3PerS));
}

double primeFlow(const Process& process) {
  return std::min(flowLimit(process),
                  beadArea(process.beadWidthMm, process.layerHeightMm) * process.speedMmPerS);
}

const BeadWords* Process::wordsFor(std::string_view format) const {
  const auto at = std::ranges::find(beadWords, format, &BeadWords::format);
  return at == beadWords.end() ? nullptr : &*at;
}

Process readProcess(const std::filesystem::path& file) {
  return readProcessText(base::readFile(file), file.string());
}

Process readProcessText(const std::string& text, const std::string& name) {
  const JsonNode top = JsonNode::parse(base::wholeText("processes", text, name), name);
  top.allowOnly({"id",
                 "label",
                 "nozzleDiameterMm",
                 "layerHeightMm",
                 "beadWidthMm",
                 "stepMm",
                 "speedMmPerS",
                 "travelSpeedMmPerS",
                 "accelerationMmPerS2",
                 "contactToleranceMm",
                 "bridgeMm",
                 "bridgeSpeedMmPerS",
                 "maxFlowMm3PerS",
                 "primeS",
                 "retractMm",
                 "material",
                 "ownMaterial",
                 "densityGPerCm3",
                 "startLagS",
                 "stopLagS",
                 "overlapFactor",
                 "beadWords",
                 "scaleX",
                 "scaleY",
                 "outlineOffsetMm",
                 "holeOffsetMm",
                 "head",
                 "features",
                 "overhangSpeed",
                 "tape",
                 "basedOn"});
  Process p;
  p.id = top.at("id").text();
  p.label = top.at("label").text();
  if (p.label.empty())
    top.at("label").fail("must not be empty"_text);
  if (top.has("tape"))
    takeTape(top.at("tape"), p);
  readNumbers(top, p);
  setMachineLaws(readMachineLaws(top), p);
  p.material = readMaterial(top);
  if (!p.tape && !top.has("bridgeMm"))
    p.bridgeMm = p.material.bridgeWidths * p.beadWidthMm;
  if (p.material.bridgeMm)
    p.bridgeMm = std::min(p.bridgeMm, *p.material.bridgeMm);
  if (!p.tape && !top.has("bridgeSpeedMmPerS"))
    p.bridgeSpeedMmPerS = kBridgeSpeed * p.speedMmPerS;
  p.head = readHead(top.at("head"));
  checkLimits(top, p);
  if (top.has("features"))
    p.features =
        readFeatures(top.at("features"), {p.beadWidthMinMm, p.beadWidthMm, p.beadWidthMaxMm});
  if (top.has("overhangSpeed"))
    p.overhangSpeed = readOverhangSpeed(top.at("overhangSpeed"));
  return p;
}

std::vector<std::string> processIds() {
  return base::dataFileIds("processes");
}

Process loadProcess(const std::string& choice) {
  const base::DataText data = base::dataText("processes", choice, "unknown process '{id}'"_text);
  return readProcessText(data.text, data.file.string());
}

} // namespace voluta::process
