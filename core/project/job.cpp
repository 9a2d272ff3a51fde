#include "project/job.h"

#include "geometry/append_mesh.h"
#include "geometry/convex_polygon.h"

#include <utility>

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

std::vector<std::size_t> firstTriangles(const Job& job) {
  std::vector<std::size_t> first;
  std::size_t next = 0;
  for (const JobItem& item : job.items) {
    if (job.items.size() == 1)
      break;
    first.push_back(next);
    next += item.printed().triangles.size();
  }
  return first;
}

platform::PlatformSolid platformOf(const Job& job) {
  if (job.items.size() == 1)
    return job.item().platform;
  std::vector<Eigen::Vector2d> corners;
  for (const JobItem& item : job.items)
    corners.insert(corners.end(), item.platform.polygon.begin(), item.platform.polygon.end());
  return geometry::convexPolygon(std::move(corners));
}

StageKeys Job::keys() const {
  StageKeys keys;
  for (std::size_t i = 0; i < kStageCount; ++i)
    keys[i] = stages[i].key;
  return keys;
}

Job upTo(Job job, std::optional<Stage> last) {
  const auto keeps = [&](Stage stage) { return last && stage <= *last; };
  for (std::size_t i = 0; i < job.items.size(); ++i) {
    JobItem& item = job.item(i);
    ItemReport& report = job.report.item(i);
    if (!keeps(Stage::Load)) {
      item.scale = 1.0;
      item.placement.reset();
      item.part = nullptr;
      report.model = {};
    }
    if (!keeps(Stage::Decompose)) {
      item.platform = {};
      item.result = {};
      report.decomposition = {};
      report.decomposition.mode = job.choices.item(i).mode;
    }
    if (!keeps(Stage::Layers)) {
      item.layers = nullptr;
      report.layers = {};
    }
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
