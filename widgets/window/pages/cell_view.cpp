#include "window/pages/cell_view.h"

#include "panels/object_tree.h"
#include "window/presenter.h"

namespace voluta::window {

void drawCellAtWork(scene::ViewState& view, const Workspace& work) {
  using panels::SceneItem;
  const auto shows = [&](SceneItem item) { return work.tree.isShown(item); };
  view.part = false;
  view.sectionOn = false;
  view.paths = work.presenter.hasPaths() && shows(SceneItem::Part);
  view.materialColour = true;
  const auto& clock = work.presenter.clock();
  if (!clock || clock->empty()) {
    view.part = shows(SceneItem::Part) && !view.paths;
    return;
  }
  view.world = scene::World::Base;
  view.cell = shows(SceneItem::Cell);
  const auto role = [&](robot::BodyRole r) -> bool& {
    return view.roles[static_cast<std::size_t>(r)];
  };
  role(robot::BodyRole::Link) = shows(SceneItem::Robot);
  role(robot::BodyRole::Head) = role(robot::BodyRole::Holder) = shows(SceneItem::Nozzle);
  role(robot::BodyRole::Platform) = shows(SceneItem::Plate);
  view.joints = clock->jointsAt(work.timeline.timeS());
  view.printedWaypoints = clock->printedWaypoints(work.timeline.timeS());
}

} // namespace voluta::window
