#include "window/pages/cell_view.h"

#include "document/document.h"
#include "panels/object_tree.h"
#include "window/picture.h"
#include "window/presenters/presenter.h"

namespace voluta::window {

namespace {

void showCell(scene::ViewState& view, const panels::ObjectTree& tree) {
  using panels::SceneItem;
  const auto role = [&](robot::BodyRole r) -> bool& {
    return view.roles[static_cast<std::size_t>(r)];
  };
  view.cell = tree.isShown(SceneItem::Cell);
  role(robot::BodyRole::Link) = tree.isShown(SceneItem::Robot);
  role(robot::BodyRole::Head) = role(robot::BodyRole::Holder) = tree.isShown(SceneItem::Nozzle);
  role(robot::BodyRole::Platform) = tree.isShown(SceneItem::Plate);
}

} // namespace

void drawCellAtRest(scene::ViewState& view, const Workspace& work) {
  using panels::SceneItem;
  work.presenter.showCell(PartPresenter::CellOf::Choices);
  showCell(view, work.tree);
  const bool hasPart = !work.presenter.partBox().isEmpty();
  view.cellFramed = !hasPart;
  view.cellDimmed = hasPart && !work.picture.look().arm;
  view.plateRuled = hasPart;
  view.partSize = hasPart && work.tree.isShown(SceneItem::Part);
}

void drawCellAtWork(scene::ViewState& view, const Workspace& work) {
  using panels::SceneItem;
  const auto shows = [&](SceneItem item) { return work.tree.isShown(item); };
  const auto& clock = work.presenter.clock();
  const bool moves = clock && !clock->empty();
  work.presenter.showCell(moves ? PartPresenter::CellOf::Plan : PartPresenter::CellOf::Choices);
  view.sectionOn = false;
  view.paths = work.presenter.hasPaths() && shows(SceneItem::Part) &&
               (moves || work.document.upToDate(project::Stage::Toolpath));
  view.part = !moves && !view.paths && shows(SceneItem::Part);
  view.materialColour = true;
  if (!moves && !work.presenter.hasCell())
    return;
  view.world = scene::World::Base;
  showCell(view, work.tree);
  if (!moves)
    return; // At home
  view.joints = clock->jointsAt(work.timeline.timeS());
  view.printedWaypoints = clock->printedWaypoints(work.timeline.timeS());
}

} // namespace voluta::window
