#include "pipeline/automatic.h"

#include "base/error.h"
#include "modes/cell_choice.h"
#include "modes/mode_table.h"
#include "pipeline/choices.h"

#include <utility>

namespace voluta::pipeline {

const std::vector<AutomaticWay>& automaticWays() {
  static const std::vector<AutomaticWay> kWays{
      {"curved", "cell", {{"frontShape", "nozzle"}}},
      {"planar", "cell"},
      {"flat", "cell", {{"supports", "auto"}, {"adaptiveLayers", "true"}}},
      {"curved", "fit"},
  };
  return kWays;
}

std::vector<project::Choices> automaticChoices(const project::Choices& choices) {
  const base::ParameterValues values = parameterValues(choices);
  const bool rod =
      modes::cellOnAnyPlatform(choices, chosenProcess(choices, values)).rod().has_value();
  std::vector<project::Choices> all;
  const auto add = [&](const modes::Mode& mode, const project::Platform& platform) {
    project::Choices way = choices;
    way.mode = mode.id;
    if (!choices.platformStays)
      way.platform = platform;
    if (mode.aroundRod != rod || !way.platform.isForAnyOf(mode.platforms))
      return;
    for (const project::Choices& other : all)
      if (other.mode == way.mode && other.platform == way.platform)
        return;
    all.push_back(std::move(way));
  };
  for (const AutomaticWay& way : automaticWays())
    add(modes::findMode(way.mode), project::Platform(way.platform));
  for (const modes::Mode& mode : modes::modeTable())
    if (all.empty())
      add(mode, mode.usual.platform);
  if (all.empty())
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("no way of building takes platform {platform} in cell {cell}"_text,
                      choices.platform.text(), choices.cell),
        {}, "choose another platform, or another cell"_text);
  return all;
}

project::Choices byHand(project::Choices choices) {
  if (!choices.automatic)
    return choices;
  choices.automatic = false;
  for (const AutomaticWay& way : automaticWays())
    if (way.mode == choices.mode &&
        (choices.platformStays || project::Platform(way.platform) == choices.platform))
      choices.parameters.insert(way.parameters.begin(), way.parameters.end());
  return choices;
}

} // namespace voluta::pipeline
