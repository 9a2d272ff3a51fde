// Findings of stage motion.
#pragma once

#include "plan/finding_rows/row.h"

namespace voluta::plan::finding_rows {

inline constexpr std::span<const RemedyId> kForOutOfReach =
    kOffers<ScaleToFit, Shrink, CentrePart, LargerCell, PrintFlat>;
inline constexpr std::span<const RemedyId> kForCollision =
    kOffers<LessClearance, MoreTurns, Shrink, CentrePart>;
inline constexpr base::Text kRotateOrClearance = "turn the part, or allow less clearance"_text;
inline constexpr base::Text kMoveOrClearance =
    "move the part on the plate, use a slimmer print head, or allow less clearance"_text;
inline constexpr std::span<const RemedyId> kForGivenCollision =
    kOffers<LessClearance, MoreTurns, CentrePart>;
inline constexpr base::Text kMoreWaypoints =
    "{count} more waypoint: {what}|{count} more waypoints, the first: {what}"_plural;

inline constexpr FindingRow kMotionRows[] = {
    error(NothingToPrint, "nothingToPrint", "no tool-paths left"_text,
          "choose a smaller `voxelMm` or `beadWidthMm`"_text,
          {.remedies = kOffers<FinerProcess, Enlarge>}),
    error(
        TooLarge, "tooLarge",
        "{share:.2g} of the tool-path points are out of the robot's reach; at {size:.2g} of this size all would be reachable"_text,
        "print it at scale {scale:.3g}, turn it, or use a larger robot"_text,
        {.reportId = "unreachable", .remedies = kOffers<ScaleToReach, LargerCell, PrintFlat>}),
    error(
        MuchOutOfReach, "muchOutOfReach",
        "{share:.2g} of the tool-path points are out of the robot's reach"_text,
        "use flat layers, which need no tilt of the nozzle, turn the part, or use a larger robot"_text,
        {.reportId = "unreachable", .remedies = kForOutOfReach}),
    error(
        Unreachable, "unreachable",
        "{place}: out of the robot's reach, or beyond a joint limit, at every rotation tried about the nozzle"_text,
        "scale the part down (`--scale fit`), turn it, or use a larger robot"_text,
        {.remedies = kForOutOfReach, .more = kMoreWaypoints}),
    error(
        Unconnected, "unconnected",
        "{place}: reachable, but the robot cannot move from or to a neighbouring point without lifting"_text,
        "turn the part about the vertical, or try more rotations (`redundancySamples`)"_text,
        {.remedies = kOffers<MoreTurns, Shrink, PrintFlat>, .more = kMoreWaypoints}),
    error(StaysUpright, "staysUpright",
          "this arm keeps the nozzle upright, but the layers need it tilted, first at {place}"_text,
          "use mode flat, or planar with upright layers"_text,
          {.remedies = kOffers<PrintFlat, UsualCell>}),
    error(
        BeyondRod, "beyondRod",
        "{place}: too far from the rod: the cell prints up to {radius} from its axis and {along} from its middle"_text,
        "scale the part down, or move it along the rod"_text,
        {.remedies = kForRod, .more = kMoreWaypoints}),
    error(HeadInPart, "headInPart", "{place}: the print head would cut into printed material"_text,
          "use a slimmer print head or thinner layers"_text,
          {.reportId = "collision",
           .remedies = kOffers<LowerLayers, FinerProcess, PrintFlat, ChooseStrategy>,
           .more = kMoreWaypoints}),
    error(HeadInPlatform, "headInPlatform",
          "{place}: the print head would cut into the platform"_text,
          "use a smaller platform or place the part higher"_text,
          {.reportId = "collision",
           .remedies = kOffers<ShrinkPlatform, FinerProcess, PrintFlat, PrintOnPlate>,
           .more = kMoreWaypoints}),
    error(
        Collision, "collision",
        "{place}: {first} would collide with {second} at every rotation tried about the nozzle"_text,
        "turn the part, use a smaller platform, or allow less clearance"_text,
        {.remedies = kForCollision, .more = kMoreWaypoints}),
    error(MeetsOnCloserLook, "meetsOnCloserLook",
          "{place}: skipped, because of a collision on the way to it"_text, kRotateOrClearance,
          {.reportId = "collision", .remedies = kForCollision, .more = kMoreWaypoints}),
    error(CollisionInMotion, "collisionInMotion",
          "{first} collides with {second} in the finished motion"_text, kRotateOrClearance,
          {.reportId = "collision", .remedies = kForCollision, .concern = Concern::Safety}),
    error(
        HomeMeets, "homeMeets",
        "{first} collides with {second} in the home pose: no motion is possible"_text,
        "choose another home pose for the cell; if only the enclosing shapes of two links overlap, list the pair under neverMeet in the robot's file"_text,
        {.reportId = "collision",
         .remedies = kForHome,
         .whyNoRemedy = kCellFile,
         .concern = Concern::Safety}),
    error(
        NoPathTo, "noWayTo",
        "{place}: no collision-free transfer to {pieces} piece of a path|{place}: no collision-free transfer to {pieces} pieces of paths"_plural,
        kRotateOrClearance, {.reportId = "transfer", .remedies = kForCollision}),
    error(NoPathBack, "noWayBack",
          "{place}: no collision-free transfer from home to the place where the print resumes"_text,
          "choose an earlier or a later bead"_text,
          {.reportId = "transfer",
           .whyNoRemedy = "choose the bead to resume from on the Simulate page"_text}),
    error(
        NoPathFrom, "noWayFrom",
        "{place}: no collision-free transfer away from the end of {pieces} piece of a path|{place}: no collision-free transfer away from the ends of {pieces} pieces of paths"_plural,
        kRotateOrClearance, {.reportId = "transfer", .remedies = kForCollision}),
    info(
        LeftOut, "leftOut",
        "{waypoints} waypoint ({share:.2g} of the material) is skipped; see the findings above|{waypoints} waypoints ({share:.2g} of the material) are skipped; see the findings above"_plural,
        "check these places in the view; turn the part if they matter"_text),
    info(
        JerkOverLimit, "jerkOverLimit",
        "jerk of joint {joint} at its greatest here: {jerk:.3g} rad/s³, limit {limit:.3g} rad/s³"_text,
        "smooth whole paths (`rotationSmoothing=wholePath`), print slower, or allow more jerk (`maxJerk`)"_text),
    info(
        LongShot, "longShot",
        "{shots} shot into a pocket lasts up to {seconds:.1f}: after {most:.0f} in the pocket the nozzle melts the layers around it|{shots} shots into pockets last up to {seconds:.1f}: after {most:.0f} in a pocket the nozzle melts the layers around it"_plural,
        "use a process with a greater flow, or smaller pockets (`stitchDiameter`)"_text),
    error(
        WaitsAbovePart, "waitsAbovePart",
        "{waits} pause or wait above the part: the arm reaches no place beside it, nothing is primed, and material may drip on the part|{waits} pauses and waits above the part: the arm reaches no place beside it, nothing is primed, and material may drip on the part"_plural,
        "give the cell a place for purges or a home pose beside the plate, or move the part on the plate"_text,
        {.remedies = kForHome, .whyNoRemedy = kCellFile}),
    error(GivenUnreachable, "givenUnreachable", kSameReason, kMovePart,
          {.reportId = "unreachable",
           .remedies = kOffers<CentrePart, LargerCell, MoreTurns>,
           .whyNoRemedy = kSlicersPaths}),
    error(
        GivenStaysUpright, "givenStaysUpright", kSameReason,
        "use a cell whose arm can tilt the nozzle, or print the paths on the plate"_text,
        {.reportId = "staysUpright", .remedies = kOffers<UsualCell>, .whyNoRemedy = kSlicersPaths}),
    error(GivenCollision, "givenCollision", kSameReason, kMoveOrClearance,
          {.reportId = "collision", .remedies = kForGivenCollision, .whyNoRemedy = kSlicersPaths}),
    error(GivenCollisionInMotion, "givenCollisionInMotion", kSameReason, kMoveOrClearance,
          {.reportId = "collision",
           .remedies = kForGivenCollision,
           .whyNoRemedy = kSlicersPaths,
           .concern = Concern::Safety}),
    error(GivenTransfer, "givenTransfer", kSameReason, kMoveOrClearance,
          {.reportId = "transfer", .remedies = kForGivenCollision, .whyNoRemedy = kSlicersPaths}),
    info(GivenLeftOut, "givenLeftOut", kSameReason,
         "check these places in the view; move the part on the plate if they matter"_text,
         {.reportId = "leftOut"}),
};

} // namespace voluta::plan::finding_rows
