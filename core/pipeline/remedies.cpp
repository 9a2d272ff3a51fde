#include "pipeline/remedies.h"

#include "base/outcome.h"
#include "base/parameters.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/choices.h"
#include "pipeline/larger_cell.h"
#include "plan/finding_kinds.h"
#include "project/turn_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::pipeline {

namespace {

constexpr double kRoomMm = 20.0;

using Edited = std::optional<project::Choices>;

// In mode auto any of its ways may take a parameter.
bool takes(const project::Choices& choices, const std::string& key) {
  const modes::Mode* mode = modes::modeNamed(choices.item().mode);
  return choices.item().automatic || (mode && modes::takesParameter(*mode, key));
}

// None where the value is what it is already, or no stage knows the parameter.
std::optional<project::Choices> withParameter(const project::Choices& choices,
                                              const std::string& key, const std::string& value) {
  const base::ParameterTable table = parametersOf(choices);
  const base::ParameterSpec* spec = table.find(key);
  if (!spec || !takes(choices, key))
    return std::nullopt;
  // In mode auto the way that was taken has values of its own.
  const std::map<std::string, std::string> taken = resolved(choices).item().parameters;
  const auto chosen = taken.find(key);
  const std::string now =
      chosen == taken.end() ? base::formatParameter(spec->defaultValue) : chosen->second;
  if (now == value)
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().parameters[key] = value;
  return changed;
}

std::optional<project::Choices> thickenSurface(const plan::Finding&,
                                               const project::Choices& choices) {
  return withParameter(choices, "openSurfaces", "thicken");
}

std::optional<project::Choices> closeRims(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "openSurfaces", "close");
}

std::optional<project::Choices> addSupports(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "supports", "auto");
}

std::optional<project::Choices> turnLeastRisky(const plan::Finding&,
                                               const project::Choices& choices) {
  return withParameter(choices, "orient", "leastRisky");
}

// The value times `factor` within the parameter's range and `limit`; none where it is there
// already.
Edited withMultiple(const project::Choices& choices, const std::string& key, double factor,
                    double limit) {
  const base::ParameterValues values = parameterValues(choices);
  const base::ParameterSpec* spec = values.table().find(key);
  const bool whole = spec->type == base::ParameterType::Integer;
  const double now = whole ? static_cast<double>(values.integer(key)) : values.number(key);
  const double wanted = factor > 1.0 ? std::min({now * factor, limit, spec->maximum})
                                     : std::max({now * factor, limit, spec->minimum});
  if (factor > 1.0 ? wanted <= now : wanted >= now)
    return std::nullopt;
  return withParameter(choices, key,
                       whole ? base::formatParameter(static_cast<long long>(wanted))
                             : base::formatParameter(wanted));
}

Edited moreTurns(const plan::Finding&, const project::Choices& choices) {
  constexpr double kMost = 72.0;
  return withMultiple(choices, "redundancySamples", 2.0, kMost);
}

constexpr double kLeastClearanceMm = 0.5, kMostClearanceMm = 20.0;

// Of the arm and of the part; none where neither changes.
Edited withClearances(const project::Choices& choices, double factor, double limit) {
  const Edited arm = withMultiple(choices, "bodyClearanceMm", factor, limit);
  const Edited part = withMultiple(arm ? *arm : choices, "partClearanceMm", factor, limit);
  return part ? part : arm;
}

Edited lessClearance(const plan::Finding&, const project::Choices& choices) {
  return withClearances(choices, 0.5, kLeastClearanceMm);
}

Edited moreClearance(const plan::Finding&, const project::Choices& choices) {
  return withClearances(choices, 2.0, kMostClearanceMm);
}

// Half as high, as far as the process goes.
Edited lowerLayers(const plan::Finding&, const project::Choices& choices) {
  const process::Process p = chosenProcess(choices, parameterValues(choices));
  const double wanted = std::max(0.5 * p.layerHeightMm, p.layerHeightMinMm);
  if (wanted >= p.layerHeightMm)
    return std::nullopt;
  return withParameter(choices, "layerHeightMm", base::formatParameter(wanted));
}

// Waypoints are as far apart as the process says, unless the user says otherwise.
Edited withSteps(const project::Choices& choices, double factor, double limit) {
  const double now = chosenProcess(choices, parameterValues(choices)).stepMm;
  const double wanted =
      factor > 1.0 ? std::min(now * factor, limit) : std::max(now * factor, limit);
  if (factor > 1.0 ? wanted <= now : wanted >= now)
    return std::nullopt;
  return withParameter(choices, "stepMm", base::formatParameter(wanted));
}

