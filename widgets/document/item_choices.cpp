#include "document/item_choices.h"

#include "base/error.h"
#include "modes/mode_table.h"
#include "pipeline/presets/chosen_preset.h"

#include <utility>

namespace voluta::document {

using project::Choices;
using project::ItemChoices;

Choices withItem(const Choices& job, std::size_t item, const Choices& edited) {
  base::require(edited.items.size() == 1, "withItem: the choices of one item");
  Choices next = edited;
  next.items = job.items;
  next.item(item) = edited.item();
  const ItemChoices &before = job.item(item), &after = edited.item();
  for (std::size_t i = 0; i < next.items.size(); ++i) {
    if (i == item)
      continue;
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
  made.automaticStrategy = like.automaticStrategy;
  made.mode = like.mode;
  made.growth = like.growth;
  made.platform = like.platform;
  made.parameters = pipeline::itemSettingsOfPreset(job);
  Choices next = job;
  next.items.push_back(std::move(made));
  return next;
}

Choices withPresetOr(const Choices& choices, const std::string& preset) {
  try {
    return pipeline::withPreset(choices, preset);
  } catch (const base::Error&) {
    return choices;
  }
}

} // namespace voluta::document
