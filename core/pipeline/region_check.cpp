#include "pipeline/region_check.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/parameters.h"
#include "geometry/triangle_mesh.h"
#include "modes/mode.h"
#include "modes/mode_table.h"
#include "project/choices.h"
#include "regions/region_kinds.h"
#include "regions/region_uses.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace voluta::pipeline {

namespace {
using base::Error;
using base::ErrorCode;
using project::Region;

void requireRegionSetting(const base::ParameterTable& table, const std::string& key,
                          const std::string& value) {
  const base::ParameterSpec* spec = table.find(key);
  if (spec && spec->scope == base::ParameterScope::Region) {
    base::parseParameter(*spec, value);
    return;
  }
  std::vector<std::string> keys;
  for (const base::ParameterSpec& known : table.specs())
    if (known.scope == base::ParameterScope::Region)
      keys.push_back(known.key);
  if (spec)
    throw Error(ErrorCode::Usage,
                base::message("{key} is a setting of the part, not of a region"_text, key), {},
                base::message("settings of a region: {keys}"_text,
                              fmt::format("{}", fmt::join(keys, ", "))));
  throw Error(ErrorCode::Usage, base::message("unknown parameter {key}"_text, key), {},
              base::didYouMean(key, keys));
}
// Throws if a region asks for supports that it cannot have.
void requireSupports(const project::ItemChoices& item, const Region& region,
                     const regions::RegionUse& use) {
  const auto own = region.parameters.find("supports");
  if (own == region.parameters.end() || own->second == "none")
    return;
  const modes::Mode* mode = modes::modeNamed(item.mode);
  if (mode && !item.automatic && !mode->requiresParameter("supports"))
    throw Error(
        ErrorCode::Usage,
        base::message("region {region} asks for supports, which mode {mode} does not have"_text,
                      region.shape, item.mode),
        {}, "set `supports=none` for the region, or choose another mode"_text);
  if (use.hasLayers())
    throw Error(ErrorCode::Usage,
                base::message("region {region} asks for supports: its own layers have none"_text,
                              region.shape),
                {}, "use a region of its own for the supports, whose use is settings"_text);
}
} // namespace

void checkRegions(const project::ItemChoices& item, const base::ParameterTable& table) {
  for (const Region& region : item.regions) {
    const regions::Shape shape = regions::parsedShape(region.shape);
    const regions::RegionUse& use = regions::findUse(region.use);
    if (shape.kind->mesh == regions::ShapeMesh::File && !region.mesh)
      throw Error(ErrorCode::Usage, base::message("region {region} has no mesh"_text, region.shape),
                  {}, "add it from its file again"_text);
    if (use.layers == regions::RegionLayers::Turning &&
        regions::directionOf(region.use).cross(Eigen::Vector3d::UnitZ()).norm() < 1e-3)
      throw Error(ErrorCode::Usage,
                  base::message("layers of region {region} turn to a vertical direction"_text,
                                region.shape),
                  {}, "give a tilted direction"_text);
    if (use.layers == regions::RegionLayers::Surface && !regions::followsSurface(*shape.kind))
      throw Error(
          ErrorCode::Usage,
          base::message("region {region} follows no surface: it has no layers of its own"_text,
                        region.shape),
          {}, "give it as a skin or a painted surface, or use it for settings"_text);
    if (use.load == regions::RegionLoad::Force)
      regions::forceOf(region.use);
    for (const auto& [key, value] : region.parameters)
      requireRegionSetting(table, key, value);
    if (use.load != regions::RegionLoad::None && !region.parameters.empty())
      throw Error(
          ErrorCode::Usage,
          base::message("region {region} carries the load: it has no settings"_text, region.shape),
          {}, "add a second region of that shape for its settings"_text);
    requireSupports(item, region, use);
  }
  const modes::Mode* mode = modes::modeNamed(item.mode);
  if (mode && mode->onPart && !item.automatic && !item.regions.empty())
    throw Error(ErrorCode::Usage,
                base::message("mode {mode} prints on the part: it has no regions"_text, item.mode),
                {}, "remove the regions, or choose another mode"_text);
}

} // namespace voluta::pipeline
