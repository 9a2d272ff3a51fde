#include "pipeline/remedies.h"

#include "base/outcome.h"
#include "base/parameters.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/larger_cell.h"
#include "pipeline/quality.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "process/library.h"
#include "project/turn_text.h"
#include "regions/region_uses.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::pipeline {

namespace {

constexpr double kRoomMm = 20.0;

using Edited = std::optional<project::Choices>;

// In mode auto the parameter may be one of any way.
bool takes(const project::Choices& choices, const std::string& key) {
  const modes::Mode* mode = modes::modeNamed(choices.item().mode);
  return choices.item().automatic || (mode && modes::takesParameter(*mode, key));
}

// Returns nullopt if the parameter already has this value or no stage knows it.
std::optional<project::Choices> withParameter(const project::Choices& choices,
                                              const std::string& key, const std::string& value) {
  const base::ParameterTable table = parametersOf(choices);
  const base::ParameterSpec* spec = table.find(key);
  if (!spec || !takes(choices, key))
    return std::nullopt;
  // In mode auto the chosen way sets some parameters itself.
  const std::map<std::string, std::string> taken = givenParameters(resolved(choices));
  const auto chosen = taken.find(key);
  const std::string now =
      chosen == taken.end() ? base::formatParameter(spec->defaultValue) : chosen->second;
  if (now == value)
    return std::nullopt;
  project::Choices changed = choices;
  parametersOf(changed, spec->scope)[key] = value;
  return changed;
}

std::optional<project::Choices> thickenSurface(const plan::Finding&,
                                               const project::Choices& choices) {
  return withParameter(choices, "openSurfaces", "thicken");
}

std::optional<project::Choices> printAsWall(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "openSurfaces", "wall");
}

std::optional<project::Choices> closeRims(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "openSurfaces", "close");
}

std::optional<project::Choices> addSupports(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "supports", "auto");
}

std::optional<project::Choices> rotateToMinRiskyArea(const plan::Finding&,
                                                     const project::Choices& choices) {
  return withParameter(choices, "orient", "leastRisky");
}

// Multiplies the value by `factor`, within the parameter's range and `limit`. Returns nullopt if it
// is at that limit already.
Edited withMultiple(const project::Choices& choices, const std::string& key, double factor,
                    double limit) {
  const base::ParameterValues values = resolve(choices).values;
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
  constexpr double kMax = 72.0;
  return withMultiple(choices, "redundancySamples", 2.0, kMax);
}

constexpr double kMinClearanceMm = 0.5, kMaxClearanceMm = 20.0;

// Changes the clearances of arm and part. Returns nullopt if neither changes.
Edited withClearances(const project::Choices& choices, double factor, double limit) {
  const Edited arm = withMultiple(choices, "bodyClearanceMm", factor, limit);
  const Edited part = withMultiple(arm ? *arm : choices, "partClearanceMm", factor, limit);
  return part ? part : arm;
}

Edited lessClearance(const plan::Finding&, const project::Choices& choices) {
  return withClearances(choices, 0.5, kMinClearanceMm);
}

Edited moreClearance(const plan::Finding&, const project::Choices& choices) {
  return withClearances(choices, 2.0, kMaxClearanceMm);
}

// Halves the layer height, down to the process's minimum.
Edited lowerLayers(const plan::Finding&, const project::Choices& choices) {
  const process::Process p = resolve(choices).process();
  const double wanted = std::max(0.5 * p.layerHeightMm, p.layerHeightMinMm);
  if (wanted >= p.layerHeightMm)
    return std::nullopt;
  return withParameter(choices, "layerHeightMm", base::formatParameter(wanted));
}

