#include "pipeline/planned_parameters.h"

#include "layers/tool_assignment.h"
#include "modes/mode_table.h"
#include "pipeline/resolved.h"
#include "process/feature_parameters.h"
#include "toolpath/options.h"

#include <string>

namespace voluta::pipeline {

base::ParameterTable plannedParameters(const modes::Mode& mode) {
  base::ParameterTable table = toolpath::toolpathParameters();
  table.append(process::featureParameters());
  table.appendOfItems(layers::toolParameters());
  if (!mode.place && !mode.platform)
    table.appendOfItems(modes::modeParameters());
  std::vector<base::ParameterSpec> specs = table.specs();
  std::erase_if(specs, [](const base::ParameterSpec& spec) {
    return spec.key == "voxelMm"; // of the platform around a part, too
  });
  return base::ParameterTable(std::move(specs));
}

std::vector<base::Message> noEffectNotes(const Resolved& resolved) {
  const base::ParameterTable planned =
      plannedParameters(modes::findMode(resolved.choices.item().mode));
  std::string keys;
  std::size_t count = 0;
  for (const auto& [key, value] : resolved.values.changes()) {
    const base::ParameterSpec* spec = planned.find(key);
    if (!spec || (resolved.isBesideOthers && spec->scope == base::ParameterScope::Job))
      continue;
    keys += (keys.empty() ? "" : ", ") + key;
    ++count;
  }
  if (count == 0)
    return {};
  return {
      base::Message("{count} setting has no effect on the tool-paths of a file: {keys}|"
                    "{count} settings have no effect on the tool-paths of a file: {keys}"_plural,
                    std::vector<base::Value>{count, keys})};
}

} // namespace voluta::pipeline
