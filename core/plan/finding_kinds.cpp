#include "plan/finding_kinds.h"

#include "base/error.h"
#include "plan/finding_remedies.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace voluta::plan {

namespace {
using enum FindingKind;
using enum Stage;
using enum Severity;
using namespace finding_remedies;

constexpr auto kRows =
    std::to_array<FindingRow>({
        {Verbatim, "verbatim", "", Load, ByAmount, "{reason}"_text, "{remedy}"_text, kNoRemedies,
         kOldProject},
        {Stopped, "stopped", "stopped", Load, Error, "{what}"_text, {}, kForStopped, kSaysItself},

        {CellsTurned, "cellsTurned", "newCells", Load, Info,
         "the voxel object is not rotated by a multiple of 90°: it is cut into new voxels"_text,
         "to keep its voxels, rotate it by multiples of 90° and lift it by whole voxels"_text},
        {CellsLifted, "cellsLifted", "newCells", Load, Info,
         "the voxel object is lifted by a fraction of a voxel: it is cut into new voxels"_text,
         "to keep its voxels, rotate it by multiples of 90° and lift it by whole voxels"_text},
        {MeshDefect, "meshDefect", "meshDefect", Load, Info, "{defect}"_text,
         "repair the mesh in a modelling program if the result looks wrong"_text},
        {OpenRims, "openSurface", "openSurface", Load, Error,
         "open surface: {rims} open edge loop, {width:.3g} wide|open surface: {rims} open edge loops, the widest {width:.3g} wide"_plural,
         "print it as one wall (openSurfaces=wall), thicken it to a wall of two beads "
         "(openSurfaces=thicken), close its rims to make it solid (openSurfaces=close), or "
         "close it in a modelling program"_text,
         kForRims},
        {SheetModel, "sheetModel", "openSurface", Load, Error,
         "sheet model: {share:.3g} of the surface has no thickness, {triangles} triangles"_text,
         "print the sheets as walls of one bead (openSurfaces=wall) or two "
         "(openSurfaces=thicken), or give them a thickness in a modelling program"_text,
         kForSheets},
        {RimsClosed, "rimsClosed", "openSurface", Load, Info,
         "open edges were closed: {share:.3g} of the surface is patches"_text,
         "to get a wall instead, use openSurfaces=thicken"_text},
        {SheetsLeftOut, "sheetsLeftOut", "openSurface", Load, Info,
         "sheets without thickness were left out: {share:.3g} of the surface, {triangles} triangles"_text,
         "to get walls instead, use openSurfaces=thicken"_text},
        {SurfaceThickened, "surfaceThickened", "openSurface", Load, Info,
         "the open surface was thickened to a wall of {wall:.2f}, half on each side"_text,
         "to get a solid instead, use openSurfaces=close"_text},
        {SurfaceAsWall, "surfaceAsWall", "openSurface", Load, Info,
         "the open surface is printed as one wall, one bead ({width:.2f}) wide"_text,
         "to get a wall of two beads instead, use openSurfaces=thicken"_text},
        {TinyPart, "tinyPart", "oddSize", Load, Error,
         "the part is very small: {size:.3g} long if its file is in millimetres"_text,
         "give the units it was drawn in (--units)"_text, kForTiny},
        {HugePart, "hugePart", "oddSize", Load, Error,
         "the part is very large: {size:.4g} long if its file is in millimetres"_text,
         "print it smaller (--scale fit), or give the units it was drawn in (--units)"_text,
         kForHuge},
        {ThinPart, "thinPart", "thinPart", Load, ByAmount,
         "{share:.3g} of the part is thinner than the narrowest bead ({least}); most of it is {usual:.2f} thick"_text,
         "print it at scale {scale}, or use a process with narrower beads"_text, kForThin},
        {ThinPartInReach, "thinPartInReach", "thinPart", Load, ByAmount,
         "{share:.3g} of the part is thinner than the narrowest bead ({least}); most of it is {usual:.2f} thick"_text,
         "use a process with narrower beads; scaled up enough, the part is out of the robot's reach"_text,
         kForThinInReach, kFinest},
        {LiesBadly, "liesBadly", "liesBadly", Load, Info,
         "poor orientation: contact {contact:.0f}, overhang {overhang:.0f}, {missed:.2g} of the voxels missed; another orientation has contact {bestContact:.0f}, overhang {bestOverhang:.0f}, {bestMissed:.2g} missed"_text,
         "use that orientation, turned by {x:.3g} about x, {y:.3g} about y and {z:.3g} about z, or choose another one"_text,
         kForLying},
        {TurnedLeastRisky, "turnedLeastRisky", "turned", Load, Info,
         "the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang {overhang:.0f} instead of {overhangBefore:.0f#}"_text,
         "to keep the orientation as given, use orient=none"_text},
        {TurnedFewestMissed, "turnedFewestMissed", "turned", Load, Info,
         "the part was turned by {angle:.0f} about ({x}, {y}, {z}): {missed} missed voxel ({voxel:.2f} wide) instead of {missedBefore}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}|the part was turned by {angle:.0f} about ({x}, {y}, {z}): {missed} missed voxels ({voxel:.2f} wide) instead of {missedBefore}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}"_plural,
         "to keep the orientation as given, use orient=none"_text},
        {TurnedLeastResidual, "turnedLeastResidual", "turned", Load, Info,
         "the part was turned by {angle:.0f} about ({x}, {y}, {z}): residual area on XY {xy:.0f} instead of {xyBefore:.0f#}, on XZ {xz:.0f} instead of {xzBefore:.0f#}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}"_text,
         "to keep the orientation as given, use orient=none"_text},
        {TurnedLeastAfterCuts, "turnedLeastAfterCuts", "turned", Load, Info,
         "the part was turned by {angle:.0f} about ({x}, {y}, {z}): estimated overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}); uncut {overhang:.0f} instead of {overhangBefore:.0f#}"_text,
         "to keep the orientation as given, use orient=none"_text},
        {TurnedAfterCuts, "turnedAfterCuts", "turned", Load, Info,
         "the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}, estimated); uncut {overhang:.0f} instead of {overhangBefore:.0f#}"_text,
         "to keep the orientation as given, use orient=none"_text},
        {NotTurned, "notTurned", "notTurned", Load, Info,
         "the part keeps its orientation: the only other stable one is not better|the part keeps its orientation: none of {ways} stable ones is better"_plural,
         "orient it by hand"_text},
        {CellCannotPrint, "cellCannotPrint", "cell", Load, Error, "{fault}"_text, "{help}"_text,
         kForCell, kCellFile},
        {LargerThanPlates, "largerThanPlates", "tooLarge", Load, Error,
         "footprint of the part: {length:.0f} by {width:.0f}, larger than the cell's largest plate ({plate})"_text,
         "print the part at scale {scale}, or use a cell with a larger plate or a platform "
         "made for "
         "the part"_text,
         kForPlates},
        {PartsOverlap, "partsOverlap", "partsOverlap", Load, Error,
         "{first} and {second} overlap"_text, "arrange the parts"_text, kNoRemedies,
         "move one of the parts on the Prepare page, or arrange them"_text},
        {PartsBlock, "partsBlock", "partsBlock", Load, Info,
         "the head may touch {first} or {second} beside the other one: they are {gap:.1f} apart, the head needs {needed:.1f}"_text,
         "arrange the parts, or print them layer by layer"_text, kForBlocked},
        {PlatformAdrift, "platformAdrift", "platformAdrift", Decompose, Error,
         "platform {distance:.0f} beside its support: it would float"_text,
         "centre the part, or use a platform that reaches its support"_text, kForAdrift},
        {ShadowedUnderFacet, "shadowedUnderFacet", "shadowedVoxels", Decompose, Error,
         "{voxels} voxel is shadowed: covered by the convex front from step {step} on, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm|{voxels} voxels are shadowed: covered by the convex front from step {step} on, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm"_plural,
         kTurnOrShrink, kForShadowed, kHasRemedies, kMoreVoxels},
        {ShadowedUnreached, "shadowedUnreached", "shadowedVoxels", Decompose, Error,
         "{voxels} voxel is shadowed: covered by the convex front before growth reached it|"
         "{voxels} voxels are shadowed: covered by the convex front before growth reached them"_plural,
         kTurnOrShrink, kForShadowed, kHasRemedies, kMoreVoxels},
        {Unreached, "unreached", "unreachedVoxels", Decompose, Error,
         "{voxels} voxel is unreached: no path through the part from the platform|"
         "{voxels} voxels are unreached: no path through the part from the platform"_plural,
         kJoin, kForUnreached},
        {MissedGroups, "missedGroups", "missedVoxels", Decompose, Error,
         "{voxels} more voxel is missed, here|"
         "{voxels} more voxels are missed in smaller groups ({groups}); this is the largest"_plural,
         "turn the part or add supports"_text, kForShadowed},
        {BelowPlate, "belowPlate", "unreachedVoxels", Decompose, Error,
         "{voxels} voxel is below the plate|{voxels} voxels are below the plate"_plural,
         "move the part down to the plate"_text, kForUnreached},
        {SupportColumn, "supportColumn", "supportColumn", Decompose, Info,
         "support column of {voxels} from {foot}: it carries {carried} that would be missed"_text,
         kBreakOff},
        {SupportColumnTouching, "supportColumnTouching", "supportColumn", Decompose, Info,
         "support column of {voxels} from {foot}: it carries {carried} that would be missed"_text,
         "cut it off after printing: it touches the part at {faces} more face|"
         "cut it off after printing: it touches the part at {faces} more faces"_plural},
        {SupportColumns, "supportColumns", "supportColumns", Decompose, Info,
         "{columns} more support column under voxels that would be missed|{columns} more support columns under voxels that would be missed"_plural,
         "turn the part: other orientations may need fewer"_text},
        {PedestalGains, "pedestalGains", "pedestal", Decompose, Info,
         "without columns, {here} voxel would be missed on this plate, {there} on a pedestal as wide as the part's footprint|without columns, {here} voxels would be missed on this plate, {there} on a pedestal as wide as the part's footprint"_plural,
         "use a pedestal made for the part: it leaves room for the print head; a drawing of it is written"_text,
         kPedestal},
        {NoSupport, "noSupport", "noSupport", Decompose, Error,
         "no support column from the platform reaches {voxels} voxel that would be missed|"
         "no support column from the platform reaches {voxels} voxels that would be missed"_plural,
         "use a larger platform, or turn the part"_text, kForNoSupport},
        {ThinWall, "thinWall", "thinWalls", Decompose, Info,
         "wall {usual:.2f} thick ({thinnest:.2f} at its thinnest), thinner than a voxel of {voxel}"_text,
         kNarrowTo, kNarrow},
        {WallTooThin, "wallTooThin", "thinWalls", Decompose, Info,
         "wall {usual:.2f} thick ({thinnest:.2f} at its thinnest), thinner than a voxel of {voxel}"_text,
         kThicken},
        {ThinWalls, "thinWalls", "thinWalls", Decompose, Info,
         "{places} smaller place is thinner than a voxel of {voxel}; it is {thinnest:.2f} "
         "thick|"
         "{places} smaller places are thinner than a voxel of {voxel}; this is the largest, "
         "the "
         "thinnest "
         "is {thinnest:.2f} thick"_plural,
         kNarrowTo, kNarrow},
        {WallsTooThin, "wallsTooThin", "thinWalls", Decompose, Info,
         "{places} smaller place is thinner than a voxel of {voxel}; it is {thinnest:.2f} "
         "thick|"
         "{places} smaller places are thinner than a voxel of {voxel}; this is the largest, "
         "the "
         "thinnest "
         "is {thinnest:.2f} thick"_plural,
         kThicken},
        {OverhangOfPieces, "overhangOfPieces", "overhang", Decompose, Info,
         "{area:.3g} overhangs by more than {angle}"_text, kCutThere, kForOverhang},
        {OverhangsOfPieces, "overhangsOfPieces", "overhang", Decompose, Info,
         "{places} smaller place overhangs too far, {area:.3g}|{places} smaller places overhang too far, {area:.3g} in all; this is the largest"_plural,
         kCutThere, kForOverhang},
        {OverhangOfFlat, "overhangOfFlat", "overhang", Decompose, Info,
         "{area:.3g} overhangs by more than {angle}"_text, kTurnOrModes, kForOverhang},
        {OverhangsOfFlat, "overhangsOfFlat", "overhang", Decompose, Info,
         "{places} smaller place overhangs too far, {area:.3g}|{places} smaller places overhang too far, {area:.3g} in all; this is the largest"_plural,
         kTurnOrModes, kForOverhang},
        {OverhangOverRod, "overhangOverRod", "overhang", Decompose, Info,
         "{area:.3g} overhangs lower layers by more than {angle:.3g}, most at x = {x:.4g}, radius {radius:.4g}"_text,
         kGentlerRod, kForOverhang},
        {OverhangOverSurface, "overhangOverSurface", "overhang", Decompose, Info,
         "{area:.3g} overhangs lower layers by more than {angle:.3g}, most at {at:.4g}"_text,
         kGentlerSurface, kForOverhang},
        {BeyondCell, "beyondCell", "beyondCell", Decompose, Error,
         "the part extends to {reach:.4g} from the rod's axis; the cell prints up to {limit}"_text,
         "print the part smaller (scale)"_text, kForRod},
        {BlockedPieces, "blockedPieces", "blockedPieces", Decompose, Info,
         "blocked pieces: {blocked} of {pieces}; earlier pieces are in the print head's way"_text,
         "use other cutting planes (cutPlanes), turn the part, or use curved mode"_text},
        {SmallFoot, "smallFoot", "smallFoot", Decompose, Info,
         "small contact area: all pieces are held to the plate by {foot:.3g}; uncut, the part has {whole:.3g#}"_text,
         "place the part on a larger face, or use other cutting planes (cutPlanes)"_text},
        {UniformMisses, "uniformMisses", "uniformMisses", Decompose, Info,
         "unsupported voxels: {missed} of {voxels}|unsupported voxels: {missed} of {voxels}"_plural,
         kTurnOrOther, kTurn},
        {DroppedPieces, "droppedPieces", "droppedPieces", Layers, Info,
         "{pieces} piece of a layer is left out: too small for a bead, or it would begin in the air ({volume:.1f})|{pieces} pieces of layers are left out: too small for a bead, or they would begin in the air ({volume:.1f} in all, the largest {largest:.1f})"_plural,
         "use a narrower bead or a lower layer height for fine detail, supports for areas that begin in the air"_text},
        {UnsupportedPatches, "unsupportedPatches", "unsupportedPatches", Layers, Info,
         "{patches} patch ({area:.1f}) begins in the air: neither the plate nor an earlier layer is below it|{patches} patches ({area:.1f}) begin in the air: neither the plate nor an earlier layer is below them"_plural,
         "turn the part, enlarge the platform or add supports"_text},
        {Slivers, "slivers", "slivers", Layers, ByAmount,
         "{pieces} piece of a layer is left out, {volume:.3g} of {whole:.3g#}: too small for a bead, or it would begin in the air|{pieces} pieces of layers are left out, {volume:.3g} of {whole:.3g#}: too small for a bead, or they would begin in the air"_plural,
         kFiner, kForSlivers},
        {BeginsInAir, "beginsInAir", "beginsInAir", Layers, Error,
         "{pieces} piece of a layer begins in the air|{pieces} pieces of layers begin in the air"_plural,
         kTurnOrOther, kForAir},
        {BeginsInAirOverRod, "beginsInAirOverRod", "beginsInAir", Layers, Error,
         "a piece of a layer begins in the air, over neither the rod nor an earlier layer|{pieces} pieces of layers begin in the air, over neither the rod nor an earlier layer"_plural,
         "move the part on the rod, or extend it down to the rod there"_text, kForAirOverGround},
        {BeginsInAirOverSurface, "beginsInAirOverSurface", "beginsInAir", Layers, Error,
         "a piece of a layer begins in the air, over neither the surface nor an earlier layer|{pieces} pieces of layers begin in the air, over neither the surface nor an earlier layer"_plural,
         "move the part on the surface, or extend it down to the surface there"_text,
         kForAirOverGround},
        {NotLaid, "notLaid", "notLaid", Layers, Error,
         "not covered by layers: {left:.3g#} of {whole:.4g} of the part"_text,
         "choose layers that reach all of it (layerShape, layerCentre, endSurface)"_text,
         kForAirOverGround},
        {UnheldOverhang, "unheldOverhang", "unheldOverhang", Layers, Info,
         "{area:.3g} overhangs where a support would have no footing"_text,
         "use a larger platform (fit:MARGIN), or turn the part"_text, kForUnheld},
        {WalledSupport, "walledSupport", "walledSupport", Layers, Info,
         "support in closed hollows of the part cannot be removed: {volume:.3g}"_text,
         "open the hollow or turn the part; without supports (supports=none) the hollow's roof is "
         "unsupported"_text},
        {PlaneMisses, "planeMisses", "planeMisses", Layers, Info,
         "layer planes miss the part: {planes}"_text, "move or remove them"_text},
        {HeightBeyondLimits, "heightBeyondLimits", "heightBeyondLimits", Layers, Info,
         "{share:.0f} of the layers' area is thinner than {least} or thicker than {most}"_text,
         "move the planes, or add planes between them"_text},
        {PartsHinder, "partsHinder", "partsHinder", Layers, Error,
         "{share:.2g} of {first} cannot be printed layer by layer: its layers tilt the head into {second}"_text,
         "{help}"_text, kNoRemedies,
         "move one of the parts on the Prepare page, or print one after another"_text},
        {GivenWithoutSection, "givenWithoutSection", "givenWithoutSection", Toolpath, Info,
         "the file gives no width, height or speed for {points} point of its tool-paths: taken from process {process}|the file gives no width, height or speed for {points} points of its tool-paths: taken from process {process}"_plural,
         "choose the process that the tool-paths were made for"_text},
        {GivenTooFast,
         "givenTooFast", "givenTooFast", Toolpath, Info, "{points} point of the file's tool-paths needs more flow than the extruder's limit of {limit}: printed slower|{points} points of the file's tool-paths need more flow than the extruder's limit of {limit}: printed slower"_plural,
         "use a larger nozzle, or slower tool-paths"_text},
        {GivenOutsideLimits, "givenOutsideLimits", "givenOutsideLimits", Toolpath, Info,
         "{length:.0f} of the file's beads are outside the limits of process {process} (width {widthMin:.3g} to {widthMax:.3g}, height {heightMin:.3g} to {heightMax:.3g}): the worst is {width:.2f} wide and {height:.2f} high"_text,
         "choose the process that the file was sliced for, or slice it with beads of this process"_text},
        {PatchWithoutBead, "patchWithoutBead", "patchWithoutBead", Toolpath, ByAmount,
         "some areas are narrower than half a bead and stay empty"_text, kFiner, kForSlivers},
        {ThinWallsWidened, "thinWallsWidened", "thinWalls", Toolpath, Info,
         "{length:.0f} of walls, down to {width:.2f} thin, is printed too wide: with the narrowest bead, {bead:.3g}"_text,
         "use a finer nozzle, or leave them out (thinWalls=omit)"_text, kForSlivers},
        {ThinWallsLeftOut, "thinWallsLeftOut", "thinWalls", Toolpath, Info,
         "{length:.0f} of walls, down to {width:.2f} thin, is left out: the narrowest bead is {bead:.3g}"_text,
         "use a finer nozzle, or print them with that bead (thinWalls=bead)"_text, kForSlivers},
        {HollowSkin, "hollowSkin", "hollowSkin", Toolpath, Info,
         "the skin above a hollow interior has nothing to rest on: {paths} bead, from this place on|the skins above a hollow interior have nothing to rest on: {paths} beads, from this place on"_plural,
         "set infillDensity to 0.1 or more; for a part that is open at the top, set topLayers to 0"_text},
        {SpiralEnds, "spiralEnds", "spiralEnds", Toolpath, Info,
         "the spiral ends below layer {layer} of {layers}: its {beads} bead is not a closed loop|the spiral ends below layer {layer} of {layers}: it has {beads} beads, not one closed loop"_plural,
         "print towers as separate items, or cut off the part there; layers of several beads are printed as usual"_text},
        {SpiralInterrupted, "spiralInterrupted", "spiralEnds", Toolpath, Info,
         "the spiral ends below layer {layer} of {layers}, which does not continue the layer before"_text,
         "use thinner layers, or a part with steeper walls; another spiral may begin there"_text},
        {RimSupports, "rimSupports", "rimSupports", Toolpath, Info,
         "support beads ({volume:.3g}) under {paths} bead that would overhang just above the plate or the printed part|support beads ({volume:.3g}) under {paths} beads that would overhang just above the plate or the printed part"_plural,
         kBreakOff},
        {PrimeFalls, "primeFalls", "primeFalls", Toolpath, Info,
         "no room on the plate for the prime: a bead {length:.0f} long is printed in the air beside the plate and falls down here"_text,
         "clear this place, or use a larger plate (--platform)"_text},
        {BrimCut, "brimCut", "brimCut", Toolpath, Info,
         "no room on the plate for the whole brim, {width} wide: {share:.0f} of its length is left out"_text,
         "use a larger plate (--platform), move the part to the middle, or set a smaller brimWidthMm"_text,
         kForBrim},
        {Braced, "braced", "braced", Toolpath, Info,
         "{paths} unsupported bead is printed after its inner neighbour, with the nozzle tilted by up to {lean:.0f} more|{paths} unsupported beads are printed after their inner neighbours, with the nozzle tilted by up to {lean:.0f} more"_plural,
         "if you do not want this, turn the part or print it in flat layers with supports"_text},
        {Gouge, "gouge", "gouge", Toolpath, ByAmount,
         "the print head would cut into printed material, however it is tilted"_text,
         "use a slimmer print head, turn the part, or print it larger"_text, kForGouge},
        {Overload, "overload", "overload", Toolpath, ByAmount,
         "the flange carries {carried:.3g} kg, {material:.3g} kg of it printed material; the robot is rated for {most:.3g} kg"_text,
         "print a smaller part, or with less infill, or use a stronger robot"_text, kNoRemedies,
         "choose a cell with a stronger robot on the Prepare page"_text},
        {NoTape, "noTape", "noTape", Toolpath, Info,
         "no tape fits into the layers chosen for tapes: {width} wide and at least {length:.0f} long"_text,
         "choose another direction (fibreAngle), other paths (fibrePaths), or a narrower tape"_text},
        {TapesLeftOut, "tapesLeftOut", "tapesLeftOut", Toolpath, Info,
         "{bent:.0f} of tape is left out because it bends more than a radius of {radius:.0f} allows, {short:.0f} because its pieces are shorter than {length:.0f}"_text,
         "choose another direction (fibreAngle) or other paths (fibrePaths)"_text},
        {TapesBare, "tapesBare", "tapesBare", Toolpath, Info,
         "plastic does not cover the tape: {length:.0f} on layer {layer}, from this place on"_text,
         "increase fibreEndMm, or choose layers that others cover (fibreLayers, fibreFirstLayer)"_text},
        {NothingToPrint, "nothingToPrint", "nothingToPrint", Motion, Error,
         "no tool-paths left"_text, "choose a smaller voxelMm or beadWidthMm"_text, kForNothing},
        {TooLarge, "tooLarge", "unreachable", Motion, Error,
         "{share:.2g} of the tool-path points are out of the robot's reach; at {size:.2g} of this size all would be reachable"_text,
         "print it at scale {scale:.3g}, turn it, or use a larger robot"_text, kForTooLarge},
        {MuchOutOfReach, "muchOutOfReach", "unreachable", Motion, Error,
         "{share:.2g} of the tool-path points are out of the robot's reach"_text,
         "use flat layers, which need no tilt of the nozzle, turn the part, or use a larger robot"_text,
         kForOutOfReach},
        {Unreachable, "unreachable", "unreachable", Motion, Error,
         "{place}: out of the robot's reach, or beyond a joint limit, at every rotation tried about the nozzle"_text,
         kScaleOrTurn, kForOutOfReach, kHasRemedies, kMoreWaypoints},
        {Unconnected, "unconnected", "unconnected", Motion, Error,
         "{place}: reachable, but the robot cannot move from or to a neighbouring point without lifting"_text,
         kMoreTurns,
         kForUnconnected, kHasRemedies, kMoreWaypoints},
        {StaysUpright, "staysUpright", "staysUpright", Motion, Error,
         "this arm keeps the nozzle upright, but the layers need it tilted, first at {place}"_text,
         "use mode flat, or planar with upright layers"_text, kForUpright},
        {BeyondRod, "beyondRod", "beyondRod", Motion, Error,
         "{place}: too far from the rod: the cell prints up to {radius} from its axis and {along} from its middle"_text,
         kAlongRod, kForRod, kHasRemedies, kMoreWaypoints},
        {HeadInPart, "headInPart", "collision", Motion, Error,
         "{place}: the print head would cut into printed material"_text, kSlimmer, kForHeadInPart,
         kHasRemedies, kMoreWaypoints},
        {HeadInPlatform, "headInPlatform", "collision", Motion, Error,
         "{place}: the print head would cut into the platform"_text, kHigher, kForHeadInPlatform,
         kHasRemedies, kMoreWaypoints},
        {Collision, "collision", "collision", Motion, Error,
         "{place}: {first} would collide with {second} at every rotation tried about the nozzle"_text,
         kLessClearance, kForCollision, kHasRemedies, kMoreWaypoints},
        {MeetsOnCloserLook, "meetsOnCloserLook", "collision", Motion, Error,
         "{place}: skipped, because of a collision on the way to it"_text, kTurnOrClearance,
         kForCollision, kHasRemedies, kMoreWaypoints},
        {CollisionInMotion, "collisionInMotion", "collision", Motion, Error,
         "{first} collides with {second} in the finished motion"_text, kTurnOrClearance,
         kForCollision},
        {HomeMeets, "homeMeets", "collision", Motion, Error,
         "{first} collides with {second} in the home pose: no motion is possible"_text,
         "choose another home pose for the cell; if only the enclosing shapes of two links overlap, list the pair under neverMeet in the robot's file"_text,
         kForHome, kCellFile},
        {NoWayTo, "noWayTo", "transfer", Motion, Error,
         "{place}: no collision-free transfer to {pieces} piece of a path|{place}: no collision-free transfer to {pieces} pieces of paths"_plural,
         kTurnOrClearance, kForCollision},
        {NoWayBack, "noWayBack", "transfer", Motion, Error,
         "{place}: no collision-free transfer from home to the place where the print resumes"_text,
         "choose an earlier or a later bead"_text, kNoRemedies, kOtherBead},
        {NoWayFrom, "noWayFrom", "transfer", Motion, Error,
         "{place}: no collision-free transfer away from the end of {pieces} piece of a path|{place}: no collision-free transfer away from the ends of {pieces} pieces of paths"_plural,
         kTurnOrClearance, kForCollision},
        {LeftOut, "leftOut", "leftOut", Motion, Info,
         "{waypoints} waypoint ({share:.2g} of the material) is skipped; see the findings above|{waypoints} waypoints ({share:.2g} of the material) are skipped; see the findings above"_plural,
         "check these places in the view; turn the part if they matter"_text},
        {JerkOverLimit, "jerkOverLimit", "jerkOverLimit", Motion, Info,
         "jerk of joint {joint} at its greatest here: {jerk:.3g} rad/s³, limit {limit:.3g} rad/s³"_text,
         "smooth whole paths (rotationSmoothing=wholePath), print slower, or allow more jerk (maxJerk)"_text},
        {LongShot, "longShot", "longShot", Motion, Info,
         "{shots} shot into a pocket lasts up to {seconds:.1f}: after {most:.0f} in the pocket the nozzle melts the layers around it|{shots} shots into pockets last up to {seconds:.1f}: after {most:.0f} in a pocket the nozzle melts the layers around it"_plural,
         "use a process with a greater flow, or smaller pockets (stitchDiameter)"_text},
        {UnreadableLine, "unreadableLine", "unreadableLine", Replay, Error, "{defect}"_text,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {EndMissing, "endMissing", "endMissing", Replay, Error, "the end sequence is missing"_text,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {NoMotions, "noMotions", "programCutShort", Replay, Error,
         "the program has no motions"_text, kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {ProgramCutShort, "programCutShort", "programCutShort", Replay, Error,
         "the program ends here; {motions} planned motion is missing|the program ends here; {motions} planned motions are missing"_plural,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {OtherJob, "otherJob", "otherJob", Replay, ByAmount,
         "the program is from another job: {program}; this job is {job}"_text,
         "verify it against the job it was written from"_text, kNoRemedies, kOnlyWriteAgain},
        {OtherCell, "otherCell", "otherJob", Replay, ByAmount,
         "the program is for another cell: {program}; this job is {job}"_text,
         "verify it against the job it was written from"_text, kNoRemedies, kOnlyWriteAgain},
        {OtherProgram, "otherProgram", "otherProgram", Replay, Error,
         "the program's motions do not match this plan"_text,
         "verify it against the job it was written from"_text, kNoRemedies, kOnlyWriteAgain},
        {WaypointMoved, "waypointMoved", "waypointMoved", Replay, Error,
         "nozzle {distance:.3f} off the planned path"_text, kWriteAgain, kNoRemedies,
         kOnlyWriteAgain},
        {WaypointTilted, "waypointTilted", "waypointMoved", Replay, Error,
         "nozzle axis {angle:.2f} off the planned direction"_text, kWriteAgain, kNoRemedies,
         kOnlyWriteAgain},
        {WaypointsMissingBefore, "waypointsMissingBefore", "waypointsMissing", Replay, Error,
         "{motions} planned motion is missing before this one|{motions} planned motions are missing before this one"_plural,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {WaypointsMissingBetween, "waypointsMissingBetween", "waypointsMissing", Replay, Error,
         "{motions} planned motion is missing between {before} and this one|{motions} planned motions are missing between {before} and this one"_plural,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {MotionsUnplanned, "motionsUnplanned", "motionsUnplanned", Replay, Error,
         "{motions} motion from here on is not in the plan|{motions} motions from here on are not in the plan"_plural,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {WaypointsSwapped, "waypointsSwapped", "waypointsSwapped", Replay, Error,
         "this motion and the one at {other} are swapped"_text, kWriteAgain, kNoRemedies,
         kOnlyWriteAgain},
        {OtherConfiguration, "otherConfiguration", "otherConfiguration", Replay, Error,
         "the arm's configuration is not the planned one: a joint differs by {angle:.1f}"_text,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {ExternalAxisMoved, "externalAxisMoved", "externalAxisMoved", Replay, Error,
         "external axis {angle:.3f} off its planned position"_text, kWriteAgain, kNoRemedies,
         kOnlyWriteAgain},
        {ExtruderOnTravel, "extruderOnTravel", "extruderOnTravel", Replay, Error,
         "the extruder is on during a travel"_text, kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {ExtruderOffPrint, "extruderOffPrint", "extruderOffPrint", Replay, Error,
         "the extruder is off during a bead"_text, kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {SpeedChanged, "speedChanged", "speedChanged", Replay, Error,
         "this motion takes {time:.3f} instead of {planned:.3f}"_text, kWriteAgain, kNoRemedies,
         kOnlyWriteAgain},
        {FlowChanged, "flowChanged", "flowChanged", Replay, Error,
         "this motion deposits {volume:.3f} instead of {planned:.3f}"_text, kWriteAgain,
         kNoRemedies, kOnlyWriteAgain},
        {BeadByJoints, "beadByJoints", "beadByJoints", Replay, Error,
         "a bead is printed by a joint motion instead of a straight one"_text, kWriteAgain,
         kNoRemedies, kOnlyWriteAgain},
        {FlowsWhileStanding, "flowsWhileStanding", "flowsWhileStanding", Replay, Error,
         "{volume:.3f} is extruded here while the nozzle does not move for {time:.3f}"_text,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {StandsAmidPrint, "standsAmidPrint", "standsAmidPrint", Replay, Error,
         "the robot dwells here for {time:.2f} with the hot nozzle touching the part"_text,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {PrimeChanged, "primeChanged", "primeChanged", Replay, Error,
         "{volume:.3f} is extruded before the first bead instead of {planned:.3f}"_text,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {PurgeOnPart, "purgeOnPart", "purge", Replay, Error,
         "a prime or a purge of {volume:.0f} falls on the {body}"_text,
         "state a place for purges in the cell (purgeMm), or move the part"_text, kForHome,
         kCellFile},
        {PurgeOnPlate, "purgeOnPlate", "purge", Replay, Info,
         "a prime or a purge of {volume:.0f} falls on the plate, beside the print"_text,
         "remove the strand before it is dragged along, or state a place for purges in the cell (purgeMm)"_text},
        {FirstMotionFast, "firstMotionFast", "firstMotionFast", Replay, Error,
         "the first motion is too fast: it begins at an unknown pose of the arm"_text, kWriteAgain,
         kNoRemedies, kOnlyWriteAgain},
        {AccelerationChanged, "accelerationChanged", "accelerationChanged", Replay, Error,
         "commanded acceleration is {times:.1f} times the planned one"_text, kWriteAgain,
         kNoRemedies, kOnlyWriteAgain},
        {LoadChanged, "loadChanged", "loadChanged", Replay, Error,
         "stated payload {mass:.2f} kg, planned about {planned:.2f} kg"_text, kWriteAgain,
         kNoRemedies, kOnlyWriteAgain},
        {NozzleElsewhere, "nozzleElsewhere", "nozzleElsewhere", Replay, Error,
         "the program's nozzle is {distance:.2f} and {angle:.2f} off the cell's nozzle"_text,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {StatementMissing, "statementMissing", "statementMissing", Replay, Error,
         "missing before this line: {statement}"_text, kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {StatementChanged, "statementChanged", "statementChanged", Replay, Error,
         "{statement}: {found} in the program, {planned} planned"_text, kWriteAgain, kNoRemedies,
         kOnlyWriteAgain},
        {FanChanged, "fanChanged", "fanChanged", Replay, Info,
         "part cooling {found} % from this line on, {planned} % planned"_text, kWriteAgain,
         kNoRemedies, kOnlyWriteAgain},
        {OutputPasses, "outputPasses", "outputPasses", Replay, Error,
         "an extruder output is set while the arm is moving: it switches at the wrong place, or stops the arm on the bead"_text,
         "set it by a trigger of the next motion, or write the program again"_text, kNoRemedies,
         kOnlyWriteAgain},
        {PostureChanged, "postureChanged", "postureChanged", Replay, Error,
         "the arm's posture at this target: {found} in the program, {planned} planned"_text,
         kWriteAgain, kNoRemedies, kOnlyWriteAgain},
        {FlowErrors, "flowErrors", "flowErrors", Replay, Error,
         "at the controller's speeds, {share:.2f} of the bead length gets over 5 % too much or too little material; the first place is here"_text,
         "write the program again, with times instead of speeds where the format supports them"_text,
         kForFlowErrors},
        {Uncovered, "uncovered", "uncovered", Replay, Error,
         "{share:.2f} of the part is not covered by beads, mostly around this point"_text,
         "use lower layers or a finer nozzle, or print the part larger"_text, kForUncovered},
        {Overfill, "overfill", "overfill", Replay, Error,
         "{outside:.2f} of the part's volume is deposited outside it, {noRoom:.2f} does not fit"_text,
         "reduce the flow, or space the beads further apart"_text, kForFill},
        {Mass, "mass", "mass", Replay, Error, "deposited volume: {share:.2f} of the part's"_text,
         "check the flow and the infill density"_text, kForFill},
        {Unsupported, "unsupported", "unsupported", Replay, Error,
         "{length:.1f} of bead is unsupported; the first place is here"_text,
         "add supports, make sparse infill denser, turn the part, or let Voluta choose the way of "
         "building"_text,
         kForUnsupported},
        {LongBridge, "longBridge", "longBridge", Replay, Info,
         "{length:.1f} of a bead is unsupported; this material bridges {bridge:.1f}"_text,
         "add supports, make sparse infill denser, turn the part, or let Voluta choose the way of "
         "building"_text,
         kForLongBridge},
        {CoolingTime, "coolingTime", "coolingTime", Replay, Error,
         "the bead below is covered after {time:.1f}, before the minimum layer time of {limit:.1f}; so are {length:.0f} of beads"_text,
         "lower the minimum layer time, print slower, or print without a spiral"_text, kNoRemedies,
         kForCooling},
        {BondTime, "bondTime", "bondTime", Replay, Info,
         "the bead below is {time:.1f} old when it is covered, beyond the maximum layer time of {limit:.1f}; so are {length:.0f} of beads"_text,
         "print faster, or fewer parts at a time"_text},
        {ReplayedCollision, "replayedCollision", "collision", Replay, Error,
         "{first} and {second} collide"_text,
         "plan again with more clearance, or place the part elsewhere"_text, kForReplayed,
         kHasRemedies, kMoreCollisions},
        {OutOfReach, "outOfReach", "limit", Replay, Error, "the arm cannot reach this target"_text,
         kSlower, kForLimits, kHasRemedies, kMoreViolations},
        {JointRange, "jointRange", "limit", Replay, Error,
         "{joint} at {angle:.1f}, beyond its limit of {limit:.1f#}"_text, kSlower, kForLimits,
         kHasRemedies, kMoreViolations},
        {JointSpeed, "jointSpeed", "limit", Replay, Error,
         "{joint} at {speed:.1f}, above its limit of {limit:.1f#}"_text, kSlower, kForLimits,
         kHasRemedies, kMoreViolations},
        {SlideSpeed, "slideSpeed", "limit", Replay, Error,
         "{joint} at {speed:.1f}/s, above its limit of {limit:.1f#}"_text, kSlower, kForLimits,
         kHasRemedies, kMoreViolations},
        {BranchJump, "branchJump", "limit", Replay, Error,
         "the arm would have to change its configuration: {joint} would jump by {angle:.1f}"_text,
         kSlower, kForLimits, kHasRemedies, kMoreViolations},
        {BlendOverlap, "blendOverlap", "limit", Replay, Error,
         "two blends overlap, {blend:.3f} in all on a motion of {way:.3f}: the controller skips the waypoint"_text,
         kSlower, kForBlends, kHasRemedies, kMoreViolations},
        {Flow, "flow", "limit", Replay, Error,
         "flow of {flow:.1f}, above the extruder's limit of {limit:.1f#}"_text, kSlower, kForFlow,
         kHasRemedies, kMoreViolations},
        {PathDeviation, "pathDeviation", "deviation", Replay, Error,
         "nozzle {distance:.3f} off the planned path"_text,
         "use shorter motions or smaller blends"_text, kForDeviation},
        {ProgramRefused, "programRefused", "programRefused", Replay, Error,
         "the {format} program is not released: {failed}"_text,
         "see the findings before this one"_text, kNoRemedies, kOthersHelp},
        {ForeignRefused, "foreignRefused", "programRefused", Replay, Info,
         "the {format} program, for another controller, is not released: {failed}"_text,
         "use the program for the cell's own controller"_text},
        {GivenUncovered, "givenUncovered", "uncovered", Replay, Error,
         "{share:.2f} of the part is not covered by beads, mostly around this point"_text, kSliceDenser,
         kNoRemedies, kSlicersPaths},
        {GivenOverfill, "givenOverfill", "overfill", Replay, Error,
         "{outside:.2f} of the part's volume is deposited outside it, {noRoom:.2f} does not fit"_text, kSliceLess,
         kNoRemedies, kSlicersPaths},
        {GivenMass, "givenMass", "mass", Replay, Error,
         "deposited volume: {share:.2f} of the part's"_text, kSliceAmounts,
         kNoRemedies, kSlicersPaths},
        {GivenUnsupported, "givenUnsupported", "unsupported", Replay, Error,
         "{length:.1f} of bead is unsupported; the first place is here"_text, kSliceSupports,
         kNoRemedies, kSlicersPaths},
        {GivenLongBridge, "givenLongBridge", "longBridge", Replay, Info,
         "{length:.1f} of a bead is unsupported; this material bridges {bridge:.1f}"_text, kSliceSupports,
         kNoRemedies, kSlicersPaths},
        {FormatRefused, "formatRefused", "programRefused", Replay, Error,
         "no {format} program: {why}"_text, "{help}"_text, kNoRemedies, kOtherFormat},
        {WithoutForce, "withoutForce", "withoutForce", Replay, Info,
         "the {format} program lays beads by position, without the force of process {process}"_text,
         "to press with the force, use {formats}, or add the statements to the process (beadWords)"_text},
    });

// Kinds of older versions, as their ids in project files.
struct OldKind {
  std::string_view id;
  FindingKind kind;
  bool more = true; // Finding::more
};
constexpr OldKind kOldKinds[] = {
    {"shadowedUnderFacetAndMore", ShadowedUnderFacet},
    {"shadowedUnreachedAndMore", ShadowedUnreached},
    {"moreShadowed", MissedGroups, false},
    {"moreUnreached", MissedGroups, false},
    {"moreUnreachable", Unreachable},
    {"moreUnconnected", Unconnected},
    {"moreBeyondRod", BeyondRod},
    {"moreHeadInPart", HeadInPart},
    {"moreHeadInPlatform", HeadInPlatform},
    {"moreCollisions", Collision},
    {"moreMeetOnCloserLook", MeetsOnCloserLook},
    {"moreReplayedCollisions", ReplayedCollision},
    {"moreLimits", JointRange},
};

bool hasPlace(base::Text text, std::string_view name) {
  return std::ranges::count(base::placeNames(text.english()), name) > 0;
}

const OldKind* oldKind(std::string_view id) {
  const auto* found = std::ranges::find(kOldKinds, id, &OldKind::id);
  return found == std::end(kOldKinds) ? nullptr : found;
}

constexpr bool inOrder() {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (static_cast<std::size_t>(kRows[i].kind) != i)
      return false;
  return kRows.size() == static_cast<std::size_t>(WithoutForce) + 1;
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

std::vector<std::string_view> valueNames(const FindingRow& row, bool more) {
  std::vector<std::string_view> names;
  const auto add = [&](std::string_view name) {
    if (std::ranges::find(names, name) == names.end())
      names.push_back(name);
  };
  if (!more || hasPlace(row.more, kReason))
    std::ranges::for_each(base::placeNames(row.reason.english()), add);
  if (more)
    for (const std::string_view name : base::placeNames(row.more.english()))
      if (name != kCount && name != kReason)
        add(name);
  std::ranges::for_each(base::placeNames(row.remedy.english()), add);
  return names;
}

const FindingRow* rowWithId(std::string_view id) {
  if (const OldKind* old = oldKind(id))
    return &rowOf(old->kind);
  const auto* found =
      std::find_if(kRows.begin(), kRows.end(), [&](const FindingRow& row) { return row.id == id; });
  return found == kRows.end() ? nullptr : found;
}

bool isIdOfMore(std::string_view id) {
  const OldKind* old = oldKind(id);
  return old && old->more;
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
