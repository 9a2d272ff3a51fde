#include "window/pages/part_handles.h"

#include "document/document.h"
#include "geometry/placement.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "window/cell/touch_dialog.h"
#include "window/presenters/presenter.h"

#include <algorithm>

namespace voluta::window {

using project::Stage;
using viewer::Tool;

PartHandles::PartHandles(const Workspace& workspace, const Page& page)
    : work_(workspace), page_(page) {}

std::vector<Command> PartHandles::toolCommands() {
  struct Row {
    const char *id, *text, *tip, *key, *icon;
    Tool tool;
  };
  static constexpr Row kTools[] = {
      {"toolMove", QT_TRANSLATE_NOOP("Commands", "&Move"),
       QT_TRANSLATE_NOOP("Commands", "Moves the part: drag a handle, or type X 10 Enter"), "M",
       "move", Tool::Move},
      {"toolTurn", QT_TRANSLATE_NOOP("Commands", "&Turn"),
       QT_TRANSLATE_NOOP("Commands", "Rotates the part: drag a ring, or type Z 45 Enter"), "R",
       "turn", Tool::Rotate},
      {"toolScale", QT_TRANSLATE_NOOP("Commands", "&Scale"),
       QT_TRANSLATE_NOOP("Commands", "Scales the part: drag a handle, or type 120 Enter for "
                                     "120 %"),
       "S", "scale", Tool::Scale},
      {"toolLayFlat", QT_TRANSLATE_NOOP("Commands", "&Lay on face"),
       QT_TRANSLATE_NOOP("Commands", "Click the face to place on the plate"), "F", "lay-flat",
       Tool::LayFlat}};
  std::vector<Command> commands;
  for (const Row& row : kTools) {
    const auto on = [this, tool = row.tool] { return work_.viewport.tool() == tool; };
    commands.push_back({row.id,
                        "editMenu",
                        1,
                        row.text,
                        row.tip,
                        {QKeySequence(row.key)},
                        [this, on, tool = row.tool] { setTool(on() ? Tool::None : tool); },
                        [this] { return page_.isShown() && work_.document.source(); },
                        on,
                        row.icon,
                        BarGroup::Tools});
  }
  return commands;
}

std::vector<Command> PartHandles::commands() {
  const auto part = [this] { return static_cast<bool>(work_.document.source()); };
  // Around a rod the rod determines the part's placement.
  const auto onPlate = [this] {
    return work_.document.source() &&
           !modes::findMode(work_.document.choices().item().mode).aroundRod;
  };
  std::vector<Command> commands = toolCommands();
  commands.push_back({"dropToPlate",
                      "editMenu",
                      2,
                      QT_TRANSLATE_NOOP("Commands", "&Drop to plate"),
                      QT_TRANSLATE_NOOP("Commands", "Lowers the part onto the plate"),
                      {QKeySequence("D")},
                      [this] { drop(); },
                      part,
                      {},
                      "drop",
                      BarGroup::Place});
  commands.push_back({"centrePart",
                      "editMenu",
                      2,
                      QT_TRANSLATE_NOOP("Commands", "&Centre"),
                      QT_TRANSLATE_NOOP("Commands", "Centres the part on the plate"),
                      {QKeySequence("C")},
                      [this] { centre(); },
                      part,
                      {},
                      "centre",
                      BarGroup::Place});
  commands.push_back(
      {"touchedPoints",
       "editMenu",
       2,
       QT_TRANSLATE_NOOP("Commands", "Place on touched &points…"),
       QT_TRANSLATE_NOOP("Commands", "Moves the part to a cylinder measured by touching"),
       {},
       [this] { layOnTouchedPoints(); },
       onPlate});
  return commands;
}

geometry::Placement PartHandles::placed() const {
  const document::Document& document = work_.document;
  const auto shown = document.itemResult(Stage::Load);
  return shown && document.upToDate(Stage::Load)
             ? shown->job.item().placement.value_or(document.choices().item().placement)
             : document.choices().item().placement;
}

void PartHandles::setTool(Tool tool) {
  work_.viewport.setTool(work_.document.source() ? tool : Tool::None);
  if (viewer::hasHandles(work_.viewport.tool()))
    work_.viewport.setFocus(Qt::OtherFocusReason); // Numbers can be typed at once
}

void PartHandles::drop() {
  geometry::Placement p = placed();
  p.liftMm = 0.0;
  work_.document.place(p, tr("drop to plate"));
}

void PartHandles::centre() {
  geometry::Placement p = placed();
  p.centreMm.setZero();
  work_.document.place(p, tr("centre"));
}

void PartHandles::layOnFace(const Eigen::Vector3d& normal) {
  if (normal.norm() < 0.5)
    return;
  geometry::Placement placement = placed();
  placement.rotation = geometry::rotationLayingFlat(normal) * placement.rotation;
  placement.liftMm = 0.0;
  work_.document.place(placement, tr("lay on face"));
}

// Moves the part to the measured cylinder; cylindrical layers get its axis.
void PartHandles::layOnTouchedPoints() {
  document::Document& document = work_.document;
  if (!document.source() || work_.presenter.partBox().isEmpty())
    return;
  TouchDialog dialog({0.0, 0.0}, work_.viewport.window());
  if (dialog.exec() != QDialog::Accepted || !dialog.circle())
    return;
  const Eigen::Vector2d shift = dialog.shiftMm();
  project::Choices choices = document.choices();
  // Start from the present placement, whether manual or by the mode.
  choices.item().placement = placed();
  choices.item().placement.centreMm.y() += shift.x();
  choices.item().placement.liftMm += shift.y();
  if (const auto shape = choices.item().parameters.find("layerShape");
      shape != choices.item().parameters.end() && shape->second == "cylinder")
    choices.item().parameters["layerCentre"] = QStringLiteral("0,%1,%2")
                                                   .arg(dialog.circle()->centre.x(), 0, 'g', 8)
                                                   .arg(dialog.circle()->centre.y(), 0, 'g', 8)
                                                   .toStdString();
  document.setChoices(choices, tr("place on touched points"));
}

void PartHandles::clicked(const std::optional<scene::Hit>& hit) {
  if (hit && hit->what == scene::Hit::What::OtherPart && hit->item < work_.document.partCount()) {
    work_.document.setActive(hit->item);
    return;
  }
  if (work_.viewport.tool() != Tool::LayFlat || !hit || hit->what != scene::Hit::What::Part)
    return;
  setTool(Tool::None);
  layOnFace(hit->normal);
}

// Whether the handles are the part's own.
bool PartHandles::areHandles() const {
  const Tool tool = work_.viewport.tool();
  return tool == Tool::Move || tool == Tool::Rotate || tool == Tool::Scale;
}

void PartHandles::gizmoStarted() {
  if (!areHandles())
    return;
  before_ = placed();
  const auto placed = work_.document.itemResult(Stage::Load);
  scaleBefore_ = placed ? placed->job.item().scale : 1.0;
}

void PartHandles::gizmoDragged(const viewer::GizmoChange& change, bool finished) {
  if (!areHandles())
    return;
  const Eigen::AlignedBox3d& box = work_.presenter.partBox();
  const Eigen::Vector3d centre =
      box.isEmpty() ? Eigen::Vector3d::Zero().eval() : box.center().eval();
  Eigen::Affine3d preview = Eigen::Affine3d::Identity();
  preview.translate(centre + change.moveMm).rotate(change.rotation).scale(change.scale);
  preview.translate(-centre);
  scene::Scene& scene = work_.viewport.scene();
  scene.setPartPreview(preview);
  work_.viewport.requestFrame();
  if (!finished)
    return;
  placeDragged(change);
  // A drag without effect causes no new drawing that would replace the preview.
  if (work_.document.upToDate(Stage::Load))
    scene.setPartPreview(Eigen::Affine3d::Identity());
}

void PartHandles::placeDragged(const viewer::GizmoChange& change) {
  document::Document& document = work_.document;
  geometry::Placement placement = before_;
  placement.centreMm += change.moveMm.head<2>();
  placement.liftMm += change.moveMm.z();
  if (!modes::findMode(document.choices().item().mode).aroundRod)
    placement.liftMm = std::max(0.0, placement.liftMm);
  placement.rotation = (change.rotation * placement.rotation).normalized();
  switch (work_.viewport.tool()) {
  case Tool::Move:
    document.place(placement, tr("move"));
    break;
  case Tool::Rotate:
    document.place(placement, tr("turn"));
    break;
  case Tool::Scale:
    if (change.scale != 1.0)
      document.setScale(QString::number(scaleBefore_ * change.scale, 'g', 6));
    break;
  default:
    break;
  }
}

} // namespace voluta::window
