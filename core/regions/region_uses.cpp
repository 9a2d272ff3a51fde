#include "regions/region_uses.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <algorithm>
#include <string>

namespace voluta::regions {

namespace {
std::vector<ShapeField> direction() {
  return {{"DX", "Direction X"_text, -1.0, 1.0, 0.0},
          {"DY", "Direction Y"_text, -1.0, 1.0, 0.0},
          {"DZ", "Direction Z"_text, -1.0, 1.0, 1.0}};
}

constexpr double kMostN = 1e6, kMostLayers = 1e6;

std::string_view idOf(std::string_view text) {
  return text.substr(0, text.find(':'));
}
// Throws Error{Usage} for a vector of no length.
Eigen::Vector3d vectorOf(std::string_view text) {
  const RegionUse& use = findUse(text);
  base::require(use.fields.size() == 3, "a use with a vector");
  const std::vector<double> numbers = parsedNumbers(text, use.fields, formOf(use));
  const Eigen::Vector3d vector(numbers[0], numbers[1], numbers[2]);
  if (vector.norm() < 1e-6)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("use '{text}' of a region has no direction"_text, text), {},
                      base::message("write {form}"_text, formOf(use)));
  return vector;
}
} // namespace

const std::vector<RegionUse>& regionUses() {
  static const std::vector<RegionUse> kUses{
      {.id = "settings", .label = "Own settings"_text},
      {.id = "cut", .label = "Cut away"_text, .cuts = true},
      {.id = "surface", .label = "Layers along the surface"_text, .layers = RegionLayers::Surface},
      {.id = "around", .label = "Layers around the rest"_text, .layers = RegionLayers::Around},
      {.id = "flat",
       .label = "Flat layers along a direction"_text,
       .layers = RegionLayers::Flat,
       .fields = direction()},
      {.id = "turn",
       .label = "Layers that turn to a direction"_text,
       .layers = RegionLayers::Turning,
       .fields = direction()},
      {.id = "insert",
       .label = "Inserted part"_text,
       .cuts = true,
       .isInsert = true,
       .fields = {{"LAYER", "Before layer (0: automatic)"_text, 0.0, kMostLayers, 0.0, true}}},
      {.id = "hold", .label = "Held under load"_text, .load = RegionLoad::Held},
      {.id = "load",
       .label = "Force on the part"_text,
       .load = RegionLoad::Force,
       .fields = {{"FX", "Force X"_text, -kMostN, kMostN, 0.0},
                  {"FY", "Force Y"_text, -kMostN, kMostN, 0.0},
                  {"FZ", "Force Z"_text, -kMostN, kMostN, -10.0}}},
  };
  return kUses;
}

std::string formOf(const RegionUse& use) {
  return use.fields.empty() ? std::string(use.id) : std::string(use.id) + ":" + formOf(use.fields);
}

const RegionUse& findUse(std::string_view text) {
  const std::string_view id = idOf(text);
  const auto found = std::ranges::find(regionUses(), id, &RegionUse::id);
  if (found == regionUses().end()) {
    std::vector<std::string> ids;
    for (const RegionUse& use : regionUses())
      ids.emplace_back(use.id);
    throw base::Error(base::ErrorCode::Usage,
                      base::message("unknown use '{name}' of a region"_text, id), {},
                      base::didYouMean(id, ids));
  }
  if (text.size() > id.size() || !found->fields.empty())
    parsedNumbers(text, found->fields, formOf(*found));
  return *found;
}

bool tiltHead(const std::vector<project::Region>& regions) {
  return std::ranges::any_of(regions, [](const project::Region& region) {
    const RegionLayers layers = findUse(region.use).layers;
    return layers == RegionLayers::Flat
               ? !directionOf(region.use).isApprox(Eigen::Vector3d::UnitZ(), 1e-6)
               : layers != RegionLayers::None;
  });
}

int layerOf(std::string_view text) {
  const RegionUse& use = findUse(text);
  base::require(use.isInsert, "a use as an insert");
  return static_cast<int>(parsedNumbers(text, use.fields, formOf(use))[0]);
}

Eigen::Vector3d directionOf(std::string_view text) {
  return vectorOf(text).normalized();
}

Eigen::Vector3d forceOf(std::string_view text) {
  base::require(findUse(text).load == RegionLoad::Force, "a use with a force");
  return vectorOf(text);
}

} // namespace voluta::regions
