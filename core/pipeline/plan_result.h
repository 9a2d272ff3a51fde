// What a plan is asked for, what it returns, and who is told while it is made.
#pragma once

#include "base/text.h"
#include "pipeline/stages.h"
#include "project/job.h"
#include "project/stage.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct RequestedItem {
  std::string part;                                  // path of a mesh, or "sample:NAME"
  std::shared_ptr<const project::LoadedPart> loaded; // used instead of `part` when set
};

struct PlanRequest {
  std::vector<RequestedItem> items = {RequestedItem{}}; // as choices.items
  project::Choices choices;
  project::Stage until = project::Stage::Replay; // the plan ends after it

  RequestedItem& item(std::size_t i = 0) { return items.at(i); }
  const RequestedItem& item(std::size_t i = 0) const { return items.at(i); }
};

struct PlannedItem {
  std::shared_ptr<const modes::LoadStage> placed; // null before Load is done
};

// Copies are cheap: whatever is large is shared.
struct PlanResult {
  project::Job job;                                 // choices, results and report
  std::vector<PlannedItem> items = {PlannedItem{}}; // as the job's
  std::shared_ptr<const process::Process> process;
  std::shared_ptr<const robot::Cell> cell; // with the job's platform; null before Decompose is done
  std::vector<std::shared_ptr<const CheckedProgram>> checked; // one a format, refused ones too
  bool debug = false;                                         // --set output.debug=true
  bool keepRefused = false;                                   // --set output.refused=true
  bool proofs = false;                                        // --set output.proof=true
  bool buildFile = false;                                     // --set output.build3mf=true

  PlannedItem& item(std::size_t i = 0) { return items.at(i); }
  const PlannedItem& item(std::size_t i = 0) const { return items.at(i); }
};

// Called on the running thread as soon as a stage is done, taken from the cache or not, with all
// that is there so far.
using StageObserver = std::function<void(project::Stage, const PlanResult&)>;

// Called on the running thread with what a decomposition that is being made has come to: its ranks,
// then its field as rounds improve it; and with the plan, which has its Load stage by then.
using PreviewObserver =
    std::function<void(std::shared_ptr<const curved::Decomposition>, const PlanResult&)>;

// Which way of building mode auto is planning.
struct WayInTurn {
  base::Message name; // "flat layers with supports"
  std::size_t number = 1, count = 1;
  bool isLast() const { return number == count; }
};
// Called on the running thread before each way.
using WayObserver = std::function<void(const WayInTurn&)>;

// Each may be empty.
struct PlanObservers {
  StageObserver onStage = {};
  PreviewObserver onPreview = {};
  WayObserver onWay = {};
};

} // namespace voluta::pipeline
