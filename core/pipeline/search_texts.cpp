#include "pipeline/search_texts.h"

#include "base/error.h"
#include "project/platform.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {

base::Message valuesText(const project::ChosenReport& chosen) {
  const base::Message platform = project::Platform(chosen.platform).shown();
  const base::Quantity height = base::mm(chosen.layerHeightMm);
  if (chosen.supports.empty())
    return base::message("layer height {height}, platform: {platform}"_text, height, platform);
  const base::Text supports = chosen.supports == "none" ? "none"_text : "auto"_text;
  return base::message("layer height {height}, supports: {supports}, platform: {platform}"_text,
                       height, supports, platform);
}

} // namespace

base::Message tryingText(const StrategyProgress& strategy) {
  return base::message("Trying {way} ({number} of {count})"_text, strategy.name, strategy.number,
                       strategy.count);
}

base::Message chosenText(const project::ItemReport& item) {
  base::require(!item.tried.empty(), "chosenText: a plan of mode auto");
  const base::Message values = valuesText(item.chosen);
  return std::ranges::any_of(item.tried, &project::TriedReport::passed)
             ? base::message("Chosen: {way} ({values})"_text, item.chosen.name, values)
             : base::message(
                   "No way of building passes; the best one is shown: {way} ({values})"_text,
                   item.chosen.name, values);
}

std::vector<base::Message> rejectedTexts(const project::ItemReport& item) {
  std::vector<base::Message> rejected;
  for (const project::TriedReport& tried : item.tried)
    if (!tried.taken)
      rejected.push_back(base::message("{way}: {reason}"_text, tried.name, tried.reason));
  return rejected;
}

} // namespace voluta::pipeline
