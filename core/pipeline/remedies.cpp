#include "pipeline/remedies.h"

#include "base/parameters.h"
#include "modes/mode_table.h"
#include "pipeline/choices.h"
#include "pipeline/road.h"
#include "plan/finding_kinds.h"
#include "project/turn_text.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

constexpr double kRoomMm = 20.0;

// None where the value is what it is already, or no stage knows the parameter.
std::optional<project::Choices> withParameter(const project::Choices& choices,
                                              const std::string& key, const std::string& value) {
  const base::ParameterTable table = parametersOf(choices.mode);
  const base::ParameterSpec* spec = table.find(key);
  if (!spec)
    return std::nullopt;
  const auto chosen = choices.parameters.find(key);
  const std::string now = chosen == choices.parameters.end()
                              ? base::formatParameter(spec->defaultValue)
                              : chosen->second;
  if (now == value)
    return std::nullopt;
  project::Choices changed = choices;
  changed.parameters[key] = value;
  return changed;
}

std::optional<project::Choices> addSupports(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "supports", "auto");
}

std::optional<project::Choices> turnLeastRisky(const plan::Finding&,
                                               const project::Choices& choices) {
  return withParameter(choices, "orient", "leastRisky");
}

// Room for supports beside the part.
std::optional<project::Choices> widenPlatform(const plan::Finding&,
                                              const project::Choices& choices) {
  const std::optional<double> margin = choices.platform.marginMm();
  if (!margin || *margin >= kRoomMm)
    return std::nullopt;
  project::Choices changed = choices;
  changed.platform = choices.platform.withMarginMm(kRoomMm);
  return changed;
}

// The parameter is for layers that are planes.
std::optional<project::Choices> adaptLayers(const plan::Finding&, const project::Choices& choices) {
  constexpr const char* kAdaptive = "adaptiveLayers";
  const modes::Mode* mode = modes::modeNamed(choices.mode);
  if (!mode || !mode->asksFor(kAdaptive))
    return std::nullopt;
  return withParameter(choices, kAdaptive, "true");
}

std::optional<project::Choices> turnPart(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "orient", "fewestMissed");
}

// Voxels are shadowed by a front that spans the platform: the least one is the contact area.
std::optional<project::Choices> shrinkPlatform(const plan::Finding&,
                                               const project::Choices& choices) {
  project::Choices changed = choices;
  changed.platform = project::Platform::madeForPart(0.0);
  if (changed.platform == choices.platform)
    return std::nullopt;
  return changed;
}

// "0.35 mm" is a value's number, in its own unit.
std::optional<double> numberOf(const plan::Finding& finding, std::string_view name) {
  const base::Value* value = finding.value(name);
  if (!value)
    return std::nullopt;
  if (const auto* quantity = std::get_if<base::Quantity>(&value->data()))
    return quantity->number;
  return std::nullopt;
}

std::optional<project::Choices> narrowVoxels(const plan::Finding& finding,
                                             const project::Choices& choices) {
  const std::optional<double> fits = numberOf(finding, "fits");
  if (!fits || *fits >= parameterValues(choices).number("voxelMm"))
    return std::nullopt;
  return withParameter(choices, "voxelMm", base::formatParameter(*fits));
}

std::optional<project::Choices> dropToPlate(const plan::Finding&, const project::Choices& choices) {
  if (choices.placement.liftMm == 0.0)
    return std::nullopt;
  project::Choices changed = choices;
  changed.placement.liftMm = 0.0;
  return changed;
}

std::optional<project::Choices> standBest(const plan::Finding& finding,
                                          const project::Choices& choices) {
  const std::optional<double> x = numberOf(finding, "x"), y = numberOf(finding, "y"),
                              z = numberOf(finding, "z");
  if (!x || !y || !z)
    return std::nullopt;
  project::Choices changed = choices;
  changed.placement.rotation = project::turnOfDegrees({*x, *y, *z});
  changed.placement.liftMm = 0.0;
  constexpr double kSame = 1e-6; // rad
  if (changed.placement.rotation.angularDistance(choices.placement.rotation.normalized()) < kSame)
    return std::nullopt;
  return changed;
}

std::optional<project::Choices> scaleAsTold(const plan::Finding& finding,
                                            const project::Choices& choices) {
  const std::optional<double> scale = numberOf(finding, "scale");
  if (!scale)
    return std::nullopt;
  project::Choices changed = choices;
  changed.scale = base::formatParameter(*scale);
  return changed.scale == choices.scale ? std::nullopt : std::optional(changed);
}

// The widest bead that is narrow enough: finer ones take longer.
std::optional<project::Choices> finerProcess(const plan::Finding& finding,
                                             const project::Choices& choices) {
  const std::optional<double> usual = numberOf(finding, "usual");
  std::optional<process::Process> best;
  const double now = process::loadProcess(choices.process).beadWidthMinMm;
  for (const std::string& id : process::processIds()) {
    process::Process p = process::loadProcess(id);
    if (usual && p.beadWidthMinMm <= *usual && p.beadWidthMinMm < now &&
        (!best || p.beadWidthMinMm > best->beadWidthMinMm))
      best = std::move(p);
  }
  if (!best)
    return std::nullopt;
  project::Choices changed = choices;
  changed.process = best->id;
  return changed;
}

