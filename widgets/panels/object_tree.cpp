#include "panels/object_tree.h"

#include "forms/colours.h"
#include "forms/icons.h"

#include <QAbstractItemDelegate>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>

namespace voluta::panels {

namespace {
constexpr int kName = 0, kDetail = 1, kEye = 2;

SceneItem sceneItemOf(const QTreeWidgetItem* item) {
  return static_cast<SceneItem>(item->data(kName, Qt::UserRole).toInt());
}

bool isOfCell(SceneItem item) {
  return item == SceneItem::Robot || item == SceneItem::Nozzle || item == SceneItem::Plate;
}
} // namespace

ObjectTree::ObjectTree(QWidget* parent) : QTreeWidget(parent) {
  setColumnCount(3);
  setHeaderHidden(true);
  setRootIsDecorated(true);
  setUniformRowHeights(true);
  setTextElideMode(Qt::ElideRight);
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(fontMetrics().height());
  header()->setSectionResizeMode(kName, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(kDetail, QHeaderView::Stretch);
  header()->setSectionResizeMode(kEye, QHeaderView::Fixed);
  header()->resizeSection(kEye, fontMetrics().height() + 12);

  for (int i = 0; i < kSceneItemCount; ++i) {
    const auto which = static_cast<SceneItem>(i);
    QTreeWidgetItem* item = isOfCell(which) ? new QTreeWidgetItem(entry(SceneItem::Cell).item)
                                            : new QTreeWidgetItem(this);
    item->setData(kName, Qt::UserRole, i);
    entry(which).item = item;
  }
  expandAll();
  connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item, int column) {
    if (column == kEye)
      toggle(sceneItemOf(item));
  });
  // The shown name is that of the document again, whether it takes the new one or not.
  connect(itemDelegate(), &QAbstractItemDelegate::commitData, this, [this](QWidget* editor) {
    const auto* line = qobject_cast<QLineEdit*>(editor);
    if (line)
      emit renamed(line->text()); // at once: the part that is active may be another one later
    QMetaObject::invokeMethod(
        this, [this] { showEntry(SceneItem::Part); }, Qt::QueuedConnection);
  });
  connect(itemDelegate(), &QAbstractItemDelegate::closeEditor, this, [this] {
    QTreeWidgetItem* part = entry(SceneItem::Part).item;
    part->setFlags(part->flags() & ~Qt::ItemIsEditable);
    showEntry(SceneItem::Part);
  });
  connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item)
      emit selected(sceneItemOf(item));
  });
  retranslate();
}

void ObjectTree::setText(SceneItem item, const QString& name, const QString& detail) {
  entry(item).name = name;
  entry(item).detail = detail;
  showEntry(item);
}

void ObjectTree::setShown(SceneItem item, bool shown) {
  entry(item).shown = shown;
  retranslate();
}

bool ObjectTree::isShown(SceneItem item) const {
  return entries_[static_cast<std::size_t>(item)].shown;
}

void ObjectTree::select(SceneItem item) {
  const QSignalBlocker quiet(this);
  setCurrentItem(entry(item).item);
}

std::optional<SceneItem> ObjectTree::sceneItemAt(const QPoint& place) const {
  const QTreeWidgetItem* item = itemAt(place);
  return item ? std::optional(sceneItemOf(item)) : std::nullopt;
}

namespace {
// Whether one is shown only with the other, or within it.
bool belongsTo(SceneItem one, SceneItem other) {
  return one == other || (isOfCell(one) && other == SceneItem::Cell) ||
         (one == SceneItem::Cell && isOfCell(other));
}
} // namespace

bool ObjectTree::isIsolated(SceneItem item) const {
  for (int i = 0; i < kSceneItemCount; ++i)
    if (isShown(static_cast<SceneItem>(i)) != belongsTo(static_cast<SceneItem>(i), item))
      return false;
  return true;
}

void ObjectTree::isolate(SceneItem item) {
  const bool isolated = isIsolated(item);
  for (int i = 0; i < kSceneItemCount; ++i) {
    const auto one = static_cast<SceneItem>(i);
    if (const bool shown = isolated || belongsTo(one, item); shown != isShown(one))
      toggle(one);
  }
}

void ObjectTree::editPartName(const QString& name) {
  QTreeWidgetItem* part = entry(SceneItem::Part).item;
  part->setText(kName, name);
  part->setFlags(part->flags() | Qt::ItemIsEditable);
  setCurrentItem(part);
  editItem(part, kName);
}

void ObjectTree::toggle(SceneItem which) {
  setShown(which, !isShown(which));
  emit visibilityChanged(which, isShown(which));
}

void ObjectTree::showEntry(SceneItem which) {
  const Entry& e = entry(which);
  const auto kindText = [&] {
    switch (which) {
    case SceneItem::Part:
      return tr("Part");
    case SceneItem::Platform:
      return tr("Platform");
    case SceneItem::Cell:
      return tr("Cell");
    case SceneItem::Robot:
      return tr("Robot");
    case SceneItem::Nozzle:
      return tr("Nozzle");
    case SceneItem::Plate:
      return tr("Plate");
    }
    return QString();
  };
  e.item->setText(kName, e.name.isEmpty() ? kindText() : e.name);
  const bool ownName = which == SceneItem::Part && !e.name.isEmpty();
  e.item->setToolTip(kName, ownName ? kindText() + ": " + e.name : e.item->text(kName));
  e.item->setText(kDetail, e.detail);
  e.item->setToolTip(kDetail, e.detail);
  e.item->setForeground(kDetail, forms::mutedColour(palette()));
  e.item->setIcon(kEye, forms::icon(e.shown ? forms::Icon::EyeOpen : forms::Icon::EyeClosed));
  e.item->setToolTip(kEye, e.shown ? tr("Hide") : tr("Show"));
  const bool seen = e.shown && (!isOfCell(which) || isShown(SceneItem::Cell));
  e.item->setForeground(kName,
                        seen ? palette().color(QPalette::Text) : forms::mutedColour(palette()));
}

void ObjectTree::retranslate() {
  setAccessibleName(tr("Part and cell"));
  for (int i = 0; i < kSceneItemCount; ++i)
    showEntry(static_cast<SceneItem>(i));
}

void ObjectTree::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && currentItem())
    toggle(sceneItemOf(currentItem()));
  else
    QTreeWidget::keyPressEvent(event);
}

void ObjectTree::changeEvent(QEvent* event) {
  if ((event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) &&
      entries_.back().item)
    retranslate();
  QTreeWidget::changeEvent(event);
}

} // namespace voluta::panels
