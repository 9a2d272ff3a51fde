// Constants shared by the rows of finding_kinds.cpp: the remedies that each kind of finding offers,
// why some kinds have none, help texts, and the reasons of findings that also stand for further
// ones.
#pragma once

#include "base/text.h"
#include "plan/remedy_id.h"

#include <array>
#include <span>

namespace voluta::plan::finding_remedies {

using enum RemedyId;

inline constexpr std::array kForStopped{DropToPlate, ChooseWay};
inline constexpr std::array kForShadowed{ShrinkPlatform, AddSupports, TurnPart};
inline constexpr std::array kForUnreached{DropToPlate, AddSupports, TurnPart};
inline constexpr std::array kForNoSupport{WidenPlatform, TurnPart, PrintFlat};
inline constexpr std::array kForOverhang{AddSupports, TurnLeastRisky};
inline constexpr std::array kForAir{AddSupports, TurnLeastRisky, ChooseWay};
inline constexpr std::array kForAirOverGround{PrintOnPlate};
inline constexpr std::array kTurn{TurnLeastRisky};
inline constexpr std::array kPedestal{ShrinkPlatform};
inline constexpr std::array kForBrim{WidenPlatform, CentrePart};
inline constexpr std::array kForUnheld{WidenPlatform, TurnLeastRisky};
inline constexpr std::array kNarrow{NarrowVoxels};
inline constexpr std::array kForUncovered{AdaptLayers, LowerLayers, FinerProcess, ChooseWay};
inline constexpr std::array kForFill{LowerLayers, FinerProcess, ChooseWay};
inline constexpr std::array kForUnsupported{AddSupports, TurnLeastRisky, PrintFlat, ChooseWay,
                                            PrintOnPlate};
inline constexpr std::array kForLongBridge{ChooseWay};
inline constexpr std::array kForThin{ScaleUp, FinerProcess};
inline constexpr std::array kForThinInReach{FinerProcess};
inline constexpr std::array kForSlivers{FinerProcess, Enlarge};
inline constexpr std::array kForNothing{FinerProcess, Enlarge};
inline constexpr std::array kForGouge{FinerProcess, Enlarge, PrintFlat, ChooseWay};
inline constexpr std::array kForTiny{UnitsMetres, UnitsInches};
inline constexpr std::array kForHuge{ScaleToFit, UnitsMicrometres};
inline constexpr std::array kForAdrift{CellPlate, CentrePart};
inline constexpr std::array kForLying{StandBest};
inline constexpr std::array kForRims{WallSurface, ThickenSurface, CloseRims};
inline constexpr std::array kForSheets{WallSurface, ThickenSurface};
inline constexpr std::array kForBlocked{PrintByLayer};
inline constexpr std::array kForUpright{PrintFlat, UsualCell};
inline constexpr std::array kForTooLarge{ScaleToReach, LargerCell, PrintFlat};
inline constexpr std::array kForOutOfReach{ScaleToFit, Shrink, CentrePart, LargerCell, PrintFlat};
inline constexpr std::array kForRod{ScaleToFit, Shrink};
inline constexpr std::array kForUnconnected{MoreTurns, Shrink, PrintFlat};
inline constexpr std::array kForHeadInPart{LowerLayers, FinerProcess, PrintFlat, ChooseWay};
inline constexpr std::array kForHeadInPlatform{ShrinkPlatform, FinerProcess, PrintFlat,
                                               PrintOnPlate};
inline constexpr std::array kForCollision{LessClearance, MoreTurns, Shrink, CentrePart};
inline constexpr std::array kForReplayed{MoreClearance, Shrink, CentrePart};
inline constexpr std::array kForLimits{MoreTurns, Shrink, CentrePart, PrintFlat};
inline constexpr std::array kForFlow{LowerLayers, FinerProcess};
inline constexpr std::array kForFlowErrors{LongerMotions};
inline constexpr std::array kForBlends{LongerMotions};
inline constexpr std::array kForDeviation{ShorterMotions};
inline constexpr std::array kForHome{UsualCell};
inline constexpr std::array kForCell{UsualProcess, UsualCell};
inline constexpr std::array kForPlates{ScaleToPlate, LargerCell, MakePlatform};

inline constexpr std::span<const RemedyId> kNoRemedies{};
inline constexpr base::Text kHasRemedies; // instead of a text why there is none
inline constexpr base::Text kOnlyWriteAgain =
    "the program does not match this plan: changing the plan does not help"_text;
inline constexpr base::Text kForCooling =
    "only you know how long a bead has to cool: change the minimum layer time"_text;
inline constexpr base::Text kSaysItself = "the message says how to fix it"_text;
inline constexpr base::Text kOldProject =
    "stored as text in an older project: plan again to see remedies"_text;
inline constexpr base::Text kFurtherApart =
    "place the machines further apart, or the parts further from the border"_text;
inline constexpr base::Text kPlaceMachines = "change the places of the machines in their table"_text;
inline constexpr base::Text kAllAgain = "write the programs of all machines again"_text;
inline constexpr base::Text kOthersHelp = "see the remedies of the findings before this one"_text;
inline constexpr base::Text kOtherFormat = "choose another program format"_text;
inline constexpr base::Text kSlicersPaths =
    "the tool-paths are those of the file: change them where they were made"_text;
inline constexpr base::Text kFinest = "no available process has narrower beads"_text;
inline constexpr base::Text kOtherBead = "choose the bead to resume from on the Simulate page"_text;
inline constexpr base::Text kCellFile = "change the cell's file: Edit, Edit cell"_text;

// The tool-paths of a file are not planned again.
inline constexpr base::Text kSliceSupports =
    "slice the part again with supports there, or with denser infill; its tool-paths are printed "
    "as they are"_text;
inline constexpr base::Text kSliceDenser =
    "check the widths and layer heights in the slicer against the bead of the process; the "
    "tool-paths are printed as they are"_text;
inline constexpr base::Text kSliceLess =
    "check the flow in the slicer, and purge or prime lines that it does not mark; the tool-paths "
    "are printed as they are"_text;
inline constexpr base::Text kSliceAmounts =
    "check the slicer's flow, its filament diameter and its amounts at tool changes; the "
    "tool-paths are printed as they are"_text;
inline constexpr base::Text kTurnOrShrink =
    "turn the part, make the platform smaller or add supports"_text;
inline constexpr base::Text kJoin =
    "use a larger platform or supports, or join this piece to the part"_text;
inline constexpr base::Text kBreakOff = "break it off after printing"_text;
inline constexpr base::Text kNarrowTo = "use a voxel width of at most {fits}"_text;
inline constexpr base::Text kThicken = "thicken the wall to {least} or more"_text;
inline constexpr base::Text kCutThere =
    "add supports (supports=auto), cut there, or use curved mode"_text;
inline constexpr base::Text kTurnOrModes =
    "turn the part (orient=leastRisky), add supports, or use planar or curved mode"_text;
inline constexpr base::Text kTurnOrOther =
    "turn the part (orient=leastRisky), or use planar or curved mode"_text;
inline constexpr base::Text kFiner = "use a finer nozzle, or print the part larger"_text;
inline constexpr base::Text kGentlerRod = "give the part a gentler slope from the rod there"_text;
inline constexpr base::Text kGentlerSurface =
    "give the part a gentler slope from the surface there"_text;
inline constexpr base::Text kScaleOrTurn =
    "scale the part down (--scale fit), turn it, or use a larger robot"_text;
inline constexpr base::Text kMoreTurns =
    "turn the part about the vertical, or try more rotations (redundancySamples)"_text;
inline constexpr base::Text kSlimmer = "use a slimmer print head or thinner layers"_text;
inline constexpr base::Text kHigher = "use a smaller platform or place the part higher"_text;
inline constexpr base::Text kAlongRod = "scale the part down, or move it along the rod"_text;
inline constexpr base::Text kLessClearance =
    "turn the part, use a smaller platform, or allow less clearance"_text;
inline constexpr base::Text kTurnOrClearance = "turn the part, or allow less clearance"_text;
inline constexpr base::Text kWriteAgain =
    "write the program again; to keep this change, make it in the plan"_text;
inline constexpr base::Text kSlower =
    "print slower there, or place the part elsewhere in the cell"_text;

inline constexpr base::Text kMoreVoxels =
    "{what}; another voxel depends on this|{what}; {more} more voxels depend on this"_plural;
inline constexpr base::Text kMoreWaypoints =
    "{count} more waypoint: {what}|{count} more waypoints, the first: {what}"_plural;
inline constexpr base::Text kMoreCollisions =
    "{count} more collision|{count} more collisions"_plural;
inline constexpr base::Text kMoreViolations =
    "{count} more violation|{count} more violations"_plural;

} // namespace voluta::plan::finding_remedies
