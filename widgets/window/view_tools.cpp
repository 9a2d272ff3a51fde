#include "window/view_tools.h"

#include <QAction>
#include <QEvent>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr int kButton = 40, kSmallButton = 28, kIconShare = 60; // [px], [%] of the button
constexpr int kPadding = 3, kGroupGap = 4;
constexpr int kBelow = 94; // room for the triad of axes
} // namespace

ViewTools::ViewTools(QWidget* parent) : QWidget(parent) {
  setObjectName("viewTools");
  hide();
  parent->installEventFilter(this);
}

void ViewTools::setGroups(const std::vector<std::vector<QAction*>>& groups) {
  for (const auto& group : groups) {
    groups_.emplace_back();
    for (QAction* action : group) {
      auto* button = new QToolButton(this);
      button->setDefaultAction(action);
      button->setAutoRaise(true);
      button->setFocusPolicy(Qt::TabFocus);
      groups_.back().push_back(button);
    }
  }
  fit();
}

QToolButton* ViewTools::button(const QAction* action) const {
  for (const auto& group : groups_)
    for (QToolButton* button : group)
      if (button->defaultAction() == action)
        return button;
  return nullptr;
}

int ViewTools::edgeFor(int room) const {
  int buttons = 0, gaps = 0;
  for (const auto& group : groups_) {
    buttons += static_cast<int>(group.size());
    gaps += kGroupGap;
  }
  return buttons == 0 ? kButton
                      : std::clamp((room - gaps - kPadding) / buttons, kSmallButton, kButton);
}

// A group that does not fit below the one before begins another column.
void ViewTools::fit() {
  const int room = std::max(kButton, parentWidget()->height() - kBelow);
  const int edge = edgeFor(room);
  int x = kPadding, y = kPadding, lowest = 0;
  for (const auto& group : groups_) {
    if (group.empty())
      continue;
    const int height = static_cast<int>(group.size()) * edge;
    if (y > kPadding && y + height + kPadding > room) {
      x += edge;
      y = kPadding;
    }
    for (QToolButton* button : group) {
      if (y + edge + kPadding > room && y > kPadding) {
        x += edge;
        y = kPadding;
      }
      button->setIconSize(QSize(edge, edge) * kIconShare / 100);
      button->setGeometry(x, y, edge, edge);
      y += edge;
    }
    lowest = std::max(lowest, y);
    y += kGroupGap;
  }
  resize(x + edge + kPadding, lowest + kPadding);
  emit fitted();
}

void ViewTools::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = palette().window().color();
  ground.setAlpha(225);
  painter.setBrush(ground);
  painter.setPen(palette().mid().color());
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  for (std::size_t i = 1; i < groups_.size(); ++i)
    if (!groups_[i].empty() && groups_[i].front()->y() > kPadding) {
      const int y = groups_[i].front()->y() - kGroupGap / 2 - 1, x = groups_[i].front()->x();
      painter.drawLine(x + 6, y, x + groups_[i].front()->width() - 6, y);
    }
}

bool ViewTools::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize)
    fit();
  return QWidget::eventFilter(watched, event);
}

void ViewTools::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit fitted();
}

void ViewTools::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emit fitted();
}

} // namespace voluta::window
