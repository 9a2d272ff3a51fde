#include "window/pages/resumable.h"

#include "document/document.h"
#include "document/planning.h"
#include "plan/waypoints.h"
#include "window/presenters/presenter.h"

#include <QCoreApplication>

namespace voluta::window {

std::optional<std::size_t>
resumableAt(const Workspace& work,
            const std::function<std::optional<std::size_t>(const plan::Trajectory&)>& find) {
  const auto motion = work.document.result(project::Stage::Motion);
  const auto& clock = work.presenter.clock();
  if (!motion || !clock || clock->empty() || clock->trajectory() != motion->job.trajectory ||
      !work.document.upToDate(project::Stage::Motion) || work.planning.running())
    return std::nullopt;
  const auto point = find(*motion->job.trajectory);
  return point && *point >= motion->job.resumedAt ? point : std::nullopt;
}

QString placeOfPoint(const Workspace& work, std::size_t point) {
  const project::Job& job = work.document.result(project::Stage::Motion)->job;
  const plan::ToolPath* path = plan::pathOf(*job.toolPlan, job.trajectory->waypoint[point]);
  const auto bead = path ? path - job.toolPlan->paths.data() + 1 : 0;
  return QCoreApplication::translate("Resume", "Bead %1 of %2")
      .arg(bead)
      .arg(job.toolPlan->paths.size());
}

} // namespace voluta::window