Edited longerMotions(const plan::Finding&, const project::Choices& choices) {
  constexpr double kLongestMm = 4.0;
  return withSteps(choices, 2.0, kLongestMm);
}

Edited shorterMotions(const plan::Finding&, const project::Choices& choices) {
  constexpr double kShortestMm = 0.25;
  return withSteps(choices, 0.5, kShortestMm);
}

// In mode auto too it is then the user's. None where it is that already, or the mode builds on
// other things than plates.
Edited withPlatform(const project::Choices& choices, const project::Platform& platform) {
  const modes::Mode* mode = modes::modeNamed(choices.item().mode);
  if (!mode || !platform.isForAnyOf(mode->platforms) || choices.item().platform.isBody() ||
      choices.item().platform == platform)
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().platform = platform;
  changed.item().platformStays = choices.item().automatic;
  return changed;
}

// Room for supports beside the part.
std::optional<project::Choices> widenPlatform(const plan::Finding&,
                                              const project::Choices& choices) {
  const std::optional<double> margin = choices.item().platform.marginMm();
  if (!margin || *margin >= kRoomMm)
    return std::nullopt;
  return withPlatform(choices, choices.item().platform.withMarginMm(kRoomMm));
}

// One with room for supports, on a stem of its own.
Edited makePlatform(const plan::Finding&, const project::Choices& choices) {
  return choices.item().platform.marginMm()
             ? std::nullopt
             : withPlatform(choices, project::Platform::madeForPart(kRoomMm));
}

Edited cellPlate(const plan::Finding&, const project::Choices& choices) {
  return withPlatform(choices, project::Platform("cell"));
}

// The parameter is for layers that are planes.
std::optional<project::Choices> adaptLayers(const plan::Finding&, const project::Choices& choices) {
  constexpr const char* kAdaptive = "adaptiveLayers";
  const modes::Mode* mode = modes::modeNamed(choices.item().mode);
  if (!mode || !mode->requiresParameter(kAdaptive))
    return std::nullopt;
  return withParameter(choices, kAdaptive, "true");
}

std::optional<project::Choices> turnPart(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "orient", "fewestMissed");
}

// Voxels are shadowed by a front that spans the platform: the least one is the contact area.
std::optional<project::Choices> shrinkPlatform(const plan::Finding&,
                                               const project::Choices& choices) {
  return withPlatform(choices, project::Platform::madeForPart(0.0));
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
  if (choices.item().placement.liftMm == 0.0)
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().placement.liftMm = 0.0;
  return changed;
}

std::optional<project::Choices> standBest(const plan::Finding& finding,
                                          const project::Choices& choices) {
  const std::optional<double> x = numberOf(finding, "x"), y = numberOf(finding, "y"),
                              z = numberOf(finding, "z");
  if (!x || !y || !z)
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().placement.rotation = project::turnOfDegrees({*x, *y, *z});
  changed.item().placement.liftMm = 0.0;
  constexpr double kSame = 1e-6; // rad
  if (changed.item().placement.rotation.angularDistance(
          choices.item().placement.rotation.normalized()) < kSame)
    return std::nullopt;
  return changed;
}

std::optional<project::Choices> scaleAsTold(const plan::Finding& finding,
                                            const project::Choices& choices) {
  const std::optional<double> scale = numberOf(finding, "scale");
  if (!scale)
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().scale = base::formatParameter(*scale);
  return changed.item().scale == choices.item().scale ? std::nullopt : std::optional(changed);
}

// The widest bead that is narrow enough, or narrower than now: finer ones take longer.
std::optional<project::Choices> finerProcess(const plan::Finding& finding,
                                             const project::Choices& choices) {
  const std::optional<double> usual = numberOf(finding, "usual");
  std::optional<process::Process> best;
  const double now = process::loadProcess(choices.tool().process).beadWidthMinMm;
  for (const std::string& id : process::processIds()) {
    process::Process p = process::loadProcess(id);
    if ((!usual || p.beadWidthMinMm <= *usual) && p.beadWidthMinMm < now &&
        (!best || p.beadWidthMinMm > best->beadWidthMinMm))
      best = std::move(p);
  }
  if (!best)
    return std::nullopt;
  project::Choices changed = choices;
  changed.tool().process = best->id;
  return changed;
}

