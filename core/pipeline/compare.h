// The same part in the same cell, built in several ways: modes x growth schemes x platforms.
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
  std::optional<curved::GrowthScheme> growth; // none: means nothing to the mode
  project::Platform platform;

  friend bool operator==(const Combination&, const Combination&) = default;
};

// A list that is empty stands for what the choices name; `modes` for all modes.
struct CompareOptions {
  PlanRequest plan;
  std::vector<std::string> modes;
  std::vector<curved::GrowthScheme> growths;
  std::vector<project::Platform> platforms;
};

// In the order they are planned: by mode, platform, growth; none twice. Growth schemes and
// platforms vary only the modes whose decomposition asks for them; a mode without platforms has the
// first. Throws Error{Usage}: any choice that nothing answers to.
std::vector<Combination> combinations(const CompareOptions& options);

project::Choices choicesOf(const Combination& combination, project::Choices choices);

enum class RowState {
  Clear,   // planned, and nothing blocks
  Blocked, // planned, but something cannot be printed, reached or verified
  Failed   // cannot be planned
};

struct CompareRow {
  Combination combination;
  base::Message error;                   // why it could not be planned; empty: it was
  base::ErrorCode errorCode{};           // of `error`
  std::optional<project::Stage> reached; // the last stage that was done
  project::Report report;                // of what was planned
  double seconds = 0.0;                  // that it took here: kept stages are not made again

  RowState state() const;
  // Findings that block.
  std::size_t blocking() const;
  // The first of them with its stage, or the error; empty: it is clear.
  base::Message reason() const;
};

struct Comparison {
  std::string part;         // file name without folder
  project::Choices choices; // mode, growth and platform are each row's own
  project::Stage until = project::Stage::Replay;
  std::vector<CompareRow> rows;
  double seconds = 0.0;
  int threads = 1;
};

// Called on the running thread.
struct CompareWatch {
  // Once, before the first is planned.
  std::function<void(const std::vector<Combination>&)> planned;
  std::function<void(std::size_t row)> begins;
  // `result`: null where it could not be planned. Dropped by compare() afterwards.
  std::function<void(std::size_t row, const CompareRow&, std::shared_ptr<PlanResult> result)> ended;
};

// Plans the combinations one after the other. The part is loaded, placed and cut into voxels once.
// What cannot be planned is a row with its reason. Throws Error{Usage, UnreadableFile,
// UnusableInput} where the choices or the part itself will not do, and Cancelled.
Comparison compare(const CompareOptions& options, const base::RunContext& ctx,
                   const CompareWatch& watch = {});

} // namespace voluta::pipeline
