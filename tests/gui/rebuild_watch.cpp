#include "gui/rebuild_watch.h"

#include "gui/window_fixture.h"

#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QPointer>
#include <gtest/gtest.h>

namespace voluta::test {

namespace {
QString named(const QObject* object) {
  return QString("%1 '%2'").arg(object->metaObject()->className(), object->objectName());
}

bool isAtInput(const QWidget* widget) {
  for (const QObject* receiver : application().inputReceivers())
    for (const QObject* at = receiver; at; at = at->parent())
      if (at == widget)
        return true;
  return false;
}
} // namespace

void RebuildWatch::watchAll() {
  for (QWidget* widget : QApplication::allWidgets())
    if (!known_.contains(widget))
      watch(widget);
}

void RebuildWatch::watch(QWidget* widget) {
  known_ << widget;
  connect(widget, &QObject::destroyed, this, [this, what = named(widget)](QObject* gone) {
    known_.remove(gone);
    for (const QObject* receiver : application().inputReceivers())
      if (receiver == gone)
        ADD_FAILURE() << what.toStdString() << " is deleted inside an input event of its own";
  });
  if (auto* view = qobject_cast<QAbstractItemView*>(widget))
    watchRows(view, view->model());
  if (auto* combo = qobject_cast<QComboBox*>(widget))
    watchRows(combo, combo->model());
}

void RebuildWatch::watchRows(QWidget* view, QAbstractItemModel* model) {
  if (!model)
    return;
  const auto check = [view = QPointer<QWidget>(view)] {
    if (view && isAtInput(view))
      ADD_FAILURE() << "rows of " << named(view).toStdString()
                    << " are taken away inside an input event of the list";
  };
  connect(model, &QAbstractItemModel::rowsAboutToBeRemoved, this, check);
  connect(model, &QAbstractItemModel::modelAboutToBeReset, this, check);
}

} // namespace voluta::test