std::optional<project::Choices> withUnits(const project::Choices& choices, const char* units) {
  if (choices.units == units)
    return std::nullopt;
  project::Choices changed = choices;
  changed.units = units;
  return changed;
}
std::optional<project::Choices> unitsMetres(const plan::Finding&, const project::Choices& choices) {
  return withUnits(choices, "m");
}
std::optional<project::Choices> unitsInches(const plan::Finding&, const project::Choices& choices) {
  return withUnits(choices, "in");
}
std::optional<project::Choices> unitsMicrometres(const plan::Finding&,
                                                 const project::Choices& choices) {
  return withUnits(choices, "um");
}

std::optional<project::Choices> scaleToFit(const plan::Finding&, const project::Choices& choices) {
  if (choices.scale == "fit")
    return std::nullopt;
  project::Choices changed = choices;
  changed.scale = "fit";
  return changed;
}

std::optional<project::Choices> centrePart(const plan::Finding&, const project::Choices& choices) {
  if (choices.placement.centreMm == Eigen::Vector2d::Zero())
    return std::nullopt;
  project::Choices changed = choices;
  changed.placement.centreMm.setZero();
  return changed;
}

std::optional<project::Choices> printFlat(const plan::Finding&, const project::Choices& choices) {
  if (choices.mode == "flat")
    return std::nullopt;
  project::Choices changed = choices;
  changed.mode = "flat";
  changed.automatic = false;
  return changed;
}

std::optional<project::Choices> chooseWay(const plan::Finding&, const project::Choices& choices) {
  if (choices.automatic)
    return std::nullopt;
  project::Choices changed = choices;
  changed.automatic = true;
  return changed;
}

} // namespace

std::span<const Remedy> remedies() {
  using enum plan::RemedyId;
  static constexpr auto kRemedies = std::to_array<Remedy>(
      {{DropToPlate, "dropToPlate", "Drop to plate"_text, "Lowest point on the plate"_text,
        dropToPlate},
       {ShrinkPlatform, "shrinkPlatform", "Shrink platform"_text,
        "To the area that the part stands on: the front spans less"_text, shrinkPlatform},
       {AddSupports, "addSupports", "Add supports"_text,
        "Thin columns that break off, as few as can be"_text, addSupports},
       {WidenPlatform, "widenPlatform", "Widen the platform"_text,
        "By 20 mm all round, so that supports have something to stand on"_text, widenPlatform},
       {AdaptLayers, "adaptLayers", "Adapt the layers"_text,
        "Lower ones where the surface leans: steps leave less of it empty"_text, adaptLayers},
       {TurnLeastRisky, "turnLeastRisky", "Turn the part"_text,
        "Searches the way to lie in which least area needs support"_text, turnLeastRisky},
       {TurnPart, "turnPart", "Turn the part"_text,
        "Searches the way to lie in which fewest voxels are missed"_text, turnPart},
       {StandBest, "standBest", "Stand it the best way"_text,
        "With the most contact for what leans over, and the fewest voxels missed"_text, standBest},
       {NarrowVoxels, "narrowVoxels", "Use voxel width {fits}"_text,
        "Narrow enough for this wall; narrower voxels take longer"_text, narrowVoxels},
       {ScaleUp, "scaleUp", "Print at scale {scale}"_text,
        "As large as the least bead needs it"_text, scaleAsTold},
       {FinerProcess, "finerProcess", "Use a finer process"_text,
        "With the widest bead that these walls have room for"_text, finerProcess},
       {ScaleToFit, "scaleToFit", "Scale to fit"_text, "As large as the robot reaches"_text,
        scaleToFit},
       {ScaleToReach, "scaleToReach", "Print at scale {scale}"_text,
        "As large as the robot gets to all of it"_text, scaleAsTold},
       {UnitsMetres, "unitsMetres", "It is in metres"_text, "A thousand times as large"_text,
        unitsMetres},
       {UnitsInches, "unitsInches", "It is in inches"_text, "25.4 times as large"_text,
        unitsInches},
       {UnitsMicrometres, "unitsMicrometres", "It is in micrometres"_text,
        "A thousandth of the size"_text, unitsMicrometres},
       {CentrePart, "centrePart", "Centre the part"_text,
        "Over the middle of the platform's place"_text, centrePart},
       {PrintFlat, "printFlat", "Print in flat layers"_text,
        "As an ordinary printer does, the nozzle upright throughout"_text, printFlat},
       {ChooseWay, "chooseWay", "Let Voluta choose"_text,
        "Tries the ways of building one after the other, until nothing hangs or is missed"_text,
        chooseWay}});
  return kRemedies;
}

std::vector<Offer> remediesFor(const plan::Finding& finding, const project::Choices& choices) {
  const std::span<const plan::RemedyId> cures = plan::rowOf(finding.kind).cures;
  std::vector<Offer> offers;
  for (const Remedy& remedy : remedies()) {
    if (std::find(cures.begin(), cures.end(), remedy.id) == cures.end())
      continue;
    std::optional<project::Choices> cured = remedy.cure(finding, choices);
    if (!cured)
      continue;
    base::Message label(remedy.label);
    for (const std::string_view name : base::placeNames(remedy.label.english()))
      label.values.push_back(*finding.value(name));
    offers.push_back({&remedy, std::move(label), std::move(*cured)});
  }
  return offers;
}

} // namespace voluta::pipeline
