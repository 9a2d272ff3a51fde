#include "pipeline/stage_keys.h"

#include "base/key_text.h"
#include "layers/tool_assignment.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "motion/layer_event_text.h"
#include "motion/motion_options.h"
#include "pipeline/cell_plate.h"
#include "pipeline/cell_text.h"
#include "pipeline/given_paths.h"
#include "pipeline/item_events.h"
#include "pipeline/item_regions.h"
#include "pipeline/open_part.h"
#include "pipeline/path_parameters.h"
#include "pipeline/quality.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/turned_part.h"
#include "program/dialect.h"
#include "robot/cell.h"
#include "toolpath/options.h"

#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

// The process, split by the stages that use it, so that a stage does not run again because of a
// value it does not use. The structured binding forces every new member of the process to be
// considered here.
struct ProcessKeys {
  std::string bead, head, travel, material;
};

// Empty for a material that comes with the program: its label and density identify it.
std::string ownMaterialKey(const process::Material& m) {
  return m.comesWithProgram ? std::string()
                            : base::keyText(m.nozzleC.value_or(0), m.nozzleMinC, m.nozzleMaxC,
                                            m.bedC.value_or(0), m.fan, m.bridgeFan.value_or(m.fan));
}

// Empty for a material that comes with the program.
std::string ownBridgesKey(const process::Material& m) {
  std::string key;
  if (!m.comesWithProgram)
    for (const process::BridgedLength& one : m.bridges)
      key += base::keyText(one.widthMm, one.lengthMm);
  return key;
}

// Empty without a change of the speed, as in older projects.
std::string overhangKey(const process::OverhangSpeed& speed) {
  return speed == process::OverhangSpeed() ? std::string() : base::keyText(speed.shares);
}

// The same for the limit of the material's flow.
std::string ownFlowKey(const process::Process& p) {
  return p.material.comesWithProgram ? std::string() : base::keyText(process::flowLimit(p));
}

// Empty without lags or statements, as in older projects.
std::string lagKey(const process::ExtruderLag& lag) {
  return lag.startS == 0.0 && lag.stopS == 0.0 ? std::string()
                                               : base::keyText(lag.startS, lag.stopS);
}
std::string wordsKey(const std::vector<process::BeadWords>& words) {
  std::string key;
  for (const process::BeadWords& w : words) {
    key += base::keyText(w.format);
    for (const auto* statements : {&w.start, &w.end}) {
      key += base::keyText(statements->size());
      for (const std::string& statement : *statements)
        key += base::keyText(statement);
    }
  }
  return key;
}

ProcessKeys keysOf(const process::Process& process) {
  const auto& [id, label, nozzle, height, heightMin, heightMax, width, widthMin, widthMax, step,
               speed, travelSpeed, acceleration, tolerance, bridge, bridgeSpeed, maxFlow, prime,
               retract, material, head, features, overhangSpeed, tape, lag, overlap, words, scaleX,
               scaleY, outlineOffset, holeOffset] = process;
  static_cast<void>(label);   // The label affects no result.
  static_cast<void>(overlap); // Contained in the widths
  // The layers contain the corrected sizes.
  static_cast<void>(scaleX), static_cast<void>(scaleY), static_cast<void>(outlineOffset),
      static_cast<void>(holeOffset);
  return {base::keyText(height, heightMin, heightMax, width, widthMin, widthMax, step, speed,
                        bridge, bridgeSpeed, maxFlow, features.all()) +
              ownFlowKey(process) + overhangKey(overhangSpeed) +
              (tape ? base::keyText(*tape) : std::string()),
          base::keyText(tolerance, head), base::keyText(travelSpeed, acceleration) + lagKey(lag),
          base::keyText(id, nozzle, prime, retract, material.label, material.densityGPerCm3) +
              ownMaterialKey(material) + ownBridgesKey(material) + wordsKey(words)};
}

// The same of all tools.
ProcessKeys keysOf(const process::Tooling& tooling) {
  ProcessKeys all;
  for (const process::Tool& tool : tooling.tools()) {
    const ProcessKeys own = keysOf(tool.process);
    all.bead += own.bead;
    all.head += own.head;
    all.travel += own.travel;
    all.material += own.material;
  }
  return all;
}

