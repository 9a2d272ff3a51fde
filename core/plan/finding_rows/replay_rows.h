// Findings of stage replay.
#pragma once

#include "plan/finding_rows/row.h"

namespace voluta::plan::finding_rows {

inline constexpr base::Text kVerifyItsJob = "verify it against the job it was written from"_text;
inline constexpr base::Text kNozzleOff = "nozzle {distance:.3f} off the planned path"_text;
inline constexpr base::Text kUncoveredShare =
    "{share:.2f} of the part is not covered by beads, mostly around this point"_text;
inline constexpr base::Text kThinShare =
    "{share:.2f} of the part ({volume:.3g}) is narrower than the narrowest bead ({bead:.3g}) and stays open, mostly around this point|{share:.2f} of the part ({volume:.3g}) is narrower than the narrowest bead ({bead:.3g}) and stays open, at {places} places, mostly around this point"_plural;
inline constexpr base::Text kOverfillShares =
    "{outside:.2f} of the part's volume is deposited outside it, {noRoom:.2f} does not fit"_text;
inline constexpr base::Text kDepositedShare = "deposited volume: {share:.2f} of the part's"_text;
inline constexpr base::Text kUnsupportedLength =
    "{length:.1f} of bead ({share:.2f}) is unsupported"_text;
inline constexpr base::Text kSupportBeads =
    "add supports, make sparse infill denser, rotate the part, or choose mode auto"_text;
inline constexpr base::Text kBridgeLength =
    "{length:.1f} of a bead is unsupported; this material bridges {bridge:.1f}"_text;
inline constexpr std::span<const RemedyId> kForFill =
    kOffers<LowerLayers, FinerProcess, ChooseStrategy, AcceptShare>;
inline constexpr std::span<const RemedyId> kForLimits =
    kOffers<MoreTurns, Shrink, CentrePart, PrintFlat>;
inline constexpr base::Text kSliceSupports =
    "slice the part again with supports there, or with denser infill; its tool-paths are printed as they are"_text;
inline constexpr base::Text kSlower =
    "print slower there, or place the part elsewhere in the cell"_text;
inline constexpr base::Text kMoreViolations =
    "{count} more violation|{count} more violations"_plural;

// The robot or the controller cannot do a motion as the program states it.
constexpr FindingRow exceeded(FindingKind kind, std::string_view id, base::Text reason,
                              std::span<const RemedyId> remedies = kForLimits) {
  return error(kind, id, reason, kSlower,
               {.reportId = "limit", .remedies = remedies, .more = kMoreViolations});
}

// Of tool-paths that are printed as they are.
constexpr OtherFields forGiven(std::string_view reportId) {
  return {.reportId = reportId,
          .remedies = kOffers<AcceptShare>,
          .whyNoRemedy = kSlicersPaths,
          .concern = Concern::Part};
}

inline constexpr FindingRow kReplayRows[] = {
    mismatch(UnreadableLine, "unreadableLine", "{defect}"_text),
    mismatch(EndMissing, "endMissing", "the end sequence is missing"_text),
    mismatch(NoMotions, "noMotions", "the program has no motions"_text,
             {.reportId = "programCutShort"}),
    mismatch(
        ProgramCutShort, "programCutShort",
        "the program ends here; {motions} planned motion is missing|the program ends here; {motions} planned motions are missing"_plural),
    byAmount(OtherJob, "otherJob",
             "the program is from another job: {program}; this job is {job}"_text, kVerifyItsJob,
             {.whyNoRemedy = kOnlyWriteAgain}),
    byAmount(OtherCell, "otherCell",
             "the program is for another cell: {program}; this job is {job}"_text, kVerifyItsJob,
             {.reportId = "otherJob", .whyNoRemedy = kOnlyWriteAgain}),
    error(OtherProgram, "otherProgram", "the program's motions do not match this plan"_text,
          kVerifyItsJob, {.whyNoRemedy = kOnlyWriteAgain}),
    mismatch(WaypointMoved, "waypointMoved", kNozzleOff),
    mismatch(WaypointTilted, "waypointTilted",
             "nozzle axis {angle:.2f} off the planned direction"_text,
             {.reportId = "waypointMoved"}),
    mismatch(
        WaypointsMissingBefore, "waypointsMissingBefore",
        "{motions} planned motion is missing before this one|{motions} planned motions are missing before this one"_plural,
        {.reportId = "waypointsMissing"}),
    mismatch(
        WaypointsMissingBetween, "waypointsMissingBetween",
        "{motions} planned motion is missing between {before} and this one|{motions} planned motions are missing between {before} and this one"_plural,
        {.reportId = "waypointsMissing"}),
    mismatch(
        MotionsUnplanned, "motionsUnplanned",
        "{motions} motion from here on is not in the plan|{motions} motions from here on are not in the plan"_plural),
    mismatch(WaypointsSwapped, "waypointsSwapped",
             "this motion and the one at {other} are swapped"_text),
    mismatch(OtherConfiguration, "otherConfiguration",
             "the arm's configuration is not the planned one: a joint differs by {angle:.1f}"_text),
    mismatch(ExternalAxisMoved, "externalAxisMoved",
             "external axis {angle:.3f} off its planned position"_text),
    mismatch(ExtruderOnTravel, "extruderOnTravel", "the extruder is on during a travel"_text),
    mismatch(ExtruderOffPrint, "extruderOffPrint", "the extruder is off during a bead"_text),
    mismatch(SpeedChanged, "speedChanged",
             "this motion takes {time:.3f} instead of {planned:.3f}"_text),
    mismatch(FlowChanged, "flowChanged",
             "this motion deposits {volume:.3f} instead of {planned:.3f}"_text),
    mismatch(BeadByJoints, "beadByJoints",
             "a bead is printed by a joint motion instead of a straight one"_text),
    mismatch(FlowsWhileStanding, "flowsWhileStanding",
             "{volume:.3f} is extruded here while the nozzle does not move for {time:.3f}"_text),
    mismatch(StandsDuringPrint, "standsAmidPrint",
             "the robot dwells here for {time:.2f} with the hot nozzle touching the part"_text),
    mismatch(PrimeChanged, "primeChanged",
             "{volume:.3f} is extruded before the first bead instead of {planned:.3f}"_text),
    error(PurgeOnPart, "purgeOnPart", "a prime or a purge of {volume:.0f} falls on the {body}"_text,
          "state a place for purges in the cell (purgeMm), or move the part"_text,
          {.reportId = "purge", .remedies = kForHome, .whyNoRemedy = kCellFile}),
    info(
        PurgeOnPlate, "purgeOnPlate",
        "a prime or a purge of {volume:.0f} falls on the plate, beside the print"_text,
        "remove the strand before it is dragged along, or state a place for purges in the cell (purgeMm)"_text,
        {.reportId = "purge"}),
    mismatch(FirstMotionFast, "firstMotionFast",
             "the first motion is too fast: it begins at an unknown pose of the arm"_text),
    mismatch(AccelerationChanged, "accelerationChanged",
             "commanded acceleration is {times:.1f} times the planned one"_text),
    mismatch(LoadChanged, "loadChanged",
             "stated payload {mass:.2f} kg, planned about {planned:.2f} kg"_text),
    mismatch(NozzleElsewhere, "nozzleElsewhere",
             "the program's nozzle is {distance:.2f} and {angle:.2f} off the cell's nozzle"_text),
    mismatch(StatementMissing, "statementMissing", "missing before this line: {statement}"_text),
    mismatch(StatementChanged, "statementChanged",
             "{statement}: {found} in the program, {planned} planned"_text),
    error(
        OwnStatement, "ownStatement", "your own statement, which nothing checks: {statement}"_text,
        "check what it does on the controller; leave it out of `layerEvents` if you do not need it"_text,
        {.whyNoRemedy = "nobody but you knows what the statement is for"_text,
           .concern = Concern::Part}),
    info(FanChanged, "fanChanged",
         "part cooling {found} % from this line on, {planned} % planned"_text, kWriteAgain,
         {.whyNoRemedy = kOnlyWriteAgain}),
    error(
        OutputPasses, "outputPasses",
        "an extruder output is set while the arm is moving: it switches at the wrong place, or stops the arm on the bead"_text,
        "set it by a trigger of the next motion, or write the program again"_text,
        {.whyNoRemedy = kOnlyWriteAgain}),
    mismatch(PostureChanged, "postureChanged",
             "the arm's posture at this target: {found} in the program, {planned} planned"_text),
    error(
        FlowErrors, "flowErrors",
        "at the controller's speeds, {share:.2f} of the bead length gets over 5 % too much or too little material"_text,
        "write the program again, with times instead of speeds where the format supports them"_text,
        {.remedies = kOffers<LongerMotions>}),
    error(Uncovered, "uncovered", kUncoveredShare,
          "use lower layers or a finer nozzle, or print the part larger"_text,
          {.remedies = kOffers<AdaptLayers, LowerLayers, FinerProcess, ChooseStrategy, AcceptShare>,
           .concern = Concern::Part}),
    error(Thin, "thin", kThinShare, "use a finer nozzle, or print the part larger"_text,
          {.remedies = kOffers<FinerProcess, Enlarge, ChooseStrategy, AcceptShare>,
           .concern = Concern::Part}),
    error(Overfill, "overfill", kOverfillShares,
          "reduce the flow, or space the beads further apart"_text,
          {.remedies = kForFill, .concern = Concern::Part}),
    error(Mass, "mass", kDepositedShare, "check the flow and the infill density"_text,
          {.remedies = kForFill, .concern = Concern::Part}),
    error(Unsupported, "unsupported", kUnsupportedLength, kSupportBeads,
          {.remedies = kOffers<AddSupports, RotateToMinRiskyArea, PrintFlat, ChooseStrategy,
                               PrintOnPlate, AcceptShare>,
           .concern = Concern::Part}),
    info(LongBridge, "longBridge", kBridgeLength, kSupportBeads,
         {.remedies = kOffers<ChooseStrategy>, .concern = Concern::Part}),
    error(
        CoolingTime, "coolingTime",
        "the bead below is covered after {time:.1f}, before the minimum layer time of {limit:.1f}; on {length:.0f} of beads in all"_text,
        "lower the minimum layer time, print slower, or print without a spiral"_text,
        {.whyNoRemedy =
             "only you know how long a bead has to cool: change the minimum layer time"_text,
         .concern = Concern::Part}),
    info(
        BondTime, "bondTime",
        "the bead below is {time:.1f} old when it is covered, beyond the maximum layer time of {limit:.1f}; so are {length:.0f} of beads"_text,
        "print faster, or fewer parts at a time"_text),
    error(ReplayedCollision, "replayedCollision", "{first} and {second} collide"_text,
          "plan again with more clearance, or place the part elsewhere"_text,
          {.reportId = "collision",
           .remedies = kOffers<MoreClearance, Shrink, CentrePart>,
           .more = "{count} more collision|{count} more collisions"_plural}),
    exceeded(OutOfReach, "outOfReach", "the arm cannot reach this target"_text),
    exceeded(JointRange, "jointRange",
             "{joint} at {angle:.1f}, beyond its limit of {limit:.1f#}"_text),
    exceeded(JointSpeed, "jointSpeed",
             "{joint} at {speed:.1f}, above its limit of {limit:.1f#}"_text),
    exceeded(SlideSpeed, "slideSpeed",
             "{joint} at {speed:.1f}/s, above its limit of {limit:.1f#}"_text),
    exceeded(
        BranchJump, "branchJump",
        "the arm would have to change its configuration: {joint} would jump by {angle:.1f}"_text),
    exceeded(
        BlendOverlap, "blendOverlap",
        "two blends overlap, {blend:.3f} in all on a motion of {way:.3f}: the controller skips the waypoint"_text,
        kOffers<LongerMotions>),
    exceeded(Flow, "flow", "flow of {flow:.1f}, above the extruder's limit of {limit:.1f#}"_text,
             kOffers<LowerLayers, FinerProcess>),
    error(PathDeviation, "pathDeviation", kNozzleOff, "use shorter motions or smaller blends"_text,
          {.reportId = "deviation", .remedies = kOffers<ShorterMotions>}),
    error(ProgramRefused, "programRefused", "the {format} program is not released: {failed}"_text,
          "see the findings before this one"_text, {.whyNoRemedy = kOthersHelp}),
    info(ForeignRefused, "foreignRefused",
         "the {format} program, for another controller, is not released: {failed}"_text,
         "use the program for the cell's own controller"_text, {.reportId = "programRefused"}),
    error(
        GivenUncovered, "givenUncovered", kUncoveredShare,
        "check the widths and layer heights in the slicer against the bead of the process; the tool-paths are printed as they are"_text,
        forGiven("uncovered")),
    error(
        GivenThin, "givenThin", kThinShare,
        "choose the process that the file was sliced for; the tool-paths are printed as they are"_text,
        forGiven("thin")),
    error(
        GivenOverfill, "givenOverfill", kOverfillShares,
        "check the flow in the slicer, and purge or prime lines that it does not mark; the tool-paths are printed as they are"_text,
        forGiven("overfill")),
    error(
        GivenMass, "givenMass", kDepositedShare,
        "check the slicer's flow, its filament diameter and its amounts at tool changes; the tool-paths are printed as they are"_text,
        forGiven("mass")),
    error(GivenUnsupported, "givenUnsupported", kUnsupportedLength, kSliceSupports,
          forGiven("unsupported")),
    info(GivenLongBridge, "givenLongBridge", kBridgeLength, kSliceSupports,
         {.reportId = "longBridge", .whyNoRemedy = kSlicersPaths, .concern = Concern::Part}),
    error(GivenReplayedCollision, "givenReplayedCollision", kSameReason,
          "plan again with more clearance, or move the part on the plate"_text,
          {.reportId = "collision",
           .remedies = kOffers<MoreClearance, CentrePart>,
           .whyNoRemedy = kSlicersPaths}),
    error(GivenLimit, "givenLimit", kSameReason,
          "move the part on the plate, or slice it again for a lower speed there"_text,
          {.reportId = "limit",
           .remedies = kOffers<MoreTurns, CentrePart>,
           .whyNoRemedy = kSlicersPaths}),
    error(FormatRefused, "formatRefused", "no {format} program: {why}"_text, "{help}"_text,
          {.reportId = "programRefused", .whyNoRemedy = "choose another program format"_text}),
    info(
        WithoutForce, "withoutForce",
        "the {format} program lays beads by position, without the force of process {process}"_text,
        "to press with the force, use {formats}, or add the statements to the process (beadWords)"_text),
};

} // namespace voluta::plan::finding_rows