std::optional<project::Choices> withUnits(const project::Choices& choices, const char* units) {
  if (choices.item().units == units)
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().units = units;
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
  if (choices.item().scale == "fit")
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().scale = "fit";
  return changed;
}

// None where the size is not the user's own number.
Edited scaledBy(const project::Choices& choices, double factor) {
  const double scale = project::parsedScale(choices.item().scale);
  constexpr double kRound = 1e4;
  const double wanted = std::round(scale * factor * kRound) / kRound;
  if (wanted <= 0.0)
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().scale = base::formatParameter(wanted);
  return changed;
}

Edited shrink(const plan::Finding&, const project::Choices& choices) {
  return scaledBy(choices, 0.8);
}

Edited enlarge(const plan::Finding&, const project::Choices& choices) {
  return scaledBy(choices, 1.5);
}

Edited usualProcess(const plan::Finding&, const project::Choices& choices) {
  const modes::Mode* mode = modes::modeNamed(choices.item().mode);
  if (!mode || mode->usual.process == choices.tool().process)
    return std::nullopt;
  project::Choices changed = choices;
  changed.tool().process = mode->usual.process;
  return changed;
}

Edited withCell(const project::Choices& choices, const std::string& cell) {
  if (cell == choices.cell)
    return std::nullopt;
  project::Choices changed = choices;
  changed.cell = cell;
  return changed;
}

Edited usualCell(const plan::Finding&, const project::Choices& choices) {
  const modes::Mode* mode = modes::modeNamed(choices.item().mode);
  return mode ? withCell(choices, mode->usual.cell) : std::nullopt;
}

// Where the finding says how large a foot is to be carried, one that carries it.
Edited largerCell(const plan::Finding& finding, const project::Choices& choices) {
  const Eigen::Vector2d foot(numberOf(finding, "length").value_or(0.0),
                             numberOf(finding, "width").value_or(0.0));
  const std::optional<std::string> larger = cellWithLargerPlate(choices, foot);
  return larger ? withCell(choices, *larger) : std::nullopt;
}

std::optional<project::Choices> centrePart(const plan::Finding&, const project::Choices& choices) {
  if (choices.item().placement.centreMm == Eigen::Vector2d::Zero())
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().placement.centreMm.setZero();
  return changed;
}

std::optional<project::Choices> printFlat(const plan::Finding&, const project::Choices& choices) {
  const modes::Mode& flat = modes::findMode("flat");
  const modes::Mode* mode = modes::modeNamed(choices.item().mode);
  if (choices.item().mode == flat.id || !mode || mode->aroundRod ||
      !choices.item().platform.isForAnyOf(flat.platforms))
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().mode = flat.id;
  changed.item().automatic = changed.item().platformStays = false;
  if (choices.item().automatic) // as its way does
    changed.item().parameters.try_emplace("supports", "auto");
  return changed;
}

std::optional<project::Choices> chooseWay(const plan::Finding&, const project::Choices& choices) {
  if (choices.item().automatic || !choices.item().platform.isFor(project::PlatformUse::Plate))
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().automatic = true;
  return changed;
}

// From what mode auto does not try, on a rod or a body, to the plate of a usual cell.
Edited printOnPlate(const plan::Finding&, const project::Choices& choices) {
  if (std::ranges::any_of(automaticWays(),
                          [&](const AutomaticWay& way) { return way.mode == choices.item().mode; }))
    return std::nullopt;
  const modes::Defaults usual = modes::usualOnPlate();
  project::Choices changed = choices;
  changed.item().automatic = true;
  changed.item().platformStays = false;
  changed.item().mode = project::Choices().item().mode;
  changed.cell = usual.cell;
  changed.tool().process = usual.process;
  changed.item().platform = project::Platform("cell");
  changed.item().placement = {};
  return changed;
}

} // namespace

