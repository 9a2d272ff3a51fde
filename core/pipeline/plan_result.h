// Request and result of a plan, and the observers called while it is made.
#pragma once

#include "base/text.h"
#include "process/tooling.h"
#include "project/job.h"
#include "project/job_stage.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voluta::curved {
struct Decomposition;
}
namespace voluta::modes {
struct LoadStage;
}
namespace voluta::project {
struct LoadedPart;
}
namespace voluta::robot {
class Cell;
}

namespace voluta::pipeline {

struct CheckedProgram;
struct Resolved;

struct RequestedItem {
  std::string part;                                  // path of a mesh, or "sample:NAME"
  std::shared_ptr<const project::LoadedPart> loaded; // used instead of `part` if set
};

struct PlanRequest {
  std::vector<RequestedItem> items = {RequestedItem{}}; // as choices.items
  project::Choices choices;
  project::Stage until = project::Stage::Replay; // last stage to plan

  RequestedItem& item(std::size_t i = 0) { return items.at(i); }
  const RequestedItem& item(std::size_t i = 0) const { return items.at(i); }
};

struct PlannedItem {
  std::shared_ptr<const Resolved> resolved;       // its choices; null before a plan
  std::shared_ptr<const modes::LoadStage> placed; // null before Load is done
};

// Cheap to copy: all large data are shared.
struct PlanResult {
  project::Job job;                                 // choices, results and report
  std::vector<PlannedItem> items = {PlannedItem{}}; // as the job's
  std::shared_ptr<const robot::Cell> cell; // with the job's platform; null before Decompose is done
  // one per format, including refused ones
  std::vector<std::shared_ptr<const CheckedProgram>> checked;
  bool debug = false;       // --set output.debug=true
  bool keepRefused = false; // --set output.refused=true
  bool proofs = false;      // --set output.proof=true
  bool buildFile = false;   // --set output.build3mf=true

  PlannedItem& item(std::size_t i = 0) { return items.at(i); }
  const PlannedItem& item(std::size_t i = 0) const { return items.at(i); }
  // The choices that stages of the whole job take: those of the first item. Precondition: a plan
  // has begun.
  const Resolved& resolved() const { return *items.front().resolved; }
  const process::Tooling& tooling() const;
};

// Returns a result without stages, for items with these choices.
PlanResult emptyResult(const project::Choices& choices);

// Called on the running thread after each stage, computed or cached, with the results so far.
using StageObserver = std::function<void(project::Stage, const PlanResult&)>;

// Called on the running thread with the intermediate results of a decomposition: its ranks, then
// the field after each improving round; and with the plan, whose Load stage is done by then.
using PreviewObserver =
    std::function<void(std::shared_ptr<const curved::Decomposition>, const PlanResult&)>;

// The way of building that mode auto is planning now.
struct StrategyProgress {
  base::Message name; // "flat layers with supports"
  std::size_t number = 1, count = 1;
  bool isLast() const { return number == count; }
};
// Called on the running thread before each way.
using StrategyObserver = std::function<void(const StrategyProgress&)>;

// Any of them may be empty.
struct PlanObservers {
  StageObserver onStage = {};
  PreviewObserver onPreview = {};
  StrategyObserver onStrategy = {};
};

} // namespace voluta::pipeline
