#include "project/job.h"

namespace voluta::project {

const geometry::TriangleMesh& Job::printed() const {
  const auto* less = std::get_if<ReducedPlatform>(&result);
  return less && less->part ? *less->part : *part;
}

StageKeys Job::keys() const {
  StageKeys keys;
  for (std::size_t i = 0; i < kStageCount; ++i)
    keys[i] = stages[i].key;
  return keys;
}

Job upTo(Job job, std::optional<Stage> last) {
  const auto keeps = [&](Stage stage) { return last && stage <= *last; };
  if (!keeps(Stage::Load)) {
    job.scale = 1.0;
    job.placement.reset();
    job.part = nullptr;
    job.report.model = {};
  }
  if (!keeps(Stage::Decompose)) {
    job.platform = {};
    job.result = {};
    job.report.decomposition = {};
    job.report.decomposition.mode = job.choices.mode;
  }
  if (!keeps(Stage::Layers)) {
    job.layers = nullptr;
    job.report.layers = {};
  }
  if (!keeps(Stage::Toolpath)) {
    job.toolPlan = nullptr;
    job.report.toolpath = {};
  }
  if (!keeps(Stage::Motion)) {
    job.trajectory = nullptr;
    job.resumedAt = 0;
    job.report.motion = {};
  }
  if (!keeps(Stage::Replay)) {
    job.report.programs.clear();
    job.report.replay = {};
  }
  std::size_t findings = 0;
  Timings timings;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    StageRecord& record = job.stages[i];
    if (!keeps(static_cast<Stage>(i)))
      record = {};
    findings += record.findings;
    timings += record.timings;
  }
  job.report.findings.resize(findings);
  timings.total = job.report.timings.total;
  job.report.timings = timings;
  if (!last)
    job.reached.reset();
  else if (job.reached && *last < *job.reached)
    job.reached = last;
  return job;
}

} // namespace voluta::project
