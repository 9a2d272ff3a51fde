#include "project/job.h"

#include "geometry/append_mesh.h"

namespace voluta::project {

const geometry::TriangleMesh& JobItem::printed() const {
  const auto* less = std::get_if<ReducedPlatform>(&result);
  return less && less->part ? *less->part : *part;
}

std::shared_ptr<const geometry::TriangleMesh> printedOf(const Job& job) {
  if (job.items.size() == 1)
    return {std::shared_ptr<void>(), &job.item().printed()};
  auto all = std::make_shared<geometry::TriangleMesh>();
  for (const JobItem& item : job.items)
    geometry::appendMesh(*all, item.printed());
  return all;
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
    job.item().scale = 1.0;
    job.item().placement.reset();
    job.item().part = nullptr;
    job.report.item().model = {};
  }
  if (!keeps(Stage::Decompose)) {
    job.item().platform = {};
    job.item().result = {};
    job.report.item().decomposition = {};
    job.report.item().decomposition.mode = job.choices.item().mode;
  }
  if (!keeps(Stage::Layers)) {
    job.item().layers = nullptr;
    job.report.item().layers = {};
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