// The waypoint spacing is that of the process unless the user sets it.
Edited withSteps(const project::Choices& choices, double factor, double limit) {
  const double now = resolve(choices).process().stepMm;
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

// Sets the platform; in mode auto it is then the user's choice. Returns nullopt if it is that
// platform already, or the mode does not build on plates.
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

// Makes room for supports beside the part.
std::optional<project::Choices> widenPlatform(const plan::Finding&,
                                              const project::Choices& choices) {
  const std::optional<double> margin = choices.item().platform.marginMm();
  if (!margin || *margin >= kRoomMm)
    return std::nullopt;
  return withPlatform(choices, choices.item().platform.withMarginMm(kRoomMm));
}

// Makes a platform with room for supports, on its own stem.
Edited makePlatform(const plan::Finding&, const project::Choices& choices) {
  return choices.item().platform.marginMm()
             ? std::nullopt
             : withPlatform(choices, project::Platform::madeForPart(kRoomMm));
}

Edited cellPlate(const plan::Finding&, const project::Choices& choices) {
  return withPlatform(choices, project::Platform("cell"));
}

// The parameter applies to planar layers only.
std::optional<project::Choices> adaptLayers(const plan::Finding&, const project::Choices& choices) {
  constexpr const char* kAdaptive = "adaptiveLayers";
  const modes::Mode* mode = modes::modeNamed(choices.item().mode);
  if (!mode || !mode->requiresParameter(kAdaptive))
    return std::nullopt;
  return withParameter(choices, kAdaptive, "true");
}

std::optional<project::Choices> orientPart(const plan::Finding&, const project::Choices& choices) {
  return withParameter(choices, "orient", "fewestMissed");
}

// A front that spans the platform shadows voxels; the smallest platform is the contact area.
std::optional<project::Choices> shrinkPlatform(const plan::Finding&,
                                               const project::Choices& choices) {
  return withPlatform(choices, project::Platform::madeForPart(0.0));
}

// Parses the number of a value such as "0.35 mm", in the value's unit.
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
  if (!fits || *fits >= resolve(choices).values.number("voxelMm"))
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
  changed.item().placement.rotation = project::rotationOfDegrees({*x, *y, *z});
  changed.item().placement.liftMm = 0.0;
  constexpr double kSame = 1e-6; // rad
  if (changed.item().placement.rotation.angularDistance(
          choices.item().placement.rotation.normalized()) < kSame)
    return std::nullopt;
  return changed;
}

std::optional<project::Choices> scaleAsStated(const plan::Finding& finding,
                                              const project::Choices& choices) {
  const std::optional<double> scale = numberOf(finding, "scale");
  if (!scale)
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().scale = base::formatParameter(*scale);
  return changed.item().scale == choices.item().scale ? std::nullopt : std::optional(changed);
}

// Chooses the process with the widest bead that is narrow enough, or narrower than now: finer
// processes take longer.
std::optional<project::Choices> finerProcess(const plan::Finding& finding,
                                             const project::Choices& choices) {
  const std::optional<double> usual = numberOf(finding, "usual");
  std::optional<process::Process> best;
  const double now = process::loadProcess(choices.tool(ownTool(choices)).process).beadWidthMinMm;
  for (const std::string& id : process::processIds()) {
    if (!process::comesWithProgram(process::Shelf::Processes, id))
      continue; // One of the user's own may be unreadable, or for another machine
    process::Process p = process::loadProcess(id);
    if ((!usual || p.beadWidthMinMm <= *usual) && p.beadWidthMinMm < now &&
        (!best || p.beadWidthMinMm > best->beadWidthMinMm))
      best = std::move(p);
  }
  if (!best)
    return std::nullopt;
  project::Choices changed = choices;
  changed.tool(ownTool(changed)).process = best->id;
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

// Returns nullopt if the user did not enter the scale as a number.
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
  if (!mode || mode->usual.process == choices.tool(ownTool(choices)).process)
    return std::nullopt;
  project::Choices changed = choices;
  changed.tool(ownTool(changed)).process = mode->usual.process;
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

// If the finding gives the size of a foot to be carried, chooses a cell that carries it.
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
  if (choices.item().automatic) // the process belongs to the way
    changed.item().parameters.try_emplace("supports", "auto");
  return changed;
}

std::optional<project::Choices> chooseStrategy(const plan::Finding&,
                                               const project::Choices& choices) {
  if (choices.item().automatic || !choices.item().platform.isFor(project::PlatformUse::Plate))
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().automatic = true;
  return changed;
}

// Changes from rods and bodies, which mode auto does not try, to the plate of a usual cell.
Edited printOnPlate(const plan::Finding&, const project::Choices& choices) {
  if (std::ranges::any_of(automaticStrategies(), [&](const AutomaticStrategy& strategy) {
        return strategy.mode == choices.item().mode;
      }))
    return std::nullopt;
  const modes::Defaults usual = modes::usualOnPlate();
  project::Choices changed = choices;
  changed.item().automatic = true;
  changed.item().platformStays = false;
  changed.item().mode = project::Choices().item().mode;
  changed.cell = usual.cell;
  changed.tool(ownTool(changed)).process = usual.process;
  changed.item().platform = project::Platform("cell");
  changed.item().placement = {};
  return changed;
}

