#include "pipeline/reported_choices.h"

#include "base/error.h"
#include "pipeline/presets/chosen_preset.h"
#include "pipeline/stage_options.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {

std::string nameOfPreset(const std::string& choice) {
  try {
    return loadPreset(choice).label;
  } catch (const base::Error&) {
    return choice;
  }
}

std::vector<std::string> changedSettings(const project::Choices& choices) {
  std::vector<std::string> changed;
  const Settings preset = settingsOfPreset(choices);
  for (std::size_t i = 0; i < choices.items.size(); ++i) {
    const project::Choices item = project::onlyItem(choices, i);
    for (const SettingDifference& d :
         settingDifferences(preset, givenParameters(item), parametersOf(item))) {
      const bool isOfJob = d.spec.scope == base::ParameterScope::Job;
      if (isOfJob && i > 0)
        continue;
      const std::string part =
          isOfJob || choices.items.size() == 1 ? std::string() : std::to_string(i + 1) + ":";
      changed.push_back(part + d.spec.key + "=" + base::formatParameter(d.second));
    }
  }
  return changed;
}

// Returns the layer of the first bead at or after a point, from 1; 0: there is none.
int layerFrom(std::size_t point, const project::Job& job) {
  const std::vector<std::size_t>& waypoints = job.trajectory->waypoint;
  const auto next =
      std::find_if(waypoints.begin() + static_cast<std::ptrdiff_t>(point), waypoints.end(),
                   [](std::size_t waypoint) { return waypoint != plan::kNoWaypoint; });
  if (next == waypoints.end())
    return 0;
  const std::vector<plan::ToolPath>& paths = job.toolPlan->paths;
  const auto path = std::ranges::upper_bound(paths, *next, {}, &plan::ToolPath::first);
  return path == paths.begin() ? 0 : std::prev(path)->layer + 1;
}

std::vector<int> pausedLayers(const project::Job& job) {
  std::vector<int> layers;
  if (!job.trajectory || !job.toolPlan)
    return layers;
  for (const plan::TrajectoryEvent& event : job.trajectory->events)
    if (event.kind == plan::EventKind::Pause && event.point >= job.resumedAt &&
        !job.trajectory->changeAfter(event))
      if (const int layer = layerFrom(event.point, job); layer > 0)
        layers.push_back(layer);
  return layers;
}
} // namespace

ReportedChoices reportedChoices(const project::Job& job) {
  return {nameOfPreset(job.choices.preset), changedSettings(job.choices), pausedLayers(job)};
}

} // namespace voluta::pipeline
