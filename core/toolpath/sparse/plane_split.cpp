#include "toolpath/sparse/plane_split.h"

#include "process/bead_model.h"
#include "toolpath/plane/connected_parts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voluta::toolpath {

namespace {
using ClipperLib::Paths;
using geometry::combined;
using geometry::offsetPaths;

constexpr double kArcMm = 0.01; // chord error of round corners
constexpr double kSliver = 0.2; // [hatches]: half the width of skins that are left out
constexpr double kSmallestMm2 = 1e-4;

Paths moved(const Paths& paths, double byMm) {
  return offsetPaths(paths, byMm, {kArcMm});
}

// Returns the part of `area` that has the layers of a skin on one side.
Paths below(const PlaneLevels& levels, std::size_t index, int sign, int wanted, double skinMm,
            Paths area) {
  if (wanted == 0)
    return area;
  const PlanePatch& patch = *levels.patch(index);
  const int enough = skinLayers(wanted, skinMm, patch.thicknessMm);
  const auto found = levels.from(index, sign, enough);
  int count = 0;
  for (const PlaneLevels::Level* level : found) {
    area = combined(area, levels.outline(*level), ClipperLib::ctIntersection);
    ++count;
    if (area.empty() || (count >= wanted && std::abs(level->middleMm - patch.heightMm) >= skinMm))
      return area;
  }
  return count >= enough ? area : Paths{};
}

// Returns the connected parts of `area` that are at least `widthMm` wide somewhere.
Paths wideParts(const Paths& area, double widthMm) {
  Paths wide;
  for (const Paths& part : connectedParts(area))
    if (!moved(part, -0.5 * widthMm).empty())
      wide.insert(wide.end(), part.begin(), part.end());
  return wide;
}
} // namespace

int skinLayers(int layers, double skinMm, double thicknessMm) {
  return std::max(layers, static_cast<int>(std::ceil(skinMm / thicknessMm - 1e-6)));
}

Paths sparseArea(const PlaneLevels& levels, std::size_t index, const process::Process& process,
                 const ToolpathOptions& o) {
  const double hatch = process::hatchOf(process.beadWidthMm, process.layerHeightMm);
  const Paths inside = moved(levels.patch(index)->outline, -o.walls * hatch);
  if (moved(inside, -0.5 * kMinSparse * hatch).empty())
    return {};
  const Paths core = below(levels, index, -1, o.bottomLayers, o.skinMm,
                           below(levels, index, 1, o.topLayers, o.skinMm, inside));
  if (core.empty())
    return {};
  const Paths skin = moved(combined(inside, core, ClipperLib::ctDifference), -kSliver * hatch);
  const Paths area = skin.empty()
                         ? inside
                         : combined(inside, moved(skin, (kSliver + kSkinExtension) * hatch),
                                    ClipperLib::ctDifference);
  Paths wide = wideParts(area, kMinSparse * hatch);
  std::erase_if(wide, [](const ClipperLib::Path& path) {
    return std::abs(geometry::areaMm2({path})) < kSmallestMm2;
  });
  return wide;
}

} // namespace voluta::toolpath
