// Plans the same part in several ways (cells x modes x growth schemes x platforms) and compares the
// results.
#pragma once

#include "base/error.h"
#include "base/run_context.h"
#include "pipeline/road.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voluta::pipeline {

// One way of building.
struct Combination {
  std::string mode;
  std::optional<curved::GrowthScheme> growth; // nullopt: the mode has no growth scheme
  project::Platform platform;
  std::string cell = {}; // empty: that of the choices

  friend bool operator==(const Combination&, const Combination&) = default;
};

// An empty list stands for the value of the choices; an empty `modes` for all modes.
struct CompareOptions {
  PlanRequest plan;
  std::vector<std::string> modes;
  std::vector<curved::GrowthScheme> growths;
  std::vector<project::Platform> platforms;
  std::vector<std::string> cells = {}; // ids
};

// Returns the combinations in planning order: by cell, mode, platform, growth; without duplicates. Growth
// schemes and platforms vary only in modes whose decomposition depends on them; a mode without
// platforms gets the first one. Throws Error{Usage} for an unknown choice.
std::vector<Combination> combinations(const CompareOptions& options);

project::Choices choicesOf(const Combination& combination, project::Choices choices);

enum class RowState {
  Clear,   // Planned, without blocking findings
  Blocked, // Planned, but part of it cannot be printed, reached or verified
  Failed   // Cannot be planned
};

struct CompareRow {
  Combination combination;
  base::Message error;                   // Why it could not be planned; empty if it was planned
  base::ErrorCode errorCode{};           // Code of `error`
  std::optional<project::Stage> reached; // The last completed stage
  project::Report report;                // Report of the completed stages
  double seconds = 0.0;                  // Run time; stages taken from the cache take none

  RowState state() const;
  // Returns the number of blocking findings.
  std::size_t blocking() const;
  // Returns the first blocking finding with its stage, or the error; empty if the row is clear.
  base::Message reason() const;
};

struct Comparison {
  std::string part;         // File name without folder
  project::Choices choices; // Cell, mode, growth and platform differ per row
  project::Stage until = project::Stage::Replay;
  std::vector<CompareRow> rows;
  double seconds = 0.0;
  int threads = 1;
};

// Callbacks; run on the thread that calls compare().
struct CompareWatch {
  // Called once, before the first combination is planned.
  std::function<void(const std::vector<Combination>&)> planned;
  std::function<void(std::size_t row)> begins;
  // `result` is nullptr if planning failed. compare() releases it afterwards.
  std::function<void(std::size_t row, const CompareRow&, std::shared_ptr<PlanResult> result)> ended;
};

// Plans the combinations one after the other. Loads, places and voxelizes the part only once. A
// combination that cannot be planned becomes a row with its reason. Throws Error{Usage,
// UnreadableFile, UnusableInput} if the choices or the part itself are invalid, and Cancelled.
Comparison compare(const CompareOptions& options, const base::RunContext& ctx,
                   const CompareWatch& watch = {});

} // namespace voluta::pipeline
