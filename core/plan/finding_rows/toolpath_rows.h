// Findings of stage toolpath.
#pragma once

#include "plan/finding_rows/row.h"

namespace voluta::plan::finding_rows {

inline constexpr FindingRow kToolpathRows[] = {
    info(
        GivenWithoutSection, "givenWithoutSection",
        "the file gives no width, height or speed for {points} point of its tool-paths: taken from process {process}|the file gives no width, height or speed for {points} points of its tool-paths: taken from process {process}"_plural,
        "choose the process that the tool-paths were made for"_text),
    info(
        GivenTooFast, "givenTooFast",
        "{points} point of the file's tool-paths needs more flow than the extruder's limit of {limit}: printed slower|{points} points of the file's tool-paths need more flow than the extruder's limit of {limit}: printed slower"_plural,
        "use a larger nozzle, or slower tool-paths"_text),
    info(
        GivenOutsideLimits, "givenOutsideLimits",
        "{length:.0f} of the file's beads are outside the limits of process {process} (width {widthMin:.3g} to {widthMax:.3g}, height {heightMin:.3g} to {heightMax:.3g}): the worst is {width:.2f} wide and {height:.2f} high"_text,
        "choose the process that the file was sliced for, or slice it with beads of this process"_text),
    byAmount(PatchWithoutBead, "patchWithoutBead",
             "some areas are narrower than half a bead and stay empty"_text, kFiner,
             {.remedies = kForSlivers}),
    info(
        ThinWallsWidened, "thinWallsWidened",
        "{length:.0f} of walls, down to {width:.2f} thin, is printed too wide: with the narrowest bead, {bead:.3g}"_text,
        "use a finer nozzle, or leave them out (`thinWalls=omit`)"_text,
        {.reportId = "thinWalls", .remedies = kForSlivers}),
    info(
        ThinWallsLeftOut, "thinWallsLeftOut",
        "{length:.0f} of walls, down to {width:.2f} thin, is left out: the narrowest bead is {bead:.3g}"_text,
        "use a finer nozzle, or print them with that bead (`thinWalls=bead`)"_text,
        {.reportId = "thinWalls", .remedies = kForSlivers}),
    info(
        HollowSkin, "hollowSkin",
        "the skin above a hollow interior has nothing to rest on: {paths} bead, from this place on|the skins above a hollow interior have nothing to rest on: {paths} beads, from this place on"_plural,
        "set `infillDensity` to 0.1 or more; for a part that is open at the top, set `topLayers` to 0"_text),
    info(SparseShare, "sparseShare",
         "sparse infill fills {found:.0f} of the interior instead of {asked:.0f}: {reason}"_text,
         "choose another pattern or another share, or a quality that accepts longer bridges"_text),
    info(
        SpiralEnds, "spiralEnds",
        "the spiral ends below layer {layer} of {layers}: its {beads} bead is not a closed loop|the spiral ends below layer {layer} of {layers}: it has {beads} beads, not one closed loop"_plural,
        "print towers as separate items, or cut off the part there; layers of several beads are printed as usual"_text),
    info(
        SpiralInterrupted, "spiralInterrupted",
        "the spiral ends below layer {layer} of {layers}, which does not continue the layer before"_text,
        "use thinner layers, or a part with steeper walls; another spiral may begin there"_text,
        {.reportId = "spiralEnds"}),
    info(
        RimSupports, "rimSupports",
        "support beads ({volume:.3g}) under {paths} bead that would overhang just above the plate or the printed part|support beads ({volume:.3g}) under {paths} beads that would overhang just above the plate or the printed part"_plural,
        kBreakOff),
    info(
        PrimeFalls, "primeFalls",
        "no room on the plate for the prime: a bead {length:.0f} long is printed in the air beside the plate and falls down here"_text,
        "clear this place, or use a larger plate (`--platform`)"_text),
    info(
        BrimCut, "brimCut",
        "no room on the plate for the whole brim, {width} wide: {share:.0f} of its length is left out"_text,
        "use a larger plate (`--platform`), move the part to the middle, or set a smaller `brimWidthMm`"_text,
        {.remedies = kOffers<WidenPlatform, CentrePart>}),
    info(
        Braced, "braced",
        "{paths} unsupported bead is printed after its inner neighbour, with the nozzle tilted by up to {lean:.0f} more|{paths} unsupported beads are printed after their inner neighbours, with the nozzle tilted by up to {lean:.0f} more"_plural,
        "if you do not want this, turn the part or print it in flat layers with supports"_text),
    byAmount(Gouge, "gouge",
             "the print head would cut into printed material, however it is tilted"_text,
             "use a slimmer print head, turn the part, or print it larger"_text,
             {.remedies = kOffers<FinerProcess, Enlarge, PrintFlat, ChooseStrategy>}),
    byAmount(
        Overload, "overload",
        "the flange carries {carried:.3g} kg, {material:.3g} kg of it printed material; the robot is rated for {most:.3g} kg"_text,
        "print a smaller part, or with less infill, or use a stronger robot"_text,
        {.whyNoRemedy = "choose a cell with a stronger robot on the Prepare page"_text,
         .concern = Concern::Safety}),
    info(
        NoTape, "noTape",
        "no tape fits into the layers chosen for tapes: {width} wide and at least {length:.0f} long"_text,
        "choose another direction (`fibreAngle`), other paths (`fibrePaths`), or a narrower tape"_text),
    info(
        TapesLeftOut, "tapesLeftOut",
        "{bent:.0f} of tape is left out because it bends more than a radius of {radius:.0f} allows, {short:.0f} because its pieces are shorter than {length:.0f}"_text,
        "choose another direction (`fibreAngle`) or other paths (`fibrePaths`)"_text),
    info(
        TapesBare, "tapesBare",
        "plastic does not cover the tape: {length:.0f} on layer {layer}, from this place on"_text,
        "increase `fibreEndMm`, or choose layers that others cover (`fibreLayers`, `fibreFirstLayer`)"_text),
    byAmount(
        InsertMisplaced, "insertMisplaced",
        "the inserted part {insert} does not fit: {reason}"_text,
        "move its region, or choose the layer before which it is put in"_text,
        {.whyNoRemedy = "move its region on the Prepare page"_text}),
    info(SettingWithoutEffect, "settingWithoutEffect", "no effect of {key}: {reason}"_text,
         "{help}"_text),
    info(LoadFiguresUnknown, "loadFiguresUnknown",
         "unknown {figures} under the forces: {reason}"_text, "{help}"_text),
};

} // namespace voluta::plan::finding_rows
