// All kinds of findings: one table row per kind.
#pragma once

#include "base/text.h"
#include "plan/finding.h"
#include "plan/remedy_id.h"
#include "plan/stage.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voluta::plan {

enum class FindingKind : std::uint8_t {
  // Has fixed sentences instead of values: findings of projects saved before findings had values.
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
  SurfaceAsWall,
  TinyPart,
  HugePart,
  ThinPart,
  ThinPartInReach,
  LiesBadly,
  TurnedMinRiskyArea,
  TurnedFewestMissed,
  TurnedMinResidualArea,
  TurnedMinAfterCuts,
  TurnedAfterCuts,
  TurnedLeastTension,
  NotTurned,
  CellCannotPrint,
  LargerThanPlates,
  PartsOverlap,
  PartsBlock,
  GivenAmountDiffers,
  GivenOddSize,
  GivenThinPart,
  GivenTooLarge,
  // decompose
  PlatformAdrift,
  ShadowedUnderFacet,
  ShadowedUnreached,
  Unreached,
  MissedGroups,
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
  NotPrinted,
  UnheldOverhang,
  WalledSupport,
  PlaneMisses,
  HeightBeyondLimits,
  PartsHinder,
  RegionOutside,
  RegionWithoutEffect,
  Staircase,
  // toolpath
  GivenWithoutSection,
  GivenTooFast,
  GivenOutsideLimits,
  PatchWithoutBead,
  ThinWallsWidened,
  ThinWallsLeftOut,
  HollowSkin,
  SparseShare,
  SpiralEnds,
  SpiralInterrupted,
  RimSupports,
  PrimeFalls,
  BrimCut,
  Braced,
  Gouge,
  Overload,
  NoTape,
  TapesLeftOut,
  TapesBare,
  InsertMisplaced,
  SettingWithoutEffect,
  LoadFiguresUnknown,
  // motion
  NothingToPrint,
  TooLarge,
  MuchOutOfReach,
  Unreachable,
  Unconnected,
  StaysUpright,
  BeyondRod,
  HeadInPart,
  HeadInPlatform,
  Collision,
  MeetsOnCloserLook,
  CollisionInMotion,
  HomeMeets,
  NoPathTo,
  NoPathBack,
  NoPathFrom,
  LeftOut,
  JerkOverLimit,
  LongShot,
  WaitsAbovePart,
  GivenUnreachable,
  GivenStaysUpright,
  GivenCollision,
  GivenCollisionInMotion,
  GivenTransfer,
  GivenLeftOut,
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
  StandsDuringPrint,
  PrimeChanged,
  PurgeOnPart,
  PurgeOnPlate,
  FirstMotionFast,
  AccelerationChanged,
  LoadChanged,
  NozzleElsewhere,
  StatementMissing,
  StatementChanged,
  OwnStatement,
  FanChanged,
  OutputPasses,
  PostureChanged,
  FlowErrors,
  Uncovered,
  Thin,
  Overfill,
  Mass,
  Unsupported,
  LongBridge,
  CoolingTime,
  BondTime,
  ReplayedCollision,
  OutOfReach,
  JointRange,
  JointSpeed,
  SlideSpeed,
  BranchJump,
  BlendOverlap,
  Flow,
  PathDeviation,
  ProgramRefused,
  ForeignRefused,
  GivenUncovered,
  GivenThin,
  GivenOverfill,
  GivenMass,
  GivenUnsupported,
  GivenLongBridge,
  GivenReplayedCollision,
  GivenLimit,
  FormatRefused,
  WithoutForce,
  // of a station: order of work, common run
  PlatesOverlap,
  MachinesOverlap,
  MachinesStartClose,
  MachineMeetsBody,
  MachinesHinder,
  NoWorkOrder,
  MarkPassedEarly,
  MarkNotReached,
  MachinesMeet,
  MachineRefused,
  MachineDiffers,
  // of milled parts
  OtherMotion,
  RapidInBlock,
  SpindleChanged,
  FeedChanged,
  CutterBelowBlock,
  BlockTurnedBelow,
  BlockTurnedElsewhere,
  OtherSide,
  PartCut,
  MaterialLeft,
  // of what is asked for at places of a part
  OverhangBlocked,
  PlanesWithoutSupports,
  StatementBeforeRest,
};

enum class Severity {
  Error,
  Info,    // Informational, never blocks
  ByAmount // The stage that reports it decides, by the amount
};

// What a finding that blocks puts at risk: a program beside it is not safe to run, or it is safe
// and prints the part otherwise than asked. ByStage: as most findings of its stage.
enum class Concern : std::uint8_t { ByStage, Part, Safety };

struct FindingRow {
  FindingKind kind;
  std::string_view id;       // Unique, camelCase; used in project files
  std::string_view reportId; // `kind` in report.json; several kinds may share one
  Stage stage;
  Severity severity;
  base::Text reason, remedy; // Their placeholders use the same values
  std::span<const RemedyId> remedies = {};
  // Why no remedy button is shown: the program cannot carry out any remedy. Every kind that can
  // block has this text or remedies that are offered in every mode
  // (tests/pipeline/remedies_test.cpp).
  base::Text whyNoRemedy = {};
  // Reason of a finding that also stands for further ones (Finding::more); empty: none does.
  // {count} is Finding::count, {what} the reason above.
  base::Text more = {};
  Concern concern = Concern::ByStage; // in findingRows(): never ByStage
};

std::span<const FindingRow> findingRows();
const FindingRow& rowOf(FindingKind kind);
// Returns the names of the values that a finding of this kind has.
std::vector<std::string_view> valueNames(const FindingRow& row, bool more);
// Also accepts the ids of older versions. Returns nullptr if no kind has this id.
const FindingRow* rowWithId(std::string_view id);
// Returns whether the id is of a kind of older versions that is now its row's kind with
// Finding::more.
bool isIdOfMore(std::string_view id);

// Returns whether a finding blocks because a program beside it is not safe to run.
bool blocksRunning(const Finding& finding);

// Placeholders of FindingRow::more that are no values.
inline constexpr std::string_view kCount = "count", kReason = "what";

// Return the stage and the kind as written to report.json. Findings of kind Verbatim and Stopped
// carry their own.
Stage stageOf(const Finding& finding);
std::string reportId(const Finding& finding);

// Names of the values of kind Verbatim; Stopped has kVerbatimStage too.
inline constexpr std::string_view kVerbatimStage = "stage", kVerbatimKind = "kind",
                                  kVerbatimReason = "reason", kVerbatimRemedy = "remedy";
Finding verbatimFinding(Stage stage, std::string kind, std::string reason, std::string remedy);
// Returns the finding for a run that ended in an error in this stage.
Finding stoppedFinding(Stage stage, base::Message what);

} // namespace voluta::plan
