#include "window/pages/page.h"

#include <QCoreApplication>
#include <QScrollArea>

namespace voluta::window {

Page::Page(const PageInfo& info, const Workspace& workspace) : info_(info), workspace_(workspace) {}

QString Page::title() const {
  return QCoreApplication::translate("Commands", info_.name).remove('&');
}

void Page::enter() {
  shown_ = true;
  entered();
}

void Page::leave() {
  shown_ = false;
  left();
}

PageState Page::state() const {
  return worstState(workspace_.document, stages());
}

QScrollArea* scrolled(QWidget* content) {
  auto* area = new QScrollArea;
  area->setObjectName(kPageArea);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidget(content);
  return area;
}

} // namespace voluta::window
