#include "document/item_choices.h"

#include "base/error.h"
#include "layers/tool_assignment.h"
#include "modes/mode_table.h"
#include "pipeline/open_part.h"
#include "pipeline/path_parameters.h"
#include "placement/orient.h"

#include <set>
#include <utility>

namespace voluta::document {

using project::Choices;
using project::ItemChoices;

namespace {

void takeParameter(ItemChoices& to, const ItemChoices& from, const std::string& key) {
  if (const auto found = from.parameters.find(key); found != from.parameters.end())
    to.parameters[key] = found->second;
  else
    to.parameters.erase(key);
}

std::set<std::string> changedParameters(const ItemChoices& before, const ItemChoices& after) {
  std::set<std::string> keys;
  for (const auto* side : {&before, &after})
    for (const auto& [key, text] : side->parameters) {
      const auto was = before.parameters.find(key), is = after.parameters.find(key);
      if (was == before.parameters.end() || is == after.parameters.end() ||
          was->second != is->second)
        keys.insert(key);
    }
  return keys;
}

} // namespace

bool isOfJob(const std::string& parameter) {
  static const base::ParameterTable ofItem = [] {
    base::ParameterTable table;
    table.append(modes::modeParameters());
    table.append(pipeline::openSurfaceParameters());
    table.append(pipeline::pathShapeParameters());
    table.append(placement::orientParameters());
    table.append(layers::toolParameters());
    return table;
  }();
  // How the layers of a part are covered (toolpath::ItemLayers)
  static const std::set<std::string> ofCover = {
      "layerHeightMm", "beadWidthMm", "walls",        "infill", "infillDensity",
      "sparsePattern", "topLayers",   "bottomLayers", "skinMm", "thinWalls"};
  return parameter != "givenToolPaths" && !ofItem.find(parameter) && !ofCover.contains(parameter);
}

Choices withItem(const Choices& job, std::size_t item, const Choices& edited) {
  base::require(edited.items.size() == 1, "withItem: the choices of one item");
  Choices next = edited;
  next.items = job.items;
  next.item(item) = edited.item();
  const ItemChoices &before = job.item(item), &after = edited.item();
  const std::set<std::string> changed = changedParameters(before, after);
  for (std::size_t i = 0; i < next.items.size(); ++i) {
    if (i == item)
      continue;
    for (const std::string& key : changed)
      if (isOfJob(key))
        takeParameter(next.item(i), after, key);
    const modes::Mode* mode = modes::modeNamed(next.item(i).mode);
    if (after.platform != before.platform && mode && after.platform.isForAnyOf(mode->platforms)) {
      next.item(i).platform = after.platform;
      next.item(i).platformStays = after.platformStays && next.item(i).automatic;
    }
  }
  return next;
}

Choices withNewItem(const Choices& job, std::size_t item, const ItemChoices& usual) {
  const ItemChoices& like = job.item(item);
  ItemChoices made = usual;
  made.automatic = like.automatic;
  made.platformStays = like.platformStays;
  made.automaticWay = like.automaticWay;
  made.mode = like.mode;
  made.growth = like.growth;
  made.platform = like.platform;
  made.parameters.clear();
  for (const auto& [key, text] : like.parameters)
    if (isOfJob(key))
      made.parameters[key] = text;
  Choices next = job;
  next.items.push_back(std::move(made));
  return next;
}

} // namespace voluta::document
