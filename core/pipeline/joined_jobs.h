// Jobs whose machines work in one cell: order of work, marks, programs and their common replay.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "replay/shared_run.h"
#include "together/together.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct JoinedJob {
  project::Job job; // planned alone, up to its motion (jobToJoin)
  // The world of its cell in the frame that all share; usually that of the first one's.
  Eigen::Isometry3d shared_T_world = Eigen::Isometry3d::Identity();
};

struct TogetherRequest {
  std::vector<JoinedJob> machines;
  together::Options options;
};

struct TogetherResult {
  // Per machine; with marks in the motions, and the programs with them.
  std::vector<PlanResult> plans;
  std::vector<Eigen::Isometry3d> shared_T_world;
  together::Plan work;
  std::optional<base::Message> obstruction; // why there is no order of work; then no programs
  std::vector<base::Message> notes;         // plates that overlap, which may be on purpose
  // Of the first program of each; nullopt if one of them was refused or does not state the arm.
  std::optional<replay::SharedRun> replay;
};

// Returns "X,Y,Z,TURN" as a pose: a translation [mm] and then a rotation about z, given in degrees.
// Throws Error{Usage}.
Eigen::Isometry3d parsedMachinePlace(const std::string& text);
// Returns the rotation about z of such a pose [degrees].
double machineTurnDeg(const Eigen::Isometry3d& place);

// Reads a job for a request. Throws Error{UnreadableFile}; Error{UnusableInput} if it has no motion
// or is the rest of a print.
project::Job jobToJoin(const std::filesystem::path& file);
// Throws the same for a job in memory. `name`: of the job in the error.
void requireJoinable(const project::Job& job, const std::string& name);

// Looks for an order of work in which the machines do not meet, whatever their speeds, writes the
// programs with its marks and replays all in one time. Marks that the jobs have are dropped.
// Formats without words for marks are left out unless the user chose them. Preconditions: the jobs
// can be joined. Throws Error{Usage} for a chosen format without words for marks, for less than two
// and more than plan::kMostMachines machines; Cancelled.
TogetherResult planTogether(TogetherRequest request, const base::RunContext& ctx);

// Returns whether the machines can work together and all programs passed.
bool passed(const TogetherResult& result);
// Returns the reason why they cannot; nullopt if passed().
std::optional<base::Message> refusal(const TogetherResult& result);

// Returns the program of a machine that is replayed together with the others: the first that
// passed and states the arm; null if there is none.
const CheckedProgram* replayedTogether(const PlanResult& plan);

// Writes the outputs of each job into a folder of its own (togetherFolder), and together.json.
// Throws Error{CannotWrite}.
void writeTogether(TogetherResult& result, const std::filesystem::path& folder,
                   const base::RunContext& ctx);
// Returns "machine1" for machine 0.
std::string togetherFolder(std::size_t machine);
std::string togetherJson(const TogetherResult& result);

} // namespace voluta::pipeline