// Without cuts as in older projects.
std::string keyOfOrientation(const OrientationPlan& plan) {
  const auto& [objective, voxelMm, overhangRad, platform, cuts] = plan;
  return base::keyText(objective, voxelMm, overhangRad, platform) +
         (cuts ? base::keyText(*cuts) : std::string());
}

bool isMended(const project::LoadedPart& loaded, const project::Choices& choices) {
  return choices.item().repair && !loaded.found.clean(); // A clean mesh needs no repair.
}

std::string loadText(const project::LoadedPart& loaded, const Resolved& resolved,
                     const std::string& cell) {
  const modes::ModeChoices in = resolved.modeChoices();
  const project::Choices& c = in.choices;
  std::string text =
      base::keyText(loaded.hash, isMended(loaded, c), c.item().placement.rotation.coeffs(),
                    c.item().placement.centreMm, c.item().placement.liftMm);
  if (const double unit = unitMm(loaded, c); loaded.cells || unit != 1.0)
    text += base::keyText(unit);
  text += openSurfacesKey(in.choices, in.values, in.process);
  text += cutRegionsKey(resolved) + loadRegionsKey(resolved);
  const OrientationPlan orientationSearch = orientationPlan(in);
  text += keyOfOrientation(orientationSearch);
  if (const modes::Mode& mode = modes::findMode(c.item().mode); orientationSearch.cuts && mode.cuts)
    text += mode.decompose.key(in); // the orientation is chosen by what these cuts leave
  if (takesGivenPaths(loaded, in.values))
    text += "along given paths\n" + pathShapeKey(in.values);
  if (loaded.inWorkFrame && resolved.isBesideOthers)
    text += "beside others\n";
  if (c.item().platform.isOfCell()) {
    const PlateNeeds needs = plateNeeds(in);
    text += "a plate of\n" + cell +
            base::keyText(needs.supports, needs.prime, needs.primeIsRing, needs.primeLengthMm,
                          needs.primeBeadMm, needs.brimMm);
  }
  const modes::Mode& mode = modes::findMode(c.item().mode);
  if (mode.place)
    text += base::keyText(mode.id) + mode.place.key(in);
  const double scale = project::parsedScale(c.item().scale);
  if (scale > 0.0)
    return text + base::keyText(scale);
  return text + "to fit\n" + cell + mode.fittingScale.key(in) + keysOf(in.process).head;
}

// All inputs of writing and judging a program, apart from its format.
std::string programText(const std::string& partName, const process::Tooling& tooling) {
  const ProcessKeys keys = keysOf(tooling);
  return base::keyText(partName) + keys.material + keys.bead + keys.head + keys.travel;
}

std::string optionsText(const std::string& format, const program::ProgramOptions& options) {
  return base::keyText(
      program::optionsAmong(program::optionsOf(program::findDialect(format)), options));
}

// Empty if the first tool prints everything.
std::string assignedToolsKey(const base::ParameterValues& values) {
  std::string key;
  const base::ParameterTable table = layers::toolParameters();
  for (const auto& [name, value] : values.changes())
    if (const base::ParameterSpec* spec = table.find(name); spec && spec->defaultValue != value)
      key += base::keyText(name, base::formatParameter(value));
  for (const plan::LayerEvent& event : motion::eventsAsked(values))
    if (event.kind == plan::LayerEventKind::Tool)
      key += base::keyText("from layer", event.layer, event.number);
  return key;
}

// Empty without a load, as in older projects.
std::string loadKey(const base::ParameterValues& values) {
  const std::string load = values.text("loadDirection");
  return load.empty() ? load : base::keyText(load);
}

// The limits that a program is judged by; empty for those of older projects.
std::string qualityKey(const base::ParameterValues& values) {
  const Quality quality = qualityOf(values);
  return quality.level == Quality().level && quality.accepted.empty()
             ? std::string()
             : base::keyText(quality.level, textOf(quality.accepted));
}

std::string next(const std::string& before, project::Stage stage, const std::string& own) {
  return fmt::format("{}[{}]\n{}", before, project::stageName(stage), own);
}

} // namespace

