#include "document/choices_compare.h"

#include <tuple>

namespace voluta::document {

using project::Choices;

bool sameChoices(const Choices& a, const Choices& b) {
  const auto tied = [](const Choices& c) {
    return std::tie(c.item().automatic, c.item().platformStays, c.item().automaticWay,
                    c.item().mode, c.item().growth, c.item().platform, c.cell, c.tool().process,
                    c.item().scale, c.item().units, c.item().repair, c.formats, c.item().parameters,
                    c.seed, c.item().placement.liftMm);
  };
  return tied(a) == tied(b) && a.item().placement.centreMm == b.item().placement.centreMm &&
         a.item().placement.rotation.coeffs() == b.item().placement.rotation.coeffs();
}

bool losesSettings(const Choices& now, const Choices& next) {
  const auto tied = [](const Choices& c) {
    return std::tie(c.item().automatic, c.item().platformStays, c.item().growth, c.cell,
                    c.tool().process, c.item().units, c.item().repair, c.item().parameters, c.seed);
  };
  const bool sameWay = now.item().automatic || std::tie(now.item().mode, now.item().platform) ==
                                                   std::tie(next.item().mode, next.item().platform);
  return !sameWay || tied(now) != tied(next);
}

} // namespace voluta::document
