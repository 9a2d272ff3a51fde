#include "pipeline/remedies.h"

#include "base/parameters.h"
#include "pipeline/choices.h"
#include "pipeline/road.h"

#include <algorithm>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

constexpr double kRoomMm = 20.0;

// None where the value is what it is already, or no stage knows the parameter.
std::optional<Cure> withParameter(const project::Choices& choices, const std::string& key,
                                  const std::string& value) {
  const base::ParameterTable table = allParameters();
  const base::ParameterSpec* spec = table.find(key);
  if (!spec)
    return std::nullopt;
  const auto chosen = choices.parameters.find(key);
  const std::string now = chosen == choices.parameters.end()
                              ? base::formatParameter(spec->defaultValue)
                              : chosen->second;
  if (now == value)
    return std::nullopt;
  Cure cure{choices, value};
  cure.choices.parameters[key] = value;
  return cure;
}

std::optional<Cure> addSupports(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "supports", "auto");
}

std::optional<Cure> turnLeastRisky(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "orient", "leastRisky");
}

// Room for supports beside the part.
std::optional<Cure> widenPlatform(const plan::Finding&, const project::Choices& choices) {
  const std::optional<double> margin = choices.platform.marginMm();
  if (!margin || *margin >= kRoomMm)
    return std::nullopt;
  Cure cure{choices, {}};
  cure.choices.platform = choices.platform.withMarginMm(kRoomMm);
  return cure;
}

// The parameter is for layers that are planes.
std::optional<Cure> adaptLayers(const plan::Finding&, const project::Choices& choices) {
  if (choices.mode != "planar" && choices.mode != "flat")
    return std::nullopt;
  return withParameter(choices, "adaptiveLayers", "true");
}

std::optional<Cure> turnPart(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "orient", "fewestMissed");
}

// Voxels are shadowed by a front that spans the platform: the least one is the contact area.
std::optional<Cure> shrinkPlatform(const plan::Finding&, const project::Choices& choices) {
  Cure cure{choices, {}};
  cure.choices.platform = project::Platform::madeForPart(0.0);
  if (cure.choices.platform == choices.platform)
    return std::nullopt;
  return cure;
}

std::optional<Cure> narrowVoxels(const plan::Finding& finding, const project::Choices& choices) {
  const std::optional<double> width = finding.remedyMm;
  if (!width || *width >= parameterValues(choices).number("voxelMm"))
    return std::nullopt;
  return withParameter(choices, "voxelMm", base::formatParameter(*width));
}

std::optional<Cure> dropToPlate(const plan::Finding&, const project::Choices& choices) {
  if (choices.placement.liftMm == 0.0)
    return std::nullopt;
  Cure cure{choices, {}};
  cure.choices.placement.liftMm = 0.0;
  return cure;
}

} // namespace

const std::vector<Remedy>& remedies() {
  static const std::vector<Remedy> kRemedies{
      {"dropToPlate", "Drop to plate", {"unreachedVoxels", kStopped}, dropToPlate},
      {"shrinkPlatform", "Shrink platform", {"shadowedVoxels", "missedVoxels"}, shrinkPlatform},
      {"addSupports",
       "Add supports",
       {"shadowedVoxels", "unreachedVoxels", "missedVoxels", "overhang", "beginsInAir"},
       addSupports},
      {"widenPlatform", "Widen the platform", {"unheldOverhang"}, widenPlatform},
      {"adaptLayers", "Adapt the layers", {"uncovered"}, adaptLayers},
      {"turnLeastRisky",
       "Turn the part",
       {"overhang", "beginsInAir", "uniformMisses", "unheldOverhang"},
       turnLeastRisky},
      {"turnPart",
       "Turn the part",
       {"shadowedVoxels", "unreachedVoxels", "missedVoxels"},
       turnPart},
      {"narrowVoxels", "Use voxel width %1 mm", {"thinWalls"}, narrowVoxels}};
  return kRemedies;
}

std::vector<Offer> remediesFor(const plan::Finding& finding, const project::Choices& choices) {
  std::vector<Offer> offers;
  for (const Remedy& remedy : remedies())
    if (std::find(remedy.kinds.begin(), remedy.kinds.end(), finding.kind) != remedy.kinds.end())
      if (std::optional<Cure> cure = remedy.cure(finding, choices))
        offers.push_back({remedy.id, remedy.label, std::move(*cure)});
  return offers;
}

} // namespace voluta::pipeline
