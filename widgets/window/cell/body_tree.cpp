#include "window/cell/body_tree.h"

#include "forms/discard.h"

#include <QSignalBlocker>
#include <algorithm>

namespace voluta::window {

using robot::DraftBody;

namespace {

constexpr int kBodyRole = Qt::UserRole; // Index among the draft's bodies

QString named(const std::string& text) {
  return QString::fromStdString(text);
}

std::optional<std::size_t> bodyOf(const QTreeWidgetItem* item) {
  const QVariant at = item ? item->data(0, kBodyRole) : QVariant();
  return at.isValid() ? std::optional(at.toULongLong()) : std::nullopt;
}

} // namespace

BodyTree::BodyTree(QWidget* parent) : QTreeWidget(parent) {
  setHeaderHidden(true);
}

void BodyTree::setDraft(const robot::CellDraft& draft) {
  const std::optional<DraftBody> before = chosen();
  const QSignalBlocker quiet(this);
  forms::discardRows(*this);
  bodies_ = draft.bodies();
  auto* base = new QTreeWidgetItem(this, {tr("Robot's base")});
  auto* flange = new QTreeWidgetItem(base, {tr("Flange of %1").arg(named(draft.robot()))});
  QTreeWidgetItem* last = base; // Parent of the next axis
  const auto add = [&](std::size_t n, QTreeWidgetItem* parent) {
    auto* item = new QTreeWidgetItem(parent, {nameOf(bodies_[n])});
    item->setData(0, kBodyRole, static_cast<qulonglong>(n));
    return item;
  };
  for (std::size_t n = 0; n < bodies_.size(); ++n)
    if (bodies_[n].kind == DraftBody::Kind::Axis)
      last = add(n, last);
  for (std::size_t n = 0; n < bodies_.size(); ++n)
    if (bodies_[n].kind != DraftBody::Kind::Axis)
      add(n, bodies_[n].onFlange                            ? flange
             : bodies_[n].kind == DraftBody::Kind::Platform ? last
                                                            : base);
  expandAll();
  if (before)
    choose(*before);
}

std::optional<DraftBody> BodyTree::chosen() const {
  const auto at = bodyOf(currentItem());
  return at ? std::optional(bodies_[*at]) : std::nullopt;
}

void BodyTree::choose(const DraftBody& body) {
  for (QTreeWidgetItemIterator item(this); *item; ++item)
    if (const auto at = bodyOf(*item); at && bodies_[*at].sameAs(body))
      setCurrentItem(*item);
}

QString BodyTree::nameOf(const DraftBody& body) {
  switch (body.kind) {
  case DraftBody::Kind::Nozzle:
    return tr("Nozzle");
  case DraftBody::Kind::Platform:
    return tr("Plate");
  case DraftBody::Kind::PurgePlace:
    return tr("Place for purges");
  case DraftBody::Kind::Axis:
  case DraftBody::Kind::Obstacle:
    break;
  }
  return named(body.name);
}

QString BodyTree::parentOf(const DraftBody& body, const robot::CellDraft& draft) {
  if (body.onFlange)
    return tr("in the flange");
  // Fixed bodies are given in the base with the axes under the robot at 0.
  const auto isUnderPlate = [](const DraftBody& other) {
    return other.kind == DraftBody::Kind::Axis && !other.underRobot;
  };
  const std::vector<DraftBody> bodies = draft.bodies();
  if (body.kind == DraftBody::Kind::Platform && std::ranges::any_of(bodies, isUnderPlate))
    return tr("on the last axis");
  if (isUnderPlate(body) && std::ranges::any_of(bodies, [&](const DraftBody& other) {
        return isUnderPlate(other) && other.index < body.index;
      }))
    return tr("on the previous axis");
  return tr("in the robot's base");
}

Eigen::Isometry3d base_T_parent(const DraftBody& body, const robot::Cell& cell) {
  std::vector<Eigen::Isometry3d> frames;
  cell.framePoses(cell.home(), frames);
  const auto at = [&](int frame) { return frames[static_cast<std::size_t>(frame)]; };
  const std::size_t axes = cell.externalAxes().size();
  switch (body.kind) {
  case DraftBody::Kind::Nozzle:
  case DraftBody::Kind::Platform:
    if (body.onFlange)
      return at(cell.armDof() + 1);
    if (body.kind == DraftBody::Kind::Platform && axes > 0)
      return at(cell.axisFrame(axes - 1));
    break;
  case DraftBody::Kind::Axis:
    if (body.index > 0 && body.index <= axes) // Identity for axes under the robot, at home
      return at(cell.axisFrame(body.index - 1));
    break;
  case DraftBody::Kind::PurgePlace:
  case DraftBody::Kind::Obstacle:
    break;
  }
  return Eigen::Isometry3d::Identity();
}

} // namespace voluta::window