std::span<const Remedy> remedies() {
  using enum plan::RemedyId;
  static constexpr auto kRemedies = std::to_array<Remedy>(
      {{ThickenSurface, "thickenSurface", "Thicken to a wall"_text,
        "Two beads wide, half of it on either side of the surface"_text, thickenSurface},
       {CloseRims, "closeRims", "Close the rims"_text,
        "Flat patches over the rims: the part becomes solid"_text, closeRims},
       {DropToPlate, "dropToPlate", "Drop to plate"_text, "Lowest point on the plate"_text,
        dropToPlate},
       {ShrinkPlatform, "shrinkPlatform", "Shrink platform"_text,
        "To the area that the part stands on: the front spans less"_text, shrinkPlatform},
       {MakePlatform, "makePlatform", "Make a platform for the part"_text,
        "As wide as the part's foot and 20 mm more, on a stem of its own"_text, makePlatform},
       {CellPlate, "cellPlate", "Use the cell's plate"_text,
        "The smallest of the cell's plates that carries the part"_text, cellPlate},
       {AddSupports, "addSupports", "Add supports"_text,
        "Thin columns that break off, as few as can be"_text, addSupports},
       {WidenPlatform, "widenPlatform", "Widen the platform"_text,
        "By 20 mm all round, so that supports have something to stand on"_text, widenPlatform},
       {AdaptLayers, "adaptLayers", "Adapt the layers"_text,
        "Lower ones where the surface leans: steps leave less of it empty"_text, adaptLayers},
       {LowerLayers, "lowerLayers", "Print lower layers"_text,
        "Half as high, as far as the process goes"_text, lowerLayers},
       {MoreTurns, "moreTurns", "Try more turns"_text,
        "Twice as many turns about the nozzle at each place; planning takes longer"_text,
        moreTurns},
       {LessClearance, "lessClearance", "Allow less clearance"_text,
        "Half the distance that the arm keeps from itself and from the part"_text, lessClearance},
       {MoreClearance, "moreClearance", "Keep more clearance"_text,
        "Twice the distance that the arm keeps from itself and from the part"_text, moreClearance},
       {ShorterMotions, "shorterMotions", "Use shorter motions"_text,
        "Waypoints half as far apart; the program gets longer"_text, shorterMotions},
       {LongerMotions, "longerMotions", "Use longer motions"_text,
        "Waypoints twice as far apart"_text, longerMotions},
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
       {ScaleToPlate, "scaleToPlate", "Print at scale {scale}"_text,
        "As large as the cell's largest plate carries"_text, scaleAsTold},
       {Shrink, "shrink", "Print it smaller"_text, "A fifth smaller than now"_text, shrink},
       {Enlarge, "enlarge", "Print it larger"_text, "Half as large again"_text, enlarge},
       {UnitsMetres, "unitsMetres", "It is in metres"_text, "A thousand times as large"_text,
        unitsMetres},
       {UnitsInches, "unitsInches", "It is in inches"_text, "25.4 times as large"_text,
        unitsInches},
       {UnitsMicrometres, "unitsMicrometres", "It is in micrometres"_text,
        "A thousandth of the size"_text, unitsMicrometres},
       {CentrePart, "centrePart", "Centre the part"_text,
        "Over the middle of the platform's place"_text, centrePart},
       {UsualProcess, "usualProcess", "Use the usual process"_text,
        "Nozzle, head and material that this way of building comes with"_text, usualProcess},
       {UsualCell, "usualCell", "Use the usual cell"_text,
        "Robot and plate that this way of building comes with"_text, usualCell},
       {LargerCell, "largerCell", "Use a larger cell"_text, "The next one with a larger plate"_text,
        largerCell},
       {PrintFlat, "printFlat", "Print in flat layers"_text,
        "As an ordinary printer does, the nozzle upright throughout"_text, printFlat},
       {ChooseWay, "chooseWay", "Let Voluta choose"_text,
        "Tries the ways of building one after the other, until nothing hangs or is missed"_text,
        chooseWay},
       {PrintOnPlate, "printOnPlate", "Print on a plate"_text,
        "In a usual cell; Voluta chooses the way of building"_text, printOnPlate}});
  return kRemedies;
}

std::vector<RemedyAction> remediesFor(const plan::Finding& finding,
                                      const project::Choices& choices) {
  const std::span<const plan::RemedyId> wanted = plan::rowOf(finding.kind).remedies;
  std::vector<RemedyAction> offers;
  for (const Remedy& remedy : remedies()) {
    if (std::ranges::find(wanted, remedy.id) == wanted.end())
      continue;
    // Choices that cannot be planned as they are (a value beyond the process) leave some nothing to
    // go by.
    auto outcome = base::outcomeOf([&] { return remedy.cure(finding, choices); });
    auto* cured = std::get_if<Edited>(&outcome);
    if (!cured || !*cured)
      continue;
    base::Message label(remedy.label);
    for (const std::string_view name : base::placeNames(remedy.label.english()))
      label.values.push_back(*finding.value(name));
    offers.push_back({&remedy, std::move(label), std::move(**cured)});
  }
  return offers;
}

} // namespace voluta::pipeline
