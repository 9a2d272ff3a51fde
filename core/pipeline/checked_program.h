// A program as the Replay stage leaves it: read back, run and judged.
#pragma once

#include "pipeline/slow_spans.h"
#include "plan/finding.h"
#include "plan/program.h"
#include "project/job_stage.h"
#include "project/report.h"
#include "replay/worst_places.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::plan {
struct Trajectory;
}

namespace voluta::pipeline {

// A place in a program's text. `line` is 1-based; 0: no particular line.
struct TextLine {
  std::uint32_t file = 0, line = 0;
};

// One program, read back and replayed. The Replay stage has one of these per format.
struct CheckedProgram {
  static constexpr project::Stage kStage = project::Stage::Replay;
  plan::Program program; // its files are named as if it were safe to run
  project::ReplayReport verdict;
  plan::Findings findings;                     // of this format only
  std::vector<TextLine> findingLines;          // the line of each finding
  bool safeToRun = false;                      // as replay::Verification::safeToRun
  std::vector<base::Message> failed;           // the exceeded thresholds
  std::vector<std::size_t> collidingWaypoints; // as Verification::collidingWaypoints
  double maxDeviationMm = 0.0, maxDeviationRad = 0.0;
  std::vector<SlowSpan> slow;       // spans in which its controller is slow
  std::vector<TextLine> pointLines; // the line of each point of the trajectory; line 0: none
  project::Timings timings;
  replay::WorstPlaces worst;
  std::size_t deviations = 0; // places where the text differs from the plan
  bool armChecked = false;    // as replay::Verification::armChecked
  // Why there is no text, and what helps; empty if there is one.
  std::optional<base::Message> refusal, refusalHelp;
};

// Returns the line of each point of the trajectory that `program` was written from. A point whose
// motion is missing from the text has line 0.
std::vector<TextLine> linesOfPoints(const CheckedProgram& program,
                                    const plan::Trajectory& trajectory);

} // namespace voluta::pipeline
