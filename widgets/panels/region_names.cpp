#include "panels/region_names.h"

#include "base/error.h"
#include "language/words.h"
#include "regions/region_kinds.h"

#include <optional>

namespace voluta::panels {

namespace {
// Returns the shape of a region; nullopt: its text is invalid.
std::optional<regions::Shape> shapeIn(const project::Region& region) {
  try {
    return regions::parsedShape(region.shape);
  } catch (const base::Error&) {
    return std::nullopt;
  }
}
} // namespace

QString nameOfRegion(const std::vector<project::Region>& regions, std::size_t region) {
  const project::Region& one = regions.at(region);
  if (!one.name.empty())
    return QString::fromStdString(one.name);
  const auto shape = shapeIn(one);
  if (!shape)
    return QString::fromStdString(one.shape);
  if (!shape->file.empty())
    return QString::fromStdString(shape->file);
  int number = 1;
  for (std::size_t i = 0; i < region; ++i) {
    const auto other = shapeIn(regions[i]);
    number += other && other->kind == shape->kind && regions[i].name.empty() ? 1 : 0;
  }
  const QString label = language::heading(shape->kind->label);
  return number == 1 ? label : QStringLiteral("%1 %2").arg(label).arg(number);
}

} // namespace voluta::panels
