// Findings of stage layers.
#pragma once

#include "plan/finding_rows/row.h"

namespace voluta::plan::finding_rows {

inline constexpr std::span<const RemedyId> kForAirOverGround = kOffers<PrintOnPlate>;

inline constexpr FindingRow kLayersRows[] = {
    info(
        DroppedPieces, "droppedPieces",
        "{pieces} piece of a layer is left out: too small for a bead, or it would begin in the air ({volume:.1f})|{pieces} pieces of layers are left out: too small for a bead, or they would begin in the air ({volume:.1f} in all, the largest {largest:.1f})"_plural,
        "use a narrower bead or a lower layer height for fine detail, supports for areas that begin in the air"_text),
    info(
        UnsupportedPatches, "unsupportedPatches",
        "{patches} patch ({area:.1f}) begins in the air: neither the plate nor an earlier layer is below it|{patches} patches ({area:.1f}) begin in the air: neither the plate nor an earlier layer is below them"_plural,
        "turn the part, enlarge the platform or add supports"_text),
    byAmount(
        Slivers, "slivers",
        "{pieces} piece of a layer is left out, {volume:.3g} of {whole:.3g#}: too small for a bead, or it would begin in the air|{pieces} pieces of layers are left out, {volume:.3g} of {whole:.3g#}: too small for a bead, or they would begin in the air"_plural,
        kFiner, {.remedies = kForSlivers}),
    error(
        BeginsInAir, "beginsInAir",
        "{pieces} piece of a layer begins in the air|{pieces} pieces of layers begin in the air"_plural,
        "add supports (`supports=auto`), turn the part, or use planar or curved mode"_text,
        {.remedies = kOffers<AddSupports, RotateToMinRiskyArea, ChooseStrategy>}),
    error(
        BeginsInAirOverRod, "beginsInAirOverRod",
        "a piece of a layer begins in the air, over neither the rod nor an earlier layer|{pieces} pieces of layers begin in the air, over neither the rod nor an earlier layer"_plural,
        "move the part on the rod, or extend it down to the rod there"_text,
        {.reportId = "beginsInAir", .remedies = kForAirOverGround}),
    error(
        BeginsInAirOverSurface, "beginsInAirOverSurface",
        "a piece of a layer begins in the air, over neither the surface nor an earlier layer|{pieces} pieces of layers begin in the air, over neither the surface nor an earlier layer"_plural,
        "move the part on the surface, or extend it down to the surface there"_text,
        {.reportId = "beginsInAir", .remedies = kForAirOverGround}),
    error(NotPrinted, "notLaid",
          "not covered by layers: {left:.3g#} of {whole:.4g} of the part"_text,
          "choose layers that reach all of it (`layerShape`, `layerCentre`, `endSurface`)"_text,
          {.remedies = kForAirOverGround}),
    info(UnheldOverhang, "unheldOverhang", "no platform below the overhang: {area:.3g}"_text,
         "use a larger platform (fit:MARGIN), or turn the part"_text,
         {.remedies = kOffers<WidenPlatform, RotateToMinRiskyArea>}),
    info(
        WalledSupport, "walledSupport",
        "support in closed hollows of the part cannot be removed: {volume:.3g}"_text,
        "open the hollow or turn the part; without supports (`supports=none`, `rimSupports=none`) the hollow's roof is unsupported"_text),
    info(PlaneMisses, "planeMisses", "layer planes miss the part: {planes}"_text,
         "move or remove them"_text),
    info(HeightBeyondLimits, "heightBeyondLimits",
         "{share:.0f} of the layers' area is thinner than {least} or thicker than {most}"_text,
         "move the planes, or add planes between them"_text),
    error(
        PartsHinder, "partsHinder",
        "{share:.2g} of {first} cannot be printed layer by layer: its layers tilt the head into {second}"_text,
        "{help}"_text,
        {.whyNoRemedy =
             "move one of the parts on the Prepare page, or print one after another"_text}),
    info(
        RegionOutside, "regionOutside",
        "region {region} is outside the part, behind later regions, or not painted: it has no effect"_text,
        "move it into the part, paint it, or remove it"_text),
    info(RegionWithoutEffect, "regionWithoutEffect", "no effect of region {region}: {reason}"_text,
         "{help}"_text),
    info(Staircase, "staircase",
         "{share:.0f} of the surface are gentle slopes with steps of {mean:.2g} on average"_text,
         "a skin of layers along the surface has none"_text, {.remedies = kOffers<AddSkin>}),
};

} // namespace voluta::plan::finding_rows
