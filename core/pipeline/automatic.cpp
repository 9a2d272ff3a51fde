#include "pipeline/automatic.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/parameters.h"
#include "modes/cell_choice.h"
#include "modes/mode_table.h"
#include "pipeline/stage_options.h"
#include "regions/region_uses.h"
#include "support/supports.h"

#include <algorithm>
#include <utility>

namespace voluta::pipeline {

namespace {

constexpr const char* kLayerHeight = "layerHeightMm";
constexpr const char* kSupports = "supports";

constexpr base::Text kCurved = "curved layers"_text;
constexpr base::Text kCurvedSupported = "curved layers with supports"_text;
constexpr base::Text kFlat = "flat layers"_text;
constexpr base::Text kFlatSupported = "flat layers with supports"_text;
constexpr base::Text kPedestal = "curved layers on a pedestal"_text;

} // namespace

const std::vector<AutomaticStrategy>& automaticStrategies() {
  static const std::vector<AutomaticStrategy> kWays{
      {"curved", "curved", "cell", kCurved, kCurvedSupported, {{kSupports, "none"}}},
      {"pieces", "planar", "cell", "pieces"_text, "pieces with supports"_text},
      {"curved-columns", "curved", "cell", kCurved, kCurvedSupported, {{kSupports, "auto"}}},
      {"flat", "flat", "cell", kFlat, kFlatSupported, {{kSupports, "auto"}}},
      {"flat-low", "flat", "cell", kFlat, kFlatSupported, {{kSupports, "auto"}}, true},
      {"pedestal", "curved", "fit", kPedestal, kPedestal},
      {kTerraced, "flat", "cell", kFlat, kFlatSupported, {{kSupports, "none"}}},
  };
  return kWays;
}

namespace {

bool fits(const AutomaticStrategy& strategy, const project::Choices& choices) {
  return strategy.mode == choices.item().mode &&
         (choices.item().platformStays ||
          project::Platform(strategy.platform) == choices.item().platform);
}

// Returns the way named in `choices` if it has their mode and platform, else nullptr.
const AutomaticStrategy* namedStrategy(const project::Choices& choices) {
  const auto& ways = automaticStrategies();
  const auto named =
      std::ranges::find(ways, choices.item().automaticStrategy, &AutomaticStrategy::id);
  return named != ways.end() && fits(*named, choices) ? &*named : nullptr;
}

// Returns the way that the choices belong to; nullptr if no way of the table matches.
const AutomaticStrategy* strategyOf(const project::Choices& choices) {
  if (const AutomaticStrategy* named = namedStrategy(choices))
    return named;
  const auto& ways = automaticStrategies();
  const auto first = std::ranges::find_if(
      // The choices name none of these ways
      ways, [&](const AutomaticStrategy& strategy) { return fits(strategy, choices); });
  return first == ways.end() ? nullptr : &*first;
}

// Returns whether the way reduces the layer height. A height set by the user is kept.
bool lowers(const project::Choices& choices) {
  const AutomaticStrategy* strategy = strategyOf(choices);
  return strategy && strategy->lowLayers && !choices.item().parameters.contains(kLayerHeight);
}

double lowLayerMm(const project::Choices& choices) {
  const process::Process p = process::loadProcess(choices.tool(ownTool(choices)).process);
  return p.layerHeightMinMm + 0.25 * (p.layerHeightMm - p.layerHeightMinMm);
}

} // namespace

std::vector<project::Choices> automaticChoices(const project::Choices& choices) {
  const base::ParameterValues values = parameterValues(choices);
  const robot::Cell cell = modes::cellOnAnyPlatform(choices, chosenProcess(choices, values));
  const bool rod = cell.rod().has_value();
  bool tilts = canTilt(choices, cell);
  std::vector<project::Choices> all, hands; // Each way, and the equivalent manual choices
  const auto add = [&](const modes::Mode& mode, const project::Platform& platform,
                       std::string_view id) {
    project::Choices strategy = choices;
    strategy.item().mode = mode.id;
    strategy.item().automaticStrategy = id;
    if (!choices.item().platformStays)
      strategy.item().platform = platform;
    if (mode.aroundRod != rod || (!mode.upright && !tilts) ||
        !strategy.item().platform.isForAnyOf(mode.platforms))
      return;
    project::Choices hand = resolved(strategy);
    if (std::ranges::any_of(hands, [&](const project::Choices& other) {
          return other.item().mode == hand.item().mode &&
                 other.item().platform == hand.item().platform &&
                 other.item().parameters == hand.item().parameters;
        }))
      return;
    all.push_back(std::move(strategy));
    hands.push_back(std::move(hand));
  };
  const auto addAll = [&] {
    for (const AutomaticStrategy& strategy : automaticStrategies())
      add(modes::findMode(strategy.mode), project::Platform(strategy.platform), strategy.id);
    for (const modes::Mode& mode : modes::modeTable())
      if (all.empty())
        add(mode, mode.usual.platform, {});
  };
  addAll();
  if (all.empty() && cell.tilts()) { // The refusal of the format will say why
    tilts = true;
    addAll();
  }
  if (all.empty())
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("no way of building supports platform {platform} in cell {cell}"_text,
                      choices.item().platform.text(), base::dataName(choices.cell)),
        {}, "choose another platform, or another cell"_text);
  return all;
}

bool namesStrategy(const project::Choices& choices) {
  return choices.item().automatic && namedStrategy(choices);
}

project::Choices strategyOrFirst(const project::Choices& choices) {
  if (!choices.item().automatic || namesStrategy(choices))
    return choices;
  return automaticChoices(choices).front();
}

project::Choices resolved(project::Choices choices) {
  if (!choices.item().automatic)
    return choices;
  choices.item().automatic = false;
  if (const AutomaticStrategy* strategy = strategyOf(choices)) {
    if (lowers(choices))
      choices.item().parameters[kLayerHeight] = base::formatParameter(lowLayerMm(choices));
    choices.item().parameters.insert(strategy->parameters.begin(), strategy->parameters.end());
  }
  return choices;
}

std::map<std::string, std::string> parametersOfStrategy(project::Choices choices) {
  if (!choices.item().automatic)
    return {};
  choices.item().parameters.clear();
  return resolved(std::move(choices)).item().parameters;
}

base::Message nameOfStrategy(const project::Choices& choices) {
  const AutomaticStrategy* strategy = choices.item().automatic ? strategyOf(choices) : nullptr;
  if (!strategy)
    return modes::findMode(choices.item().mode).label;
  const bool supported = support::supportsWanted(parameterValues(resolved(choices)));
  const base::Text name = supported ? strategy->nameWithSupports : strategy->name;
  if (!lowers(choices))
    return name;
  return base::message("{way}, {height} each"_text, name, base::mm(lowLayerMm(choices)));
}

} // namespace voluta::pipeline
