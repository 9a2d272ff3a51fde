// Plans a station: the machines' order of work, marks, programs and their common replay. The stage
// follows the Motion of each machine's job.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "pipeline/plan_verdict.h"
#include "pipeline/stage_cache.h"
#include "plan/finding.h"
#include "project/station.h"
#include "replay/shared_run.h"
#include "together/together.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace voluta::pipeline {

// The order of work of a station, as a value that can be cached.
struct StationStage {
  static constexpr project::Stage kStage = project::Stage::Motion;
  together::Plan work;
  plan::Findings findings; // places in the frame that the machines share
};

struct StationResult {
  project::StationRules rules;
  // Per machine: its name, its plan with marks in the motion and the programs with them, its place.
  std::vector<std::string> names;
  std::vector<PlanResult> plans;
  std::vector<Eigen::Isometry3d> shared_T_world;
  together::Plan work;
  plan::Findings findings; // of the station; places in the frame that the machines share
  // Of the first program of each; nullopt if there is no order of work, or if one of them was
  // refused or does not state the arm.
  std::optional<replay::SharedRun> replay;
};

// Returns "X,Y,Z,ROTATION" as a pose: a translation [mm] and then a rotation about z, given in
// degrees. Throws Error{Usage}.
Eigen::Isometry3d parsedMachinePlace(const std::string& text);
// Returns the rotation about z of such a pose [degrees].
double machineRotationDeg(const Eigen::Isometry3d& place);

// Reads the project of a station, or of a job as a station of one machine. Throws
// Error{UnreadableFile}; Error{UnusableInput} if a job has no motion.
project::Station plannedStation(const std::filesystem::path& file);
// Throws Error{UnusableInput} if a job in memory has no motion. `name`: of the job in the error.
void requireMotion(const project::Job& job, const std::string& name);

// Returns the job without the marks of its motion. Precondition: it has a motion.
project::Job withoutMarks(project::Job job);

// Returns the inputs of a station's order of work as text: the motions, places and rules.
std::string stationKey(const project::Station& station);

// Looks for an order of work in which the machines do not meet, whatever their speeds, writes the
// programs with its marks and replays all in one time. Marks that the jobs have are dropped. A job
// that is the rest of a print is planned from its first point on. Formats without words for marks
// are left out unless the user chose them. `cache`: takes and keeps the order of work; null: none.
// Precondition: each job has a motion. Throws Error{Usage} for a chosen format without words for
// marks, for fewer than two and more than plan::kMaxMachines machines; Cancelled.
StationResult planStation(project::Station station, const base::RunContext& ctx,
                          StageCache* cache = nullptr);

// Returns the result's machines with their jobs as planned.
project::Station stationOf(const StationResult& result);

// Passed, NotAsAsked, Unchecked or Refused: the machines may run unless it is the last one.
PlanVerdict verdictOf(const StationResult& result);
bool passed(const StationResult& result);

// Returns the program of a machine that is replayed together with the others: the first that
// passed and states the arm; null if there is none.
const CheckedProgram* replayedTogether(const PlanResult& plan);

// Writes the project of the station (project::kStationFile), together.json, and the outputs of each
// job into a folder of its own (machineFolder). Throws Error{CannotWrite}.
void writeStationOutputs(StationResult& result, const std::filesystem::path& folder,
                         const base::RunContext& ctx);
// Returns "machine1" for machine 0.
std::string machineFolder(std::size_t machine);
std::string stationJson(const StationResult& result);

} // namespace voluta::pipeline
