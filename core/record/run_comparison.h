// A recorded run beside the plan: errors of path, speed and flow, and where they are worst.
#pragma once

#include "base/text.h"
#include "record/formats.h"
#include "record/planned_run.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::record {

// Errors up to these are not listed as places.
struct RunTolerances {
  double pathMm = 0.15;
  double speed = 0.01; // shares of the planned value
  double flow = 0.01;
};

enum class ErrorKind : std::uint8_t { Path, Speed, Flow, Missing };
// Returns "path", "speed", "flow" or "missing".
base::Text kindName(ErrorKind kind);

// A stretch of the plan in which an error exceeds its tolerance.
struct ErrorPlace {
  ErrorKind kind = ErrorKind::Path;
  double worst = 0.0; // Path, Missing: mm; Speed, Flow: share of the planned value, with its sign
  double lengthMm = 0.0;             // of the planned path
  double planS = 0.0, recordS = 0.0; // of the worst place, as in the plan and in the record
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // planned, work frame [mm]
  std::size_t point = 0;                           // of the trajectory
};

// The errors along the record, for plots: one entry per sample that belongs to a bead.
struct ErrorCurve {
  std::vector<float> planS, recordS, pathMm, speed, flow; // speed, flow: NaN where not measured
};

enum class RunVerdict : std::uint8_t {
  Within,     // the whole job, within the tolerances
  Beyond,     // places beyond the tolerances
  Incomplete, // less than kCompleteShare of the beads is recorded
  OtherJob    // less than kSameJobShare of the beads is recorded
};
inline constexpr double kCompleteShare = 0.9, kSameJobShare = 0.01;

struct RunComparison {
  // Of the samples on beads
  double pathMeanMm = 0.0, pathMaxMm = 0.0;
  double speedMean = 0.0; // planned time of the beads by recorded time, less 1
  double speedSlowest = 0.0, speedFastest = 0.0; // of windows of kWindowMm
  double flowMean = 0.0, flowLowest = 0.0, flowHighest = 0.0;
  bool flowIsRecorded = false; // else it is the one that the planned flow rate gives at this speed
  double printedMm = 0.0, missingMm = 0.0; // planned length of beads: recorded, and passed over
  double beadsMm = 0.0;                    // planned length of all beads
  double beginS = 0.0, endS = 0.0;         // of the record, where it is beside the plan
  std::vector<ErrorPlace> places;          // by kind, then the worst first
  ErrorCurve curve;

  RunVerdict verdict() const;
};

// Returns the verdict as a sentence with its figures.
base::Message verdictSentence(const RunComparison& comparison);

// Speed and flow are measured over at least these, within one bead.
inline constexpr double kWindowMm = 4.0, kWindowS = 0.2;

// Compares a record with the plan. Path errors are distances of recorded tips from the planned path
// in its order; speed is that along the planned path. Throws Error{UnusableInput} if the record
// does not come near the plan; Cancelled.
RunComparison compareRun(const RecordedRun& record, const PlannedRun& planned,
                         const RunTolerances& tolerances, const base::RunContext& ctx);

// Returns the curve as a table: planS, recordS, pathMm, speed, flow.
std::string curveCsv(const ErrorCurve& curve);

} // namespace voluta::record
