// Findings of stage decompose.
#pragma once

#include "plan/finding_rows/row.h"

namespace voluta::plan::finding_rows {

inline constexpr base::Text kColumn =
    "support column of {voxels} from {foot}: it carries {carried} that would be missed"_text;
inline constexpr base::Text kWallThinner =
    "wall {usual:.2f} thick ({thinnest:.2f} at its thinnest), thinner than a voxel of {voxel}"_text;
inline constexpr base::Text kPlacesThinner =
    "{places} smaller place is thinner than a voxel of {voxel}; it is {thinnest:.2f} thick|{places} smaller places are thinner than a voxel of {voxel}; this is the largest, the thinnest is {thinnest:.2f} thick"_plural;
inline constexpr base::Text kOverhangs = "{area:.3g} overhangs by more than {angle}"_text;
inline constexpr base::Text kPlacesOverhang =
    "{places} smaller place overhangs too far, {area:.3g}|{places} smaller places overhang too far, {area:.3g} in all; this is the largest"_plural;
inline constexpr std::span<const RemedyId> kForShadowed =
    kOffers<ShrinkPlatform, AddSupports, OrientPart>;
inline constexpr std::span<const RemedyId> kForUnreached =
    kOffers<DropToPlate, AddSupports, OrientPart>;
inline constexpr std::span<const RemedyId> kForOverhang =
    kOffers<AddSupports, RotateToMinRiskyArea>;
inline constexpr std::span<const RemedyId> kNarrow = kOffers<NarrowVoxels>;
inline constexpr base::Text kRotateOrShrink =
    "turn the part, make the platform smaller or add supports"_text;
inline constexpr base::Text kNarrowTo = "use a voxel width of at most {fits}"_text;
inline constexpr base::Text kThicken = "thicken the wall to {least} or more"_text;
inline constexpr base::Text kCutThere =
    "add supports (`supports=auto`), cut there, or use curved mode"_text;
inline constexpr base::Text kRotateOrModes =
    "turn the part (`orient=leastRisky`), add supports, or use planar or curved mode"_text;
inline constexpr base::Text kMoreVoxels =
    "{what}; another voxel depends on this|{what}; {more} more voxels depend on this"_plural;

inline constexpr FindingRow kDecomposeRows[] = {
    error(PlatformAdrift, "platformAdrift",
          "platform {distance:.0f} beside its support: it would float"_text,
          "centre the part, or use a platform that reaches its support"_text,
          {.remedies = kOffers<CellPlate, CentrePart>}),
    error(
        ShadowedUnderFacet, "shadowedUnderFacet",
        "{voxels} voxel is shadowed: covered by the convex front from step {step} on, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm|{voxels} voxels are shadowed: covered by the convex front from step {step} on, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm"_plural,
        kRotateOrShrink,
        {.reportId = "shadowedVoxels", .remedies = kForShadowed, .more = kMoreVoxels}),
    error(
        ShadowedUnreached, "shadowedUnreached",
        "{voxels} voxel is shadowed: covered by the convex front before growth reached it|{voxels} voxels are shadowed: covered by the convex front before growth reached them"_plural,
        kRotateOrShrink,
        {.reportId = "shadowedVoxels", .remedies = kForShadowed, .more = kMoreVoxels}),
    error(
        Unreached, "unreached",
        "{voxels} voxel is unreached: no path through the part from the platform|{voxels} voxels are unreached: no path through the part from the platform"_plural,
        "use a larger platform or supports, or join this piece to the part"_text,
        {.reportId = "unreachedVoxels", .remedies = kForUnreached}),
    error(
        MissedGroups, "missedGroups",
        "{voxels} more voxel is missed, here|{voxels} more voxels are missed in smaller groups ({groups}); this is the largest"_plural,
        "turn the part or add supports"_text,
        {.reportId = "missedVoxels", .remedies = kForShadowed}),
    error(BelowPlate, "belowPlate",
          "{voxels} voxel is below the plate|{voxels} voxels are below the plate"_plural,
          "move the part down to the plate"_text,
          {.reportId = "unreachedVoxels", .remedies = kForUnreached}),
    info(SupportColumn, "supportColumn", kColumn, kBreakOff),
    info(
        SupportColumnTouching, "supportColumnTouching", kColumn,
        "cut it off after printing: it touches the part at {faces} more face|cut it off after printing: it touches the part at {faces} more faces"_plural,
        {.reportId = "supportColumn"}),
    info(
        SupportColumns, "supportColumns",
        "{columns} more support column under voxels that would be missed|{columns} more support columns under voxels that would be missed"_plural,
        "turn the part: other orientations may need fewer"_text),
    info(
        PedestalGains, "pedestalGains",
        "without columns, {here} voxel would be missed on this plate, {there} on a pedestal as wide as the part's footprint|without columns, {here} voxels would be missed on this plate, {there} on a pedestal as wide as the part's footprint"_plural,
        "use a pedestal made for the part: it leaves room for the print head; a drawing of it is written"_text,
        {.reportId = "pedestal", .remedies = kOffers<ShrinkPlatform>}),
    error(
        NoSupport, "noSupport",
        "no support column from the platform reaches {voxels} voxel that would be missed|no support column from the platform reaches {voxels} voxels that would be missed"_plural,
        "use a larger platform, or turn the part"_text,
        {.remedies = kOffers<WidenPlatform, OrientPart, PrintFlat>}),
    info(ThinWall, "thinWall", kWallThinner, kNarrowTo,
         {.reportId = "thinWalls", .remedies = kNarrow}),
    info(WallTooThin, "wallTooThin", kWallThinner, kThicken, {.reportId = "thinWalls"}),
    info(ThinWalls, "thinWalls", kPlacesThinner, kNarrowTo, {.remedies = kNarrow}),
    info(WallsTooThin, "wallsTooThin", kPlacesThinner, kThicken, {.reportId = "thinWalls"}),
    info(OverhangOfPieces, "overhangOfPieces", kOverhangs, kCutThere,
         {.reportId = "overhang", .remedies = kForOverhang}),
    info(OverhangsOfPieces, "overhangsOfPieces", kPlacesOverhang, kCutThere,
         {.reportId = "overhang", .remedies = kForOverhang}),
    info(OverhangOfFlat, "overhangOfFlat", kOverhangs, kRotateOrModes,
         {.reportId = "overhang", .remedies = kForOverhang}),
    info(OverhangsOfFlat, "overhangsOfFlat", kPlacesOverhang, kRotateOrModes,
         {.reportId = "overhang", .remedies = kForOverhang}),
    info(
        OverhangOverRod, "overhangOverRod",
        "{area:.3g} overhangs lower layers by more than {angle:.3g}, most at x = {x:.4g}, radius {radius:.4g}"_text,
        "give the part a gentler slope from the rod there"_text,
        {.reportId = "overhang", .remedies = kForOverhang}),
    info(OverhangOverSurface, "overhangOverSurface",
         "{area:.3g} overhangs lower layers by more than {angle:.3g}, most at {at:.4g}"_text,
         "give the part a gentler slope from the surface there"_text,
         {.reportId = "overhang", .remedies = kForOverhang}),
    error(BeyondCell, "beyondCell",
          "the part extends to {reach:.4g} from the rod's axis; the cell prints up to {limit}"_text,
          "print the part smaller (scale)"_text, {.remedies = kForRod}),
    info(BlockedPieces, "blockedPieces",
         "blocked pieces: {blocked} of {pieces}; earlier pieces are in the print head's way"_text,
         "use other cutting planes (`cutPlanes`), turn the part, or use curved mode"_text),
    info(SmallFoot, "smallFoot",
         "small contact with the plate: {foot:.3g}; uncut, the part has {whole:.3g#}"_text,
         "place the part on a larger face, or use other cutting planes (`cutPlanes`)"_text),
    info(
        UniformMisses, "uniformMisses",
        "unsupported voxels in flat layers: {missed} of {voxels} ({share:.1f}); no layer below carries them"_text,
        kRotateOrOther, {.remedies = kOffers<RotateToMinRiskyArea>}),
};

} // namespace voluta::plan::finding_rows
