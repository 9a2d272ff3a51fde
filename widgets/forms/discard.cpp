#include "forms/discard.h"

#include <QAction>
#include <QLayout>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QWidget>

namespace voluta::forms {

namespace {
class Rows : public QObject {
public:
  Rows(QList<QTreeWidgetItem*> items, QObject* parent)
      : QObject(parent), items_(std::move(items)) {}
  ~Rows() override { qDeleteAll(items_); }

private:
  QList<QTreeWidgetItem*> items_;
};

void takeOut(QLayout& layout, QWidget& widget) {
  layout.removeWidget(&widget);
  for (int i = 0; i < layout.count(); ++i)
    if (QLayout* inner = layout.itemAt(i)->layout())
      takeOut(*inner, widget);
}
} // namespace

void discard(QWidget* widget) {
  widget->hide();
  widget->setObjectName({});
  if (const QWidget* parent = widget->parentWidget(); parent && parent->layout())
    takeOut(*parent->layout(), *widget);
  widget->deleteLater();
}

void discard(QAction* action) {
  for (QObject* shown : action->associatedObjects())
    if (auto* menu = qobject_cast<QWidget*>(shown))
      menu->removeAction(action);
  action->deleteLater();
}

void discardRows(QTreeWidget& tree) {
  const QSignalBlocker quiet(tree);
  QList<QTreeWidgetItem*> items;
  while (tree.topLevelItemCount() > 0)
    items << tree.takeTopLevelItem(tree.topLevelItemCount() - 1);
  (new Rows(std::move(items), &tree))->deleteLater();
}

} // namespace voluta::forms
