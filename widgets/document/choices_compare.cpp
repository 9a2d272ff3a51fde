#include "document/choices_compare.h"

#include <algorithm>
#include <tuple>

namespace voluta::document {

using project::Choices;

namespace {

bool sameItem(const project::ItemChoices& a, const project::ItemChoices& b) {
  const auto tied = [](const project::ItemChoices& c) {
    return std::tie(c.automatic, c.platformStays, c.automaticStrategy, c.mode, c.growth, c.platform,
                    c.scale, c.units, c.repair, c.parameters, c.regions, c.placement.liftMm);
  };
  return tied(a) == tied(b) && a.placement.centreMm == b.placement.centreMm &&
         a.placement.rotation.coeffs() == b.placement.rotation.coeffs();
}

} // namespace

bool sameChoices(const Choices& a, const Choices& b) {
  const auto tied = [](const Choices& c) {
    return std::tie(c.cell, c.tools, c.formats, c.seed, c.printOrder, c.preset, c.parameters);
  };
  return tied(a) == tied(b) && std::ranges::equal(a.items, b.items, sameItem);
}

bool losesSettings(const Choices& now, const Choices& next) {
  const auto tied = [](const Choices& c) {
    return std::tie(c.item().automatic, c.item().platformStays, c.item().growth, c.cell, c.tools,
                    c.item().units, c.item().repair, c.item().parameters, c.item().regions, c.seed,
                    c.parameters);
  };
  const bool sameStrategy =
      now.item().automatic || std::tie(now.item().mode, now.item().platform) ==
                                  std::tie(next.item().mode, next.item().platform);
  return !sameStrategy || tied(now) != tied(next);
}

} // namespace voluta::document
