#include "forms/fold.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace voluta::forms {

Fold::Fold(QWidget* content, QWidget* parent) : QWidget(parent), content_(content) {
  heading_ = new QToolButton(this);
  heading_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  heading_->setArrowType(Qt::DownArrow);
  heading_->setAutoRaise(true);
  heading_->setCheckable(true);
  heading_->setChecked(true);
  heading_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  QFont bold = heading_->font();
  bold.setBold(true);
  heading_->setFont(bold);
  connect(heading_, &QToolButton::toggled, this, &Fold::setOpen);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(heading_);
  column->addWidget(content_);
}

void Fold::setTitle(const QString& title) {
  title_ = title;
  showTitle();
}

void Fold::setMarked(bool marked) {
  marked_ = marked;
  showTitle();
}

void Fold::showTitle() {
  heading_->setText(marked_ ? title_ + QStringLiteral(" •") : title_);
}

void Fold::setOpen(bool open) {
  if (open == open_)
    return;
  open_ = open;
  heading_->setChecked(open);
  heading_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  content_->setVisible(open);
}

} // namespace voluta::forms
