#include "plan/finding_kinds.h"

#include "base/error.h"
#include "plan/finding_remedies.h"

#include <algorithm>
#include <array>
#include <utility>

namespace voluta::plan {

namespace {
using enum FindingKind;
using enum Stage;
using enum Severity;
using namespace finding_remedies;

constexpr auto kRows = std::to_array<FindingRow>({
    {Verbatim, "verbatim", "", Load, ByAmount, "{reason}"_text, "{remedy}"_text, kNoRemedies,
     kOldProject},
    {Stopped, "stopped", "stopped", Load, Error, "{what}"_text, {}, kForStopped, kSaysItself},

    {CellsTurned, "cellsTurned", "newCells", Load, Info,
     "the voxel object is turned by other than quarter turns: its surface is cut into new cells"_text,
     "turn it by quarter turns and lift it by whole cells to keep its own"_text},
    {CellsLifted, "cellsLifted", "newCells", Load, Info,
     "the voxel object is lifted by other than whole cells: its surface is cut into new cells"_text,
     "turn it by quarter turns and lift it by whole cells to keep its own"_text},
    {MeshDefect, "meshDefect", "meshDefect", Load, Info, "{defect}"_text,
     "mend the mesh in a modelling program if the result looks wrong"_text},
    {OpenRims, "openSurface", "openSurface", Load, Error,
     "open surface: it ends at {rims} rim, {width:.3g} wide|"
     "open surface: it ends at {rims} rims, the widest {width:.3g} wide"_plural,
     "thicken it to a wall (openSurfaces=thicken), close its rims to make it solid "
     "(openSurfaces=close), or close it in a modelling program"_text,
     kForRims},
    {SheetModel, "sheetModel", "openSurface", Load, Error,
     "sheet model: {share:.3g} of the surface are sheets without thickness, {triangles} "
     "triangles"_text,
     "thicken the sheets to walls (openSurfaces=thicken), or give them a thickness in a modelling "
     "program"_text,
     kForSheets},
    {RimsClosed, "rimsClosed", "openSurface", Load, Info,
     "closed the rims of an open surface: {share:.3g} of the surface are patches"_text,
     "openSurfaces=thicken makes a wall of the surface instead"_text},
    {SheetsLeftOut, "sheetsLeftOut", "openSurface", Load, Info,
     "left out the sheets without thickness: {share:.3g} of the surface, {triangles} triangles"_text,
     "openSurfaces=thicken makes walls of them instead"_text},
    {SurfaceThickened, "surfaceThickened", "openSurface", Load, Info,
     "thickened the open surface to a wall {wall:.2f} wide, half of it on either side"_text,
     "openSurfaces=close makes it solid instead"_text},
    {TinyPart, "tinyPart", "oddSize", Load, Error,
     "the part is {size:.3g} long, if its file is in millimetres"_text,
     "give the units that it was drawn in (--units)"_text, kForTiny},
    {HugePart, "hugePart", "oddSize", Load, Error,
     "the part is {size:.4g} long, if its file is in millimetres"_text,
     "print it smaller (--scale fit), or give the units that it was drawn in (--units)"_text,
     kForHuge},
    {ThinPart, "thinPart", "thinPart", Load, ByAmount,
     "{share:.3g} of the part are walls thinner than the least bead of {least}, most of them "
     "{usual:.2f}"_text,
     "print it at scale {scale}, or with a process of narrower beads"_text, kForThin},
    {ThinPartInReach, "thinPartInReach", "thinPart", Load, ByAmount,
     "{share:.3g} of the part are walls thinner than the least bead of {least}, most of them "
     "{usual:.2f}"_text,
     "use a process of narrower beads; as large as it had to be it is out of the robot's reach"_text,
     kForThinInReach, kFinest},
    {LiesBadly, "liesBadly", "liesBadly", Load, Info,
     "the part lies badly: {contact:.0f} of it touch the plate, {overhang:.0f} lean over, and one "
     "pass of growth misses {missed:.2g}; it can stand on {bestContact:.0f} with "
     "{bestOverhang:.0f} leaning over and {bestMissed:.2g} missed"_text,
     "stand it that way, turned by {x:.3g} about x, {y:.3g} about y and {z:.3g} about z, or choose "
     "another of its ways to stand"_text,
     kForLying},
    {TurnedLeastRisky, "turnedLeastRisky", "turned", Load, Info,
     "the part is turned by {angle:.0f} about ({x}, {y}, {z}): {overhang:.0f} overhang instead of "
     "{overhangBefore:.0f#}"_text,
     "orient=none leaves it as it was put"_text},
    {TurnedFewestMissed, "turnedFewestMissed", "turned", Load, Info,
     "the part is turned by {angle:.0f} about ({x}, {y}, {z}): one pass of growth misses {missed} "
     "voxel of {voxel:.2f} instead of {missedBefore}, {overhang:.0f} overhang instead of "
     "{overhangBefore:.0f#}|"
     "the part is turned by {angle:.0f} about ({x}, {y}, {z}): one pass of growth misses {missed} "
     "voxels of {voxel:.2f} instead of {missedBefore}, {overhang:.0f} overhang instead of "
     "{overhangBefore:.0f#}"_plural,
     "orient=none leaves it as it was put"_text},
    {NotTurned, "notTurned", "notTurned", Load, Info,
     "the part stays as it lies: the one way that stands is not better|"
     "the part stays as it lies: none of {ways} ways that stand is better"_plural,
     "put it another way by hand"_text},
    {CellCannotPrint, "cellCannotPrint", "cell", Load, Error, "{fault}"_text, "{help}"_text,
     kForCell, kCellFile},
    {LargerThanPlates, "largerThanPlates", "tooLarge", Load, Error,
     "foot of the part: {length:.0f} by {width:.0f}, more than the cell's largest plate ({plate}) "
     "carries"_text,
     "print the part at scale {scale}, or use a cell with a larger plate or a platform made for "
     "the part"_text,
     kForPlates},

    {PlatformAdrift, "platformAdrift", "platformAdrift", Decompose, Error,
     "the platform lies {distance:.0f} beside what carries it: it would float"_text,
     "place the part over the middle, or use a platform that reaches there"_text, kForAdrift},
    {ShadowedUnderFacet, "shadowedUnderFacet", "shadowedVoxels", Decompose, Error,
     "{voxels} voxel is shadowed: from step {step} on it lies inside the front, under its facet "
     "between {a:.0f}, {b:.0f} and {c:.0f} mm|"
     "{voxels} voxels are shadowed: from step {step} on they lie inside the front, under its facet "
     "between {a:.0f}, {b:.0f} and {c:.0f} mm"_plural,
     kTurnOrShrink, kForShadowed},
    {ShadowedUnderFacetAndMore, "shadowedUnderFacetAndMore", "shadowedVoxels", Decompose, Error,
     "{voxels} voxel is shadowed: from step {step} on it lies inside the front, under its facet "
     "between {a:.0f}, {b:.0f} and {c:.0f} mm; {more} more hang on it|"
     "{voxels} voxels are shadowed: from step {step} on they lie inside the front, under its facet "
     "between {a:.0f}, {b:.0f} and {c:.0f} mm; {more} more hang on them"_plural,
     kTurnOrShrink, kForShadowed},
    {ShadowedUnreached, "shadowedUnreached", "shadowedVoxels", Decompose, Error,
     "{voxels} voxel is shadowed: inside the front before it was reached|"
     "{voxels} voxels are shadowed: inside the front before they were reached"_plural,
     kTurnOrShrink, kForShadowed},
    {ShadowedUnreachedAndMore, "shadowedUnreachedAndMore", "shadowedVoxels", Decompose, Error,
     "{voxels} voxel is shadowed: inside the front before it was reached; {more} more hang on it|"
     "{voxels} voxels are shadowed: inside the front before they were reached; {more} more hang on "
     "them"_plural,
     kTurnOrShrink, kForShadowed},
    {Unreached, "unreached", "unreachedVoxels", Decompose, Error,
     "{voxels} voxel is unreached: no path through the part from the platform|"
     "{voxels} voxels are unreached: no path through the part from the platform"_plural,
     kJoin, kForUnreached},
    {MoreShadowed, "moreShadowed", "missedVoxels", Decompose, Error,
     "{voxels} more voxel is missed; this is it|"
     "{voxels} more voxels are missed in smaller groups ({groups}); this is the largest"_plural,
     kTurnOrShrink, kForShadowed},
    {MoreUnreached, "moreUnreached", "missedVoxels", Decompose, Error,
     "{voxels} more voxel is missed; this is it|"
     "{voxels} more voxels are missed in smaller groups ({groups}); this is the largest"_plural,
     kJoin, kForShadowed},
    {BelowPlate, "belowPlate", "unreachedVoxels", Decompose, Error,
     "{voxels} voxel lies below the plate|{voxels} voxels lie below the plate"_plural,
     "drop the part to the plate"_text, kForUnreached},
    {SupportColumn, "supportColumn", "supportColumn", Decompose, Info,
     "a column of {voxels} from {foot} carries {carried} that would be missed"_text, kBreakOff},
    {SupportColumnTouching, "supportColumnTouching", "supportColumn", Decompose, Info,
     "a column of {voxels} from {foot} carries {carried} that would be missed"_text,
     "cut it off after printing: it touches the part at {faces} more face|"
     "cut it off after printing: it touches the part at {faces} more faces"_plural},
    {SupportColumns, "supportColumns", "supportColumns", Decompose, Info,
     "{columns} more column carries what would be missed|"
     "{columns} more columns carry what would be missed"_plural,
     "turning the part may need fewer"_text},
    {PedestalGains, "pedestalGains", "pedestal", Decompose, Info,
     "on this plate {here} voxel would be missed without columns, on a pedestal as wide as the "
     "part's foot {there}|"
     "on this plate {here} voxels would be missed without columns, on a pedestal as wide as the "
     "part's foot {there}"_plural,
     "a pedestal made for the part clears the head's way; it comes with its drawing"_text,
     kPedestal},
    {NoSupport, "noSupport", "noSupport", Decompose, Error,
     "no column from inside the platform reaches {voxels} voxel that would be missed|"
     "no column from inside the platform reaches {voxels} voxels that would be missed"_plural,
     "a larger platform, or turn the part"_text, kForNoSupport},
    {ThinWall, "thinWall", "thinWalls", Decompose, Info,
     "a wall {usual:.2f} thick ({thinnest:.2f} at its thinnest) is thinner than a voxel of "
     "{voxel}"_text,
     kNarrowTo, kNarrow},
    {WallTooThin, "wallTooThin", "thinWalls", Decompose, Info,
     "a wall {usual:.2f} thick ({thinnest:.2f} at its thinnest) is thinner than a voxel of "
     "{voxel}"_text,
     kThicken},
    {ThinWalls, "thinWalls", "thinWalls", Decompose, Info,
     "{places} smaller place is thinner than a voxel of {voxel}; it is {thinnest:.2f} thick|"
     "{places} smaller places are thinner than a voxel of {voxel}; this is the largest, the "
     "thinnest "
     "is {thinnest:.2f} thick"_plural,
     kNarrowTo, kNarrow},
    {WallsTooThin, "wallsTooThin", "thinWalls", Decompose, Info,
     "{places} smaller place is thinner than a voxel of {voxel}; it is {thinnest:.2f} thick|"
     "{places} smaller places are thinner than a voxel of {voxel}; this is the largest, the "
     "thinnest "
     "is {thinnest:.2f} thick"_plural,
     kThicken},
    {OverhangOfPieces, "overhangOfPieces", "overhang", Decompose, Info,
     "{area:.3g} lean over by more than {angle}"_text, kCutThere, kForOverhang},
    {OverhangsOfPieces, "overhangsOfPieces", "overhang", Decompose, Info,
     "{places} smaller place leans over too far, {area:.3g}|"
     "{places} smaller places lean over too far, {area:.3g} together; this is the largest of "
     "them"_plural,
     kCutThere, kForOverhang},
    {OverhangOfFlat, "overhangOfFlat", "overhang", Decompose, Info,
     "{area:.3g} lean over by more than {angle}"_text, kTurnOrModes, kForOverhang},
    {OverhangsOfFlat, "overhangsOfFlat", "overhang", Decompose, Info,
     "{places} smaller place leans over too far, {area:.3g}|"
     "{places} smaller places lean over too far, {area:.3g} together; this is the largest of "
     "them"_plural,
     kTurnOrModes, kForOverhang},
    {OverhangOverRod, "overhangOverRod", "overhang", Decompose, Info,
     "{area:.3g} of the part lean out by more than {angle:.3g} over lower layers, the most at x = "
     "{x:.4g}, radius {radius:.4g}"_text,
     kGentlerRod, kForOverhang},
    {OverhangOverSurface, "overhangOverSurface", "overhang", Decompose, Info,
     "{area:.3g} of the part lean out by more than {angle:.3g} over lower layers, the most at "
     "{at:.4g}"_text,
     kGentlerSurface, kForOverhang},
    {BeyondCell, "beyondCell", "beyondCell", Decompose, Error,
     "the part reaches {reach:.4g} from the rod's axis, the cell prints up to {limit}"_text,
     "print the part smaller (scale)"_text, kForRod},
    {BlockedPieces, "blockedPieces", "blockedPieces", Decompose, Info,
     "{blocked} of {pieces} pieces: something printed before is in the head's way"_text,
     "give other cuts (cutPlanes), turn the part, or use curved mode"_text},
    {SmallFoot, "smallFoot", "smallFoot", Decompose, Info,
     "all pieces are held to the plate by {foot:.3g}, of {whole:.3g#} that the part stands on "
     "uncut"_text,
     "lay the part on a larger face, or give other cuts (cutPlanes)"_text},
    {UniformMisses, "uniformMisses", "uniformMisses", Decompose, Info,
     "{missed} of {voxels} voxels has nothing printed under it|"
     "{missed} of {voxels} voxels have nothing printed under them"_plural,
     kTurnOrOther, kTurn},

    {DroppedPieces, "droppedPieces", "droppedPieces", Layers, Info,
     "{pieces} piece of a layer is too small for a bead or would begin in the air and is not laid "
     "({volume:.1f})|"
     "{pieces} pieces of layers are too small for a bead or would begin in the air and are not "
     "laid "
     "({volume:.1f} in all, the largest {largest:.1f})"_plural,
     "a narrower bead or a lower layer height follows finer detail; support carries what begins in "
     "the air"_text},
    {UnsupportedPatches, "unsupportedPatches", "unsupportedPatches", Layers, Info,
     "{patches} patch ({area:.1f}) begins in the air: neither the plate nor an earlier layer is "
     "under it|"
     "{patches} patches ({area:.1f}) begin in the air: neither the plate nor an earlier layer is "
     "under them"_plural,
     "turn the part, enlarge the platform or add supports"_text},
    {Slivers, "slivers", "slivers", Layers, ByAmount,
     "{pieces} piece of a layer is too small for a bead or would begin in the air, {volume:.3g} of "
     "{whole:.3g#}: it is not laid|"
     "{pieces} pieces of layers are too small for a bead or would begin in the air, {volume:.3g} "
     "of "
     "{whole:.3g#}: they are not laid"_plural,
     kFiner, kForSlivers},
    {BeginsInAir, "beginsInAir", "beginsInAir", Layers, Error,
     "{pieces} piece of a layer has nothing under it|"
     "{pieces} pieces of layers have nothing under them"_plural,
     kTurnOrOther, kForAir},
    {BeginsInAirOverRod, "beginsInAirOverRod", "beginsInAir", Layers, Error,
     "a piece of a layer has neither the rod nor an earlier layer under it|"
     "{pieces} pieces of layers have neither the rod nor an earlier layer under them"_plural,
     "move the part on the rod, or let what is under them grow out of it"_text, kForAirOverGround},
    {BeginsInAirOverSurface, "beginsInAirOverSurface", "beginsInAir", Layers, Error,
     "a piece of a layer has neither the surface nor an earlier layer under it|"
     "{pieces} pieces of layers have neither the surface nor an earlier layer under them"_plural,
     "move the part on the surface, or let what is under them grow out of it"_text,
     kForAirOverGround},
    {NotLaid, "notLaid", "notLaid", Layers, Error,
     "{left:.3g#} of {whole:.4g} of the part are in no layer"_text,
     "choose layers that reach all of it (layerShape, layerCentre, endSurface)"_text,
     kForAirOverGround},
    {UnheldOverhang, "unheldOverhang", "unheldOverhang", Layers, Info,
     "{area:.3g} hang where a support has nothing to stand on"_text,
     "use a larger platform (fit:MARGIN), or turn the part"_text, kForUnheld},
    {PlaneMisses, "planeMisses", "planeMisses", Layers, Info,
     "planes of layers miss the part: {planes}"_text, "move them, or leave them out"_text},
    {HeightBeyondLimits, "heightBeyondLimits", "heightBeyondLimits", Layers, Info,
     "{share:.0f} of the layers' area is thinner than {least} or thicker than {most}"_text,
     "move the planes, or add some between"_text},

    {GivenWithoutSection, "givenWithoutSection", "givenWithoutSection", Toolpath, Info,
     "the file does not say how wide, high or fast {points} point of its tool-paths is printed: "
     "taken from process {process}|"
     "the file does not say how wide, high or fast {points} points of its tool-paths are printed: "
     "taken from process {process}"_plural,
     "give the process that the tool-paths were made for"_text},
    {GivenTooFast, "givenTooFast", "givenTooFast", Toolpath, Info,
     "{points} point of the file's tool-paths asks for more than the extruder's {limit}: printed "
     "slower|"
     "{points} points of the file's tool-paths ask for more than the extruder's {limit}: printed "
     "slower"_plural,
     "a larger nozzle, or slower tool-paths"_text},
    {PatchWithoutBead, "patchWithoutBead", "patchWithoutBead", Toolpath, ByAmount,
     "pieces of layers are narrower than half a bead and stay empty"_text, kFiner, kForSlivers},
    {RimSupports, "rimSupports", "rimSupports", Toolpath, Info,
     "beads of support ({volume:.3g}) are laid under {paths} bead that would hang just over the "
     "plate "
     "or over what is printed|"
     "beads of support ({volume:.3g}) are laid under {paths} beads that would hang just over the "
     "plate "
     "or over what is printed"_plural,
     kBreakOff},
    {PrimeFalls, "primeFalls", "primeFalls", Toolpath, Info,
     "the plate has no room for the prime: a bead {length:.0f} long is laid in the air beside the "
     "plate "
     "and falls down here"_text,
     "clear this place, or use a larger plate (--platform)"_text},
    {Braced, "braced", "braced", Toolpath, Info,
     "{paths} bead would hang beside what is printed: it is laid after the one inwards of it and "
     "pressed against that, the nozzle leaning by up to {lean:.0f} more|"
     "{paths} beads would hang beside what is printed: each is laid after the one inwards of it "
     "and pressed against that, the nozzle leaning by up to {lean:.0f} more"_plural,
     "where that is not wanted, turn the part or print it in flat layers with supports"_text},
    {Gouge, "gouge", "gouge", Toolpath, ByAmount,
     "the print head would cut into material printed before, whatever way it leans"_text,
     "use a slimmer head, turn the part, or print it larger"_text, kForGouge},

    {NothingToPrint, "nothingToPrint", "nothingToPrint", Motion, Error,
     "no tool-path is left to move along"_text, "choose a smaller voxelMm or beadWidthMm"_text,
     kForNothing},
    {TooLarge, "tooLarge", "unreachable", Motion, Error,
     "{share:.2g} of the tool-paths' points are out of the robot's reach; at {size:.2g} of this "
     "size it would get to them"_text,
     "print it at scale {scale:.3g}, turn it, or use a larger robot"_text, kForTooLarge},
    {MuchOutOfReach, "muchOutOfReach", "unreachable", Motion, Error,
     "{share:.2g} of the tool-paths' points are out of the robot's reach"_text,
     "use flat layers, where the nozzle need not lean, turn the part, or use a larger robot"_text,
     kForOutOfReach},
    {Unreachable, "unreachable", "unreachable", Motion, Error,
     "{place}: the robot cannot bring this place under the nozzle: out of reach, or beyond a "
     "joint's limits, however the part is turned about the nozzle"_text,
     kScaleOrTurn, kForOutOfReach},
    {MoreUnreachable, "moreUnreachable", "unreachable", Motion, Error,
     "and further places, the first at {place}: the robot cannot bring this place under the "
     "nozzle: "
     "out of reach, or beyond a joint's limits, however the part is turned about the nozzle"_text,
     kScaleOrTurn, kForOutOfReach},
    {Unconnected, "unconnected", "unconnected", Motion, Error,
     "{place}: the robot can be here, but cannot come from or go on to a neighbouring place "
     "without "
     "lifting"_text,
     kMoreTurns, kForUnconnected},
    {MoreUnconnected, "moreUnconnected", "unconnected", Motion, Error,
     "and further places, the first at {place}: the robot can be here, but cannot come from or go "
     "on to a neighbouring place without lifting"_text,
     kMoreTurns, kForUnconnected},
    {StaysUpright, "staysUpright", "staysUpright", Motion, Error,
     "this arm keeps the nozzle upright, and the layers lean it, first at {place}"_text,
     "use mode flat, or planar with upright layers"_text, kForUpright},
    {BeyondRod, "beyondRod", "beyondRod", Motion, Error,
     "{place}: the cell prints up to {radius} from the rod's axis and {along} from its middle"_text,
     kAlongRod, kForRod},
    {MoreBeyondRod, "moreBeyondRod", "beyondRod", Motion, Error,
     "and further places, the first at {place}: the cell prints up to {radius} from the rod's axis "
     "and {along} from its middle"_text,
     kAlongRod, kForRod},
    {HeadInPart, "headInPart", "collision", Motion, Error,
     "{place}: the print head would cut into what is printed already"_text, kSlimmer,
     kForHeadInPart},
    {MoreHeadInPart, "moreHeadInPart", "collision", Motion, Error,
     "and further places, the first at {place}: the print head would cut into what is printed "
     "already"_text,
     kSlimmer, kForHeadInPart},
    {HeadInPlatform, "headInPlatform", "collision", Motion, Error,
     "{place}: the print head would cut into the platform"_text, kHigher, kForHeadInPlatform},
    {MoreHeadInPlatform, "moreHeadInPlatform", "collision", Motion, Error,
     "and further places, the first at {place}: the print head would cut into the platform"_text,
     kHigher, kForHeadInPlatform},
    {Collision, "collision", "collision", Motion, Error,
     "{place}: {first} would meet {second}, however the part is turned about the nozzle"_text,
     kLessClearance, kForCollision},
    {MoreCollisions, "moreCollisions", "collision", Motion, Error,
     "and further places, the first at {place}: {first} would meet {second}, however the part is "
     "turned about the nozzle"_text,
     kLessClearance, kForCollision},
    {MeetsOnCloserLook, "meetsOnCloserLook", "collision", Motion, Error,
     "{place}: something would meet on the way here, so this place is left out"_text,
     kTurnOrClearance, kForCollision},
    {MoreMeetOnCloserLook, "moreMeetOnCloserLook", "collision", Motion, Error,
     "and further places, the first at {place}: something would meet on the way there, so they are "
     "left out"_text,
     kTurnOrClearance, kForCollision},
    {CollisionInMotion, "collisionInMotion", "collision", Motion, Error,
     "{first} meets {second} in the finished motion"_text, kTurnOrClearance, kForCollision},
    {HomeMeets, "homeMeets", "collision", Motion, Error,
     "{first} meets {second} where the arm rests: nothing can be moved"_text,
     "give the cell another home; where only the shapes that enclose two links overlap, list the "
     "pair "
     "under neverMeet in the robot's file"_text,
     kForHome, kCellFile},
    {NoWayTo, "noWayTo", "transfer", Motion, Error,
     "{place}: no way to {pieces} piece of a path was found that keeps clear of everything|"
     "{place}: no way to {pieces} pieces of paths was found that keeps clear of everything"_plural,
     kTurnOrClearance, kForCollision},
    {NoWayBack, "noWayBack", "transfer", Motion, Error,
     "{place}: no way leads from home to where the print is to go on, clear of what is printed by "
     "then"_text,
     "choose a bead before it or after it"_text, kNoRemedies, kOtherBead},
    {NoWayFrom, "noWayFrom", "transfer", Motion, Error,
     "{place}: the arm would not get away from where {pieces} piece of a path ends|"
     "{place}: the arm would not get away from where {pieces} pieces of paths end"_plural,
     kTurnOrClearance, kForCollision},
    {LeftOut, "leftOut", "leftOut", Motion, Info,
     "{waypoints} waypoint, {share:.2g} of the material, is left out here and there, as told above|"
     "{waypoints} waypoints, {share:.2g} of the material, are left out here and there, as told "
     "above"_plural,
     "look at these places in the picture; turn the part where they matter"_text},

    {UnreadableLine, "unreadableLine", "unreadableLine", Replay, Error, "{defect}"_text,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {EndMissing, "endMissing", "endMissing", Replay, Error, "the end sequence is missing"_text,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {NoMotions, "noMotions", "programCutShort", Replay, Error, "the program has no motions"_text,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {ProgramCutShort, "programCutShort", "programCutShort", Replay, Error,
     "the program ends here; {motions} planned motion not in it|"
     "the program ends here; {motions} planned motions not in it"_plural,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {OtherJob, "otherJob", "otherJob", Replay, ByAmount,
     "the program says that it is of another job: {program}; this job is {job}"_text,
     "give the job that the program was written from"_text, kNoRemedies, kOnlyWriteAgain},
    {OtherCell, "otherCell", "otherJob", Replay, ByAmount,
     "the program says that it is for another cell: {program}; this job is {job}"_text,
     "give the job that the program was written from"_text, kNoRemedies, kOnlyWriteAgain},
    {OtherProgram, "otherProgram", "otherProgram", Replay, Error,
     "the program's motions are not those of this plan"_text,
     "give the job that the program was written from"_text, kNoRemedies, kOnlyWriteAgain},
    {WaypointMoved, "waypointMoved", "waypointMoved", Replay, Error,
     "the nozzle goes {distance:.3f} beside its plan"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {WaypointTilted, "waypointTilted", "waypointMoved", Replay, Error,
     "the nozzle's axis is {angle:.2f} off its plan"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {WaypointsMissingBefore, "waypointsMissingBefore", "waypointsMissing", Replay, Error,
     "{motions} planned motion missing before this one|"
     "{motions} planned motions missing before this one"_plural,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {WaypointsMissingBetween, "waypointsMissingBetween", "waypointsMissing", Replay, Error,
     "{motions} planned motion missing between {before} and this one|"
     "{motions} planned motions missing between {before} and this one"_plural,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {MotionsUnplanned, "motionsUnplanned", "motionsUnplanned", Replay, Error,
     "{motions} motion from here on not in the plan|"
     "{motions} motions from here on not in the plan"_plural,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {WaypointsSwapped, "waypointsSwapped", "waypointsSwapped", Replay, Error,
     "this motion and that of {other} have changed places"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {OtherConfiguration, "otherConfiguration", "otherConfiguration", Replay, Error,
     "the arm stands otherwise than planned, a joint by {angle:.1f}"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {ExternalAxisMoved, "externalAxisMoved", "externalAxisMoved", Replay, Error,
     "the external axis stands {angle:.3f} off its plan"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {ExtruderOnTravel, "extruderOnTravel", "extruderOnTravel", Replay, Error,
     "the extruder is on over a travel"_text, kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {ExtruderOffPrint, "extruderOffPrint", "extruderOffPrint", Replay, Error,
     "the extruder is off where a bead is to be laid"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {SpeedChanged, "speedChanged", "speedChanged", Replay, Error,
     "this motion takes {time:.3f}, planned are {planned:.3f}"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {FlowChanged, "flowChanged", "flowChanged", Replay, Error,
     "this motion lays {volume:.3f}, planned are {planned:.3f}"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {BeadByJoints, "beadByJoints", "beadByJoints", Replay, Error,
     "a bead is laid by a motion in joints, planned is a straight one"_text, kWriteAgain,
     kNoRemedies, kOnlyWriteAgain},
    {FlowsWhileStanding, "flowsWhileStanding", "flowsWhileStanding", Replay, Error,
     "{volume:.3f} flow out here while the nozzle stands for {time:.3f}"_text, kWriteAgain,
     kNoRemedies, kOnlyWriteAgain},
    {StandsAmidPrint, "standsAmidPrint", "standsAmidPrint", Replay, Error,
     "the arm stands here for {time:.2f}, the hot nozzle on the part: no wait is planned"_text,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {PrimeChanged, "primeChanged", "primeChanged", Replay, Error,
     "{volume:.3f} are pushed out before the first bead, planned are {planned:.3f}"_text,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {FirstMotionFast, "firstMotionFast", "firstMotionFast", Replay, Error,
     "the first motion, from wherever the arm stands, is a fast one"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {AccelerationChanged, "accelerationChanged", "accelerationChanged", Replay, Error,
     "this motion is told to speed up {times:.1f} times as hard as planned"_text, kWriteAgain,
     kNoRemedies, kOnlyWriteAgain},
    {LoadChanged, "loadChanged", "loadChanged", Replay, Error,
     "the arm is told to carry {mass:.2f} kg, some {planned:.2f} kg are planned"_text, kWriteAgain,
     kNoRemedies, kOnlyWriteAgain},
    {NozzleElsewhere, "nozzleElsewhere", "nozzleElsewhere", Replay, Error,
     "the program has its nozzle {distance:.2f} and {angle:.2f} from where the cell's stands"_text,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {StatementMissing, "statementMissing", "statementMissing", Replay, Error,
     "missing before this line: {statement}"_text, kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {StatementChanged, "statementChanged", "statementChanged", Replay, Error,
     "{statement}: {found} in the program, {planned} planned"_text, kWriteAgain, kNoRemedies,
     kOnlyWriteAgain},
    {OutputPasses, "outputPasses", "outputPasses", Replay, Error,
     "an output of the extruder set where the arm does not stop: it takes effect elsewhere, or "
     "stops the arm on the bead"_text,
     "set it by a trigger of the next motion, or write the program again"_text, kNoRemedies,
     kOnlyWriteAgain},
    {PostureChanged, "postureChanged", "postureChanged", Replay, Error,
     "the arm's posture at this target: {found} in the program, {planned} planned"_text,
     kWriteAgain, kNoRemedies, kOnlyWriteAgain},
    {FlowErrors, "flowErrors", "flowErrors", Replay, Error,
     "at the controller's own speeds {share:.2f} of the beads' length get more than 5 % "
     "too much or too little material, the first of them here"_text,
     "write the program again: with times instead of speeds where the format knows them"_text,
     kForFlowErrors},
    {Uncovered, "uncovered", "uncovered", Replay, Error,
     "{share:.2f} of the part is in no bead; most of it round the place given"_text,
     "use lower layers or a finer nozzle, or print the part larger"_text, kForUncovered},
    {Overfill, "overfill", "overfill", Replay, Error,
     "{outside:.2f} of the part's volume is laid outside it, {noRoom:.2f} finds no room"_text,
     "less flow, or beads further apart"_text, kForFill},
    {Mass, "mass", "mass", Replay, Error, "the material laid is {share:.2f} of the part"_text,
     "check the flow and the infill's density"_text, kForFill},
    {Unsupported, "unsupported", "unsupported", Replay, Error,
     "{length:.1f} of bead have nothing beneath them, the first of them here"_text,
     "turn the part, or let Voluta choose the way of building"_text, kForUnsupported},
    {LongBridge, "longBridge", "longBridge", Replay, Info,
     "{length:.1f} of a bead have nothing right beneath them; this material bridges {bridge:.1f}"_text,
     "turn the part, or let Voluta choose the way of building"_text, kForHanging},
    {ReplayedCollision, "replayedCollision", "collision", Replay, Error,
     "{first} and {second} collide"_text,
     "plan anew with more clearance, or another place for the part"_text, kForReplayed},
    {MoreReplayedCollisions, "moreReplayedCollisions", "collision", Replay, Error,
     "and {collisions} collision more|and {collisions} collisions more"_plural,
     "plan anew with more clearance"_text, kForReplayed},
    {OutOfReach, "outOfReach", "limit", Replay, Error, "the arm cannot reach this target"_text,
     kSlower, kForLimits},
    {JointRange, "jointRange", "limit", Replay, Error,
     "{joint} at {angle:.1f}, its limit is {limit:.1f#}"_text, kSlower, kForLimits},
    {JointSpeed, "jointSpeed", "limit", Replay, Error,
     "{joint} at {speed:.1f}, its limit is {limit:.1f#}"_text, kSlower, kForLimits},
    {SlideSpeed, "slideSpeed", "limit", Replay, Error,
     "{joint} at {speed:.1f}/s, its limit is {limit:.1f#}"_text, kSlower, kForLimits},
    {BranchJump, "branchJump", "limit", Replay, Error,
     "the arm would have to change its configuration, {joint} by {angle:.1f} at once"_text, kSlower,
     kForLimits},
    {BlendOverlap, "blendOverlap", "limit", Replay, Error,
     "its blend overlaps the one before ({blend:.3f} on {way:.3f}): the controller skips the "
     "waypoint"_text,
     kSlower, kForBlends},
    {Flow, "flow", "limit", Replay, Error,
     "a flow of {flow:.1f}, the extruder gives {limit:.1f#}"_text, kSlower, kForFlow},
    {MoreLimits, "moreLimits", "limit", Replay, Error,
     "and {violations} violation more|and {violations} violations more"_plural, kSlower,
     kForLimits},
    {PathDeviation, "pathDeviation", "deviation", Replay, Error,
     "the nozzle's path is {distance:.3f} off the planned one"_text,
     "shorter motions or smaller blends"_text, kForDeviation},
    {ProgramRefused, "programRefused", "programRefused", Replay, Error,
     "the {format} program is not handed over: {failed}"_text,
     "see the findings before this one"_text, kNoRemedies, kOthersHelp},
    {ForeignRefused, "foreignRefused", "programRefused", Replay, Info,
     "the {format} program, for another controller, is not handed over: {failed}"_text,
     "take the program of the cell's own controller"_text},
});

constexpr bool inOrder() {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (static_cast<std::size_t>(kRows[i].kind) != i)
      return false;
  return kRows.size() == static_cast<std::size_t>(ForeignRefused) + 1;
}
static_assert(inOrder(), "a row a kind, in the order of FindingKind");
} // namespace

std::span<const FindingRow> findingRows() {
  return kRows;
}

const FindingRow& rowOf(FindingKind kind) {
  const auto i = static_cast<std::size_t>(kind);
  base::require(i < kRows.size(), "a kind of finding");
  return kRows[i];
}

const FindingRow* rowWithId(std::string_view id) {
  const auto* found =
      std::find_if(kRows.begin(), kRows.end(), [&](const FindingRow& row) { return row.id == id; });
  return found == kRows.end() ? nullptr : found;
}

plan::Stage stageOf(const Finding& finding) {
  if (const base::Value* word = finding.value(kVerbatimStage))
    return stageNamed(base::english(*word)).value_or(Load);
  return rowOf(finding.kind).stage;
}

std::string reportId(const Finding& finding) {
  if (const base::Value* word = finding.value(kVerbatimKind);
      word && finding.kind == FindingKind::Verbatim)
    return base::english(*word);
  return std::string(rowOf(finding.kind).reportId);
}

Finding verbatimFinding(plan::Stage stage, std::string kind, std::string reason,
                        std::string remedy) {
  Finding f;
  f.kind = FindingKind::Verbatim;
  f.values = {{kVerbatimStage, stageName(stage)},
              {kVerbatimKind, std::move(kind)},
              {kVerbatimReason, std::move(reason)},
              {kVerbatimRemedy, std::move(remedy)}};
  return f;
}

Finding stoppedFinding(plan::Stage stage, base::Message what) {
  Finding f = makeFinding(FindingKind::Stopped, {{"what", std::move(what)}});
  f.values.push_back({kVerbatimStage, stageName(stage)});
  return f;
}

} // namespace voluta::plan