Edited printByLayer(const plan::Finding&, const project::Choices& choices) {
  if (choices.items.size() == 1 || choices.printOrder == layers::PrintOrder::ByLayer)
    return std::nullopt;
  project::Choices changed = choices;
  changed.printOrder = layers::PrintOrder::ByLayer;
  return changed;
}

Edited acceptShare(const plan::Finding& finding, const project::Choices& choices) {
  const std::optional<std::string> accepted =
      acceptedWith(qualityOf(resolve(choices).values), finding);
  return accepted ? withParameter(choices, "accept", *accepted) : std::nullopt;
}

// Three layers along the upper surface.
Edited addSkin(const plan::Finding&, const project::Choices& choices) {
  const std::vector<project::Region>& regions = choices.item().regions;
  if (choices.item().mode != modes::findMode("flat").id)
    return std::nullopt;
  if (std::ranges::any_of(regions, [](const project::Region& region) {
        return regions::findUse(region.use).layers == regions::RegionLayers::Surface;
      }))
    return std::nullopt;
  project::Choices changed = choices;
  changed.item().regions.push_back(
      {.shape = "skin:" + base::formatParameter(3.0 * resolve(choices).process().layerHeightMm),
       .use = "surface"});
  return changed;
}

} // namespace

std::span<const Remedy> remedies() {
  using enum plan::RemedyId;
  static constexpr auto kRemedies = std::to_array<Remedy>(
      {{ThickenSurface, "thickenSurface", "Thicken to a wall"_text,
        "Two beads wide, centred on the surface"_text, thickenSurface},
       {WallSurface, "wallSurface", "Print as one wall"_text,
        "One bead wide, centred on the surface; its rims stay open"_text, printAsWall},
       {CloseRims, "closeRims", "Close the openings"_text,
        "Flat patches over the openings: the part becomes solid"_text, closeRims},
       {DropToPlate, "dropToPlate", "Drop to plate"_text, "Lowers the part onto the plate"_text,
        dropToPlate},
       {ShrinkPlatform, "shrinkPlatform", "Shrink platform"_text,
        "To the part's contact area, which narrows the front"_text, shrinkPlatform},
       {MakePlatform, "makePlatform", "Make a platform for the part"_text,
        "The part's footprint plus 20 mm, on its own stem"_text, makePlatform},
       {CellPlate, "cellPlate", "Use the cell's plate"_text,
        "The cell's smallest plate that carries the part"_text, cellPlate},
       {AddSupports, "addSupports", "Add supports"_text,
        "As few thin break-away columns as possible"_text, addSupports},
       {WidenPlatform, "widenPlatform", "Widen the platform"_text,
        "By 20 mm on all sides, to give supports a base"_text, widenPlatform},
       {AdaptLayers, "adaptLayers", "Adapt the layers"_text,
        "Thinner layers on sloping surfaces, to reduce the gaps at steps"_text, adaptLayers},
       {AddSkin, "addSkin", "Add a skin"_text,
        "Three curved layers along the upper surface, over the flat ones"_text, addSkin},
       {LowerLayers, "lowerLayers", "Print thinner layers"_text,
        "Half the layer height, within the process's range"_text, lowerLayers},
       {MoreTurns, "moreTurns", "Try more rotations"_text,
        "Twice as many rotations about the nozzle per point; planning takes longer"_text,
        moreTurns},
       {LessClearance, "lessClearance", "Allow less clearance"_text,
        "Half the distance of the arm from itself and from the part"_text, lessClearance},
       {MoreClearance, "moreClearance", "Keep more clearance"_text,
        "Twice the distance of the arm from itself and from the part"_text, moreClearance},
       {ShorterMotions, "shorterMotions", "Use shorter motions"_text,
        "Half the waypoint spacing; the program gets longer"_text, shorterMotions},
       {LongerMotions, "longerMotions", "Use longer motions"_text,
        "Twice the waypoint spacing"_text, longerMotions},
       {RotateToMinRiskyArea, "turnLeastRisky", "Turn the part"_text,
        "Searches the orientation with the smallest area to support"_text, rotateToMinRiskyArea},
       {OrientPart, "turnPart", "Turn the part"_text,
        "Searches the orientation with the fewest missed voxels"_text, orientPart},
       {StandBest, "standBest", "Use best orientation"_text,
        "Most contact relative to the overhang, and fewest missed voxels"_text, standBest},
       {NarrowVoxels, "narrowVoxels", "Use voxel width {fits}"_text,
        "Narrow enough for this wall; narrower voxels take longer"_text, narrowVoxels},
       {ScaleUp, "scaleUp", "Print at scale {scale}"_text,
        "Large enough for the narrowest bead"_text, scaleAsStated},
       {FinerProcess, "finerProcess", "Use a finer process"_text,
        "With the widest bead that fits these walls"_text, finerProcess},
       {ScaleToFit, "scaleToFit", "Scale to fit"_text,
        "The largest scale within the robot's reach"_text, scaleToFit},
       {ScaleToReach, "scaleToReach", "Print at scale {scale}"_text,
        "The largest scale that the robot reaches entirely"_text, scaleAsStated},
       {ScaleToPlate, "scaleToPlate", "Print at scale {scale}"_text,
        "The largest scale that the cell's plates carry"_text, scaleAsStated},
       {Shrink, "shrink", "Print it smaller"_text, "20 % smaller"_text, shrink},
       {Enlarge, "enlarge", "Print it larger"_text, "50 % larger"_text, enlarge},
       {UnitsMetres, "unitsMetres", "The file is in metres"_text, "Scales it by 1000"_text,
        unitsMetres},
       {UnitsInches, "unitsInches", "The file is in inches"_text, "Scales it by 25.4"_text,
        unitsInches},
       {UnitsMicrometres, "unitsMicrometres", "The file is in micrometres"_text,
        "Scales it by 0.001"_text, unitsMicrometres},
       {CentrePart, "centrePart", "Centre the part"_text, "On the platform's position"_text,
        centrePart},
       {UsualProcess, "usualProcess", "Use the usual process"_text,
        "The default nozzle, head and material of this way of building"_text, usualProcess},
       {UsualCell, "usualCell", "Use the usual cell"_text,
        "The default robot and plate of this way of building"_text, usualCell},
       {LargerCell, "largerCell", "Use a larger cell"_text,
        "The next cell with a larger plate"_text, largerCell},
       {PrintFlat, "printFlat", "Print in flat layers"_text,
        "Like an ordinary printer, with the nozzle upright"_text, printFlat},
       {ChooseStrategy, "chooseWay", "Let Voluta choose"_text,
        "Tries the ways of building in turn until nothing is unsupported or missed"_text,
        chooseStrategy},
       {PrintOnPlate, "printOnPlate", "Print on a plate"_text,
        "In a usual cell; Voluta chooses the way of building"_text, printOnPlate},
       {PrintByLayer, "printByLayer", "Print layer by layer"_text,
        "All parts grow together, so that no finished part is in the way"_text, printByLayer, true},
       {AcceptShare, "acceptShare", "Accept"_text,
        "In this job; the verification report lists it"_text, acceptShare, true}});
  return kRemedies;
}

