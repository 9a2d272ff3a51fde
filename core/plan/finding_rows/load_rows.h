// Findings of stage load.
#pragma once

#include "plan/finding_rows/row.h"

namespace voluta::plan::finding_rows {

inline constexpr base::Text kKeepVoxels =
    "to keep its voxels, rotate it by multiples of 90° and lift it by whole voxels"_text;
inline constexpr base::Text kThinnerThanBead =
    "{share:.3g} of the part is thinner than the narrowest bead ({least}); most of it is {usual:.2f} thick"_text;
inline constexpr base::Text kKeepOrientation =
    "to keep the orientation as given, use `orient=none`"_text;

inline constexpr FindingRow kLoadRows[] = {
    info(CellsTurned, "cellsTurned",
         "the voxel object is not rotated by a multiple of 90°: it is cut into new voxels"_text,
         kKeepVoxels, {.reportId = "newCells"}),
    info(CellsLifted, "cellsLifted",
         "the voxel object is lifted by a fraction of a voxel: it is cut into new voxels"_text,
         kKeepVoxels, {.reportId = "newCells"}),
    info(MeshDefect, "meshDefect", "{defect}"_text,
         "repair the mesh in a modelling program if the result looks wrong"_text),
    error(
        OpenRims, "openSurface",
        "open surface: {rims} open edge loop, {width:.3g} wide|open surface: {rims} open edge loops, the widest {width:.3g} wide"_plural,
        "print it as one wall (`openSurfaces=wall`), thicken it to a wall of two beads (`openSurfaces=thicken`), close its rims to make it solid (`openSurfaces=close`), or close it in a modelling program"_text,
        {.remedies = kOffers<WallSurface, ThickenSurface, CloseRims>}),
    error(
        SheetModel, "sheetModel",
        "sheet model: {share:.3g} of the surface has no thickness, {triangles} triangles"_text,
        "print the sheets as walls of one bead (`openSurfaces=wall`) or two (`openSurfaces=thicken`), or give them a thickness in a modelling program"_text,
        {.reportId = "openSurface", .remedies = kOffers<WallSurface, ThickenSurface>}),
    info(RimsClosed, "rimsClosed",
         "open edges were closed: {share:.3g} of the surface is patches"_text,
         "to get a wall instead, use `openSurfaces=thicken`"_text, {.reportId = "openSurface"}),
    info(
        SheetsLeftOut, "sheetsLeftOut",
        "sheets without thickness were left out: {share:.3g} of the surface, {triangles} triangles"_text,
        "to get walls instead, use `openSurfaces=thicken`"_text, {.reportId = "openSurface"}),
    info(SurfaceThickened, "surfaceThickened",
         "the open surface was thickened to a wall of {wall:.2f}, half on each side"_text,
         "to get a solid instead, use `openSurfaces=close`"_text, {.reportId = "openSurface"}),
    info(SurfaceAsWall, "surfaceAsWall",
         "the open surface is printed as one wall, one bead ({width:.2f}) wide"_text,
         "to get a wall of two beads instead, use `openSurfaces=thicken`"_text,
         {.reportId = "openSurface"}),
    error(TinyPart, "tinyPart",
          "the part is very small: {size:.3g} long if its file is in millimetres"_text,
          "give the units it was drawn in (`--units`)"_text,
          {.reportId = "oddSize", .remedies = kOffers<UnitsMetres, UnitsInches>}),
    error(HugePart, "hugePart",
          "the part is very large: {size:.4g} long if its file is in millimetres"_text,
          "print it smaller (`--scale fit`), or give the units it was drawn in (`--units`)"_text,
          {.reportId = "oddSize", .remedies = kOffers<ScaleToFit, UnitsMicrometres>}),
    byAmount(ThinPart, "thinPart", kThinnerThanBead,
             "print it at scale {scale}, or use a process with narrower beads"_text,
             {.remedies = kOffers<ScaleUp, FinerProcess>}),
    byAmount(
        ThinPartInReach, "thinPartInReach", kThinnerThanBead,
        "use a process with narrower beads; scaled up enough, the part is out of the robot's reach"_text,
        {.reportId = "thinPart",
         .remedies = kOffers<FinerProcess>,
         .whyNoRemedy = "no available process has narrower beads"_text}),
    info(
        LiesBadly, "liesBadly",
        "poor orientation: contact {contact:.0f}, overhang {overhang:.0f}, {missed:.2g} of the voxels missed; another orientation has contact {bestContact:.0f}, overhang {bestOverhang:.0f}, {bestMissed:.2g} missed"_text,
        "use that orientation, turned by {x:.3g} about x, {y:.3g} about y and {z:.3g} about z, or choose another one"_text,
        {.remedies = kOffers<StandBest>}),
    info(
        TurnedMinRiskyArea, "turnedLeastRisky",
        "the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang {overhang:.0f} instead of {overhangBefore:.0f#}"_text,
        kKeepOrientation, {.reportId = "turned"}),
    info(
        TurnedFewestMissed, "turnedFewestMissed",
        "the part was turned by {angle:.0f} about ({x}, {y}, {z}): {missed} missed voxel ({voxel:.2f} wide) instead of {missedBefore}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}|the part was turned by {angle:.0f} about ({x}, {y}, {z}): {missed} missed voxels ({voxel:.2f} wide) instead of {missedBefore}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}"_plural,
        kKeepOrientation, {.reportId = "turned"}),
    info(
        TurnedMinResidualArea, "turnedLeastResidual",
        "the part was turned by {angle:.0f} about ({x}, {y}, {z}): residual area on XY {xy:.0f} instead of {xyBefore:.0f#}, on XZ {xz:.0f} instead of {xzBefore:.0f#}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}"_text,
        kKeepOrientation, {.reportId = "turned"}),
    info(
        TurnedMinAfterCuts, "turnedLeastAfterCuts",
        "the part was turned by {angle:.0f} about ({x}, {y}, {z}): estimated overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}); uncut {overhang:.0f} instead of {overhangBefore:.0f#}"_text,
        kKeepOrientation, {.reportId = "turned"}),
    info(
        TurnedAfterCuts, "turnedAfterCuts",
        "the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}, estimated); uncut {overhang:.0f} instead of {overhangBefore:.0f#}"_text,
        kKeepOrientation, {.reportId = "turned"}),
    info(
        TurnedLeastTension, "turnedLeastTension",
        "the part was turned by {angle:.0f} about ({x}, {y}, {z}): tension across its layers {tension:.2g} MPa instead of {tensionBefore:.2g}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}"_text,
        kKeepOrientation, {.reportId = "turned"}),
    info(
        NotTurned, "notTurned",
        "the part keeps its orientation: the only other stable one is not better|the part keeps its orientation: none of {ways} stable ones is better"_plural,
        "orient it by hand"_text),
    error(CellCannotPrint, "cellCannotPrint", "{fault}"_text, "{help}"_text,
          {.reportId = "cell",
           .remedies = kOffers<UsualProcess, UsualCell>,
           .whyNoRemedy = kCellFile}),
    error(
        LargerThanPlates, "largerThanPlates",
        "footprint of the part: {length:.0f} by {width:.0f}, larger than the cell's largest plate ({plate})"_text,
        "print the part at scale {scale}, or use a cell with a larger plate or a platform made for the part"_text,
        {.reportId = "tooLarge", .remedies = kOffers<ScaleToPlate, LargerCell, MakePlatform>}),
    error(PartsOverlap, "partsOverlap", "{first} and {second} overlap"_text,
          "arrange the parts"_text,
          {.whyNoRemedy = "move one of the parts on the Prepare page, or arrange them"_text}),
    info(
        PartsBlock, "partsBlock",
        "the head may touch {first} or {second} beside the other one: they are {gap:.1f} apart, the head needs {needed:.1f}"_text,
        "arrange the parts, or print them layer by layer"_text,
        {.remedies = kOffers<PrintByLayer>}),
    error(
        GivenAmountDiffers, "givenAmountDiffers",
        "the file extrudes {stated:.0f} by its E words, the tool-paths taken from it have {read:.0f}; they part {line}"_text,
        "look at that line: export the file again without it, with straight lines or arcs (G1, G2, G3)"_text,
        {.whyNoRemedy = kSlicersPaths}),
    error(GivenOddSize, "givenOddSize", kSameReason,
          "export the file again in millimetres, at the size to be printed"_text,
          {.reportId = "oddSize", .whyNoRemedy = kSlicersPaths}),
    byAmount(
        GivenThinPart, "givenThinPart", kSameReason,
        "choose a process with narrower beads, or slice the part again with wider ones"_text,
        {.reportId = "thinPart", .remedies = kOffers<FinerProcess>, .whyNoRemedy = kSlicersPaths}),
    error(GivenTooLarge, "givenTooLarge", kSameReason,
          "use a cell with a larger plate, or slice the part again at a smaller size"_text,
          {.reportId = "tooLarge", .remedies = kOffers<LargerCell>, .whyNoRemedy = kSlicersPaths}),
};

} // namespace voluta::plan::finding_rows
