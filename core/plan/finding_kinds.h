// Every fact that a plan can tell: one row a kind.
#pragma once

#include "base/text.h"
#include "plan/finding.h"
#include "plan/remedy_id.h"
#include "plan/stage.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace voluta::plan {

enum class FindingKind : std::uint8_t {
  // Told in sentences that are kept as they are: projects of before findings had values.
  Verbatim,
  // A run that ended in an error.
  Stopped,
  // load
  CellsTurned,
  CellsLifted,
  MeshDefect,
  OpenRims,
  SheetModel,
  RimsClosed,
  SheetsLeftOut,
  SurfaceThickened,
  TinyPart,
  HugePart,
  ThinPart,
  ThinPartInReach,
  LiesBadly,
  TurnedLeastRisky,
  TurnedFewestMissed,
  NotTurned,
  CellCannotPrint,
  LargerThanPlates,
  // decompose
  PlatformAdrift,
  ShadowedUnderFacet,
  ShadowedUnderFacetAndMore,
  ShadowedUnreached,
  ShadowedUnreachedAndMore,
  Unreached,
  MoreShadowed,
  MoreUnreached,
  BelowPlate,
  SupportColumn,
  SupportColumnTouching,
  SupportColumns,
  PedestalGains,
  NoSupport,
  ThinWall,
  WallTooThin,
  ThinWalls,
  WallsTooThin,
  OverhangOfPieces,
  OverhangsOfPieces,
  OverhangOfFlat,
  OverhangsOfFlat,
  OverhangOverRod,
  OverhangOverSurface,
  BeyondCell,
  BlockedPieces,
  SmallFoot,
  UniformMisses,
  // layers
  DroppedPieces,
  UnsupportedPatches,
  Slivers,
  BeginsInAir,
  BeginsInAirOverRod,
  BeginsInAirOverSurface,
  NotLaid,
  UnheldOverhang,
  PlaneMisses,
  HeightBeyondLimits,
  // toolpath
  GivenWithoutSection,
  GivenTooFast,
  PatchWithoutBead,
  RimSupports,
  PrimeFalls,
  Braced,
  Gouge,
  // motion
  NothingToPrint,
  TooLarge,
  MuchOutOfReach,
  Unreachable,
  MoreUnreachable,
  Unconnected,
  MoreUnconnected,
  StaysUpright,
  BeyondRod,
  MoreBeyondRod,
  HeadInPart,
  MoreHeadInPart,
  HeadInPlatform,
  MoreHeadInPlatform,
  Collision,
  MoreCollisions,
  MeetsOnCloserLook,
  MoreMeetOnCloserLook,
  CollisionInMotion,
  HomeMeets,
  NoWayTo,
  NoWayBack,
  NoWayFrom,
  LeftOut,
  // replay
  UnreadableLine,
  EndMissing,
  NoMotions,
  ProgramCutShort,
  OtherJob,
  OtherCell,
  OtherProgram,
  WaypointMoved,
  WaypointTilted,
  WaypointsMissingBefore,
  WaypointsMissingBetween,
  MotionsUnplanned,
  WaypointsSwapped,
  OtherConfiguration,
  ExternalAxisMoved,
  ExtruderOnTravel,
  ExtruderOffPrint,
  SpeedChanged,
  FlowChanged,
  BeadByJoints,
  FlowsWhileStanding,
  StandsAmidPrint,
  PrimeChanged,
  FirstMotionFast,
  AccelerationChanged,
  LoadChanged,
  NozzleElsewhere,
  StatementMissing,
  StatementChanged,
  OutputPasses,
  PostureChanged,
  FlowErrors,
  Uncovered,
  Overfill,
  Mass,
  Unsupported,
  LongBridge,
  ReplayedCollision,
  MoreReplayedCollisions,
  OutOfReach,
  JointRange,
  JointSpeed,
  SlideSpeed,
  BranchJump,
  BlendOverlap,
  Flow,
  MoreLimits,
  PathDeviation,
  ProgramRefused,
  ForeignRefused,
};

enum class Severity {
  Error,
  Info,    // worth knowing, never blocks
  ByAmount // the stage that reports it decides by how much it is
};

struct FindingRow {
  FindingKind kind;
  std::string_view id;       // unique, camelCase; in project files
  std::string_view reportId; // `kind` in report.json; several kinds may share one
  Stage stage;
  Severity severity;
  base::Text reason, remedy; // with places for the same values
  std::span<const RemedyId> remedies = {};
  // Why there may be no button: nothing that the program can carry out helps. Every kind that can
  // block has this or cures that are offered in every mode (tests/pipeline/remedies_test.cpp).
  base::Text whyNoRemedy = {};
};

std::span<const FindingRow> findingRows();
const FindingRow& rowOf(FindingKind kind);
// nullptr: none has this id.
const FindingRow* rowWithId(std::string_view id);

// As report.json has them. Of Verbatim and Stopped: what they were made with.
Stage stageOf(const Finding& finding);
std::string reportId(const Finding& finding);

// Values of kind Verbatim; Stopped has the stage too.
inline constexpr std::string_view kVerbatimStage = "stage", kVerbatimKind = "kind",
                                  kVerbatimReason = "reason", kVerbatimRemedy = "remedy";
Finding verbatimFinding(Stage stage, std::string kind, std::string reason, std::string remedy);
// Of a run that ended in an error at that stage.
Finding stoppedFinding(Stage stage, base::Message what);

} // namespace voluta::plan