std::vector<RemedyAction> remediesFor(const plan::Finding& finding,
                                      const project::Choices& choices) {
  const std::span<const plan::RemedyId> wanted = plan::rowOf(finding.kind).remedies;
  std::vector<RemedyAction> offers;
  if (finding.item >= static_cast<int>(choices.items.size()))
    return offers; // Its item was removed
  for (const Remedy& remedy : remedies()) {
    if (std::ranges::find(wanted, remedy.id) == wanted.end())
      continue;
    const bool isOfOneItem = choices.items.size() == 1 || finding.item >= 0;
    if (!isOfOneItem && !remedy.ofJob)
      continue;
    const auto item = static_cast<std::size_t>(std::max(finding.item, 0));
    // Some cures fail for choices that cannot be planned (such as a value the process does not
    // allow).
    auto outcome = base::outcomeOf([&] {
      return remedy.cure(finding, remedy.ofJob ? choices : project::onlyItem(choices, item));
    });
    auto* cured = std::get_if<Edited>(&outcome);
    if (!cured || !*cured)
      continue;
    if (!remedy.ofJob) {
      std::vector<project::ItemChoices> items = choices.items;
      items[item] = (*cured)->item();
      (*cured)->items = std::move(items);
    }
    base::Message label(remedy.label);
    for (const std::string_view name : base::placeNames(remedy.label.english()))
      label.values.push_back(*finding.value(name));
    offers.push_back({&remedy, std::move(label), std::move(**cured)});
  }
  return offers;
}

} // namespace voluta::pipeline
