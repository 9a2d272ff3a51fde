#include "document/choices_compare.h"

#include <tuple>

namespace voluta::document {

using project::Choices;

bool sameChoices(const Choices& a, const Choices& b) {
  const auto tied = [](const Choices& c) {
    return std::tie(c.automatic, c.platformStays, c.automaticWay, c.mode, c.growth, c.platform,
                    c.cell, c.process, c.scale, c.units, c.repair, c.formats, c.parameters, c.seed,
                    c.placement.liftMm);
  };
  return tied(a) == tied(b) && a.placement.centreMm == b.placement.centreMm &&
         a.placement.rotation.coeffs() == b.placement.rotation.coeffs();
}

bool losesSettings(const Choices& now, const Choices& next) {
  const auto tied = [](const Choices& c) {
    return std::tie(c.automatic, c.platformStays, c.growth, c.cell, c.process, c.units, c.repair,
                    c.parameters, c.seed);
  };
  const bool sameWay =
      now.automatic || std::tie(now.mode, now.platform) == std::tie(next.mode, next.platform);
  return !sameWay || tied(now) != tied(next);
}

} // namespace voluta::document
