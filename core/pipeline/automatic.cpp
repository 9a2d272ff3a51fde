#include "pipeline/automatic.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/parameters.h"
#include "modes/cell_choice.h"
#include "modes/mode_table.h"
#include "pipeline/stage_options.h"
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

const std::vector<AutomaticWay>& automaticWays() {
  static const std::vector<AutomaticWay> kWays{
      {"curved", "curved", "cell", kCurved, kCurvedSupported, {{kSupports, "none"}}},
      {"pieces", "planar", "cell", "pieces"_text, "pieces with supports"_text},
      {"curved-columns", "curved", "cell", kCurved, kCurvedSupported, {{kSupports, "auto"}}},
      {"flat", "flat", "cell", kFlat, kFlatSupported, {{kSupports, "auto"}}},
      {"flat-low", "flat", "cell", kFlat, kFlatSupported, {{kSupports, "auto"}}, true},
      {"pedestal", "curved", "fit", kPedestal, kPedestal},
  };
  return kWays;
}

namespace {

bool fits(const AutomaticWay& way, const project::Choices& choices) {
  return way.mode == choices.item().mode &&
         (choices.item().platformStays ||
          project::Platform(way.platform) == choices.item().platform);
}

// Returns the way named in `choices` if it has their mode and platform, else nullptr.
const AutomaticWay* namedWay(const project::Choices& choices) {
  const auto& ways = automaticWays();
  const auto named = std::ranges::find(ways, choices.item().automaticWay, &AutomaticWay::id);
  return named != ways.end() && fits(*named, choices) ? &*named : nullptr;
}

// Returns the way that the choices belong to; nullptr if no way of the table matches.
const AutomaticWay* wayOf(const project::Choices& choices) {
  if (const AutomaticWay* named = namedWay(choices))
    return named;
  const auto& ways = automaticWays();
  const auto first = std::ranges::find_if(
      // The choices name none of these ways
      ways, [&](const AutomaticWay& way) { return fits(way, choices); });
  return first == ways.end() ? nullptr : &*first;
}

// Returns whether the way reduces the layer height. A height set by the user is kept.
bool lowers(const project::Choices& choices) {
  const AutomaticWay* way = wayOf(choices);
  return way && way->lowLayers && !choices.item().parameters.contains(kLayerHeight);
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
    project::Choices way = choices;
    way.item().mode = mode.id;
    way.item().automaticWay = id;
    if (!choices.item().platformStays)
      way.item().platform = platform;
    if (mode.aroundRod != rod || (!mode.upright && !tilts) ||
        !way.item().platform.isForAnyOf(mode.platforms))
      return;
    project::Choices hand = resolved(way);
    if (std::ranges::any_of(hands, [&](const project::Choices& other) {
          return other.item().mode == hand.item().mode &&
                 other.item().platform == hand.item().platform &&
                 other.item().parameters == hand.item().parameters;
        }))
      return;
    all.push_back(std::move(way));
    hands.push_back(std::move(hand));
  };
  const auto addAll = [&] {
    for (const AutomaticWay& way : automaticWays())
      add(modes::findMode(way.mode), project::Platform(way.platform), way.id);
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

bool namesWay(const project::Choices& choices) {
  return choices.item().automatic && namedWay(choices);
}

project::Choices wayOrFirst(const project::Choices& choices) {
  if (!choices.item().automatic || namesWay(choices))
    return choices;
  return automaticChoices(choices).front();
}

project::Choices resolved(project::Choices choices) {
  if (!choices.item().automatic)
    return choices;
  choices.item().automatic = false;
  if (const AutomaticWay* way = wayOf(choices)) {
    if (lowers(choices))
      choices.item().parameters[kLayerHeight] = base::formatParameter(lowLayerMm(choices));
    choices.item().parameters.insert(way->parameters.begin(), way->parameters.end());
  }
  return choices;
}

std::map<std::string, std::string> parametersOfWay(project::Choices choices) {
  if (!choices.item().automatic)
    return {};
  choices.item().parameters.clear();
  return resolved(std::move(choices)).item().parameters;
}

base::Message nameOfWay(const project::Choices& choices) {
  const AutomaticWay* way = choices.item().automatic ? wayOf(choices) : nullptr;
  if (!way)
    return modes::findMode(choices.item().mode).label;
  const bool supported = support::supportsWanted(parameterValues(resolved(choices)));
  const base::Text name = supported ? way->nameWithSupports : way->name;
  if (!lowers(choices))
    return name;
  return base::message("{way}, {height} each"_text, name, base::mm(lowLayerMm(choices)));
}

} // namespace voluta::pipeline
