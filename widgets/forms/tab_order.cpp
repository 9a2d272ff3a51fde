#include "forms/tab_order.h"

#include <QDockWidget>
#include <QGridLayout>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <algorithm>
#include <tuple>

namespace voluta::forms {

namespace {
void add(QWidget* widget, std::vector<QWidget*>& order);

std::vector<QLayoutItem*> itemsOf(const QLayout& layout) {
  std::vector<QLayoutItem*> items;
  for (int i = 0; i < layout.count(); ++i)
    items.push_back(layout.itemAt(i));
  if (const auto* grid = qobject_cast<const QGridLayout*>(&layout)) {
    std::vector<std::tuple<int, int, QLayoutItem*>> placed;
    for (int i = 0; i < grid->count(); ++i) {
      int row = 0, column = 0, rows = 0, columns = 0;
      grid->getItemPosition(i, &row, &column, &rows, &columns);
      placed.emplace_back(row, column, grid->itemAt(i));
    }
    std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) {
      return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
    });
    std::transform(placed.begin(), placed.end(), items.begin(),
                   [](const auto& place) { return std::get<2>(place); });
  }
  return items;
}

void add(const QLayout& layout, std::vector<QWidget*>& order) {
  for (QLayoutItem* item : itemsOf(layout)) {
    if (QWidget* widget = item->widget())
      add(widget, order);
    else if (const QLayout* inner = item->layout())
      add(*inner, order);
  }
}

void add(QWidget* widget, std::vector<QWidget*>& order) {
  if (widget->focusPolicy() & Qt::TabFocus)
    order.push_back(widget);
  if (const auto* area = qobject_cast<QScrollArea*>(widget)) {
    if (area->widget())
      add(area->widget(), order);
  } else if (const auto* tabs = qobject_cast<QTabWidget*>(widget)) {
    add(tabs->tabBar(), order);
    for (int i = 0; i < tabs->count(); ++i)
      add(tabs->widget(i), order);
  } else if (const auto* dock = qobject_cast<QDockWidget*>(widget)) {
    if (dock->widget())
      add(dock->widget(), order);
  } else if (const QLayout* layout = widget->layout()) {
    add(*layout, order);
  }
}
} // namespace

std::vector<QWidget*> inReadingOrder(QWidget* top) {
  std::vector<QWidget*> order;
  add(top, order);
  return order;
}

void tabInReadingOrder(const std::vector<QWidget*>& tops) {
  QWidget* before = nullptr;
  for (QWidget* top : tops)
    for (QWidget* widget : inReadingOrder(top)) {
      if (before)
        QWidget::setTabOrder(before, widget);
      before = widget;
    }
}

} // namespace voluta::forms
