// Two jobs whose machines work in one cell: order of work, marks, programs and their common replay.
#pragma once

#include "base/run_context.h"
#include "pipeline/plan_result.h"
#include "replay/two_machines.h"
#include "together/together.h"

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct TogetherRequest {
  std::array<project::Job, 2> jobs; // each planned alone, up to its motion (jobToJoin)
  // The world of the second job's cell in that of the first, which is the shared frame.
  Eigen::Isometry3d first_T_second = Eigen::Isometry3d::Identity();
  together::Options options;
};

struct TogetherResult {
  std::array<PlanResult, 2> plans; // with marks in their motions, and the programs with them
  std::array<Eigen::Isometry3d, 2> shared_T_world;
  together::Plan work;
  std::optional<base::Message> obstruction; // why there is no order of work; then no programs
  // Of the first programs of both; nullopt if one of them was refused or does not state the arm.
  std::optional<replay::TwoMachines> replay;
};

// Returns "X,Y,Z,TURN" as a pose: a translation [mm] and then a rotation about z, given in degrees.
// Throws Error{Usage}.
Eigen::Isometry3d parsedMachinePlace(const std::string& text);

// Reads a job for a request. Throws Error{UnreadableFile}; Error{UnusableInput} if it has no motion
// or is the rest of a print.
project::Job jobToJoin(const std::filesystem::path& file);

// Looks for an order of work in which the machines do not meet, whatever their speeds, writes the
// programs with its marks and replays both in one time. Marks that the jobs have are dropped.
// Formats without words for marks are left out unless the user chose them. Precondition: the jobs
// have motions. Throws Error{Usage} for a chosen format without words for marks; Cancelled.
TogetherResult planTogether(TogetherRequest request, const base::RunContext& ctx);

// Returns whether the machines can work together and all programs passed.
bool passed(const TogetherResult& result);

// Writes the outputs of both jobs into the folders "first" and "second", and together.json. Throws
// Error{CannotWrite}.
void writeTogether(TogetherResult& result, const std::filesystem::path& folder,
                   const base::RunContext& ctx);
std::string togetherJson(const TogetherResult& result);

} // namespace voluta::pipeline