project::StageKeys keysOf(const project::LoadedPart& loaded, const Resolved& resolved) {
  const modes::ModeChoices in = resolved.modeChoices();
  const auto& [choices, values, process] = in;
  const process::Tooling& tooling = resolved.tooling;
  const std::string tools = assignedToolsKey(values);
  const robot::Cell cell = fittingCell(choices, process); // The platform has its own text.
  const modes::Mode& mode = modes::findMode(choices.item().mode);
  const std::string cellKey = cellText(cell, choices.cell);

  project::StageKeys keys;
  const auto put = [&](project::Stage stage, const std::string& own) {
    const std::string before =
        stage == project::Stage::Load ? "" : keys[project::indexOf(stage) - 1];
    keys[project::indexOf(stage)] = next(before, stage, own);
  };
  put(project::Stage::Load, loadText(loaded, resolved, cellKey));
  put(project::Stage::Decompose, base::keyText(mode.id) + mode.decompose.key(in) +
                                     layeredRegionsKey(resolved) +
                                     (mode.requiresParameter("voxelMm") // whose losses count
                                          ? supportRegionsKey(resolved)
                                          : std::string()));
  put(project::Stage::Layers, mode.layers.key(in) + tools + regionLayersKey(resolved));
  const ProcessKeys processKeys = keysOf(tooling);
  toolpath::ToolpathOptions paths = toolpathOptionsOf(values, process);
  paths.canTilt = canTilt(choices, cell);
  put(project::Stage::Toolpath, cellKey + toolpath::optionsKey(paths) + processKeys.bead +
                                    processKeys.head + loadKey(values) + regionRulesKey(resolved));
  motion::MotionOptions motionOptions = motionOptionsOf(values, choices.seed);
  motionOptions.layerEvents.clear(); // their own part of the key
  put(project::Stage::Motion, processKeys.travel + processKeys.head + base::keyText(motionOptions) +
                                  eventsKey(eventsOfItem(loaded, values, 0)));
  // Includes the program options of each format.
  std::string formats;
  for (const std::string& format : chosenFormats(choices, cell))
    formats += format + " " + optionsText(format, program::programOptions(values));
  put(project::Stage::Replay, programText(loaded.name, tooling) +
                                  base::keyText(motion::layerTimes(values)) + qualityKey(values) +
                                  "formats\n" + formats);
  return keys;
}

project::StageKeys joinedKeys(std::span<const project::StageKeys> items, layers::PrintOrder order) {
  project::StageKeys keys = items.front();
  if (items.size() == 1)
    return keys;
  constexpr std::size_t kLayers = project::indexOf(project::Stage::Layers);
  for (std::size_t s = 0; s <= kLayers; ++s)
    for (std::size_t i = 1; i < items.size(); ++i)
      keys[s] += items[i][s];
  keys[kLayers] += base::keyText(static_cast<int>(order));
  // A key is that of the stage before and its own text.
  const auto own = [](const project::StageKeys& item, std::size_t s) {
    return item[s].substr(item[s - 1].size());
  };
  constexpr std::size_t kToolpath = project::indexOf(project::Stage::Toolpath),
                        kMotion = project::indexOf(project::Stage::Motion);
  for (std::size_t s = kLayers + 1; s < project::kStageCount; ++s) {
    keys[s] = keys[s - 1] + own(items.front(), s);
    // The layers of every item are covered by its own options.
    for (std::size_t i = 1; i < items.size() && s == kToolpath; ++i)
      keys[s] += own(items[i], s);
    for (std::size_t i = 1; i < items.size() && s == kMotion; ++i)
      if (const std::string events(eventsIn(own(items[i], s))); !events.empty())
        keys[s] += fmt::format("part {} {}", i, events);
  }
  return keys;
}

std::string placedPartKey(const project::LoadedPart& loaded, const modes::LoadStage& placed,
                          const Resolved& resolved) {
  const modes::ModeChoices in = resolved.modeChoices();
  const geometry::Placement& at = placed.placement;
  return base::keyText(loaded.hash, isMended(loaded, in.choices),
                       placed.scale * unitMm(loaded, in.choices), at.rotation.coeffs(), at.centreMm,
                       at.liftMm) +
         openSurfacesKey(in.choices, in.values, in.process) + cutRegionsKey(resolved);
}

std::string programKey(const project::StageKeys& keys, const std::string& partName,
                       const Resolved& resolved, const std::string& format) {
  return next(keys[project::indexOf(project::Stage::Motion)], project::Stage::Replay,
              programText(partName, resolved.tooling) + "format " + format + " " +
                  optionsText(format, program::programOptions(resolved.values)) +
                  qualityKey(resolved.values));
}

} // namespace voluta::pipeline
