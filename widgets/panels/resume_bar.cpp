#include "panels/resume_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace voluta::panels {

ResumeBar::ResumeBar(QWidget* parent)
    : QWidget(parent), place_(new QLabel(this)), button_(new QPushButton(this)) {
  place_->setObjectName(QStringLiteral("resumePlace"));
  place_->setTextFormat(Qt::PlainText);
  place_->setWordWrap(true);
  button_->setObjectName(QStringLiteral("resume"));
  connect(button_, &QPushButton::clicked, this, &ResumeBar::asked);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(place_, 1);
  row->addWidget(button_);
  setPlace({});
  retranslate();
}

void ResumeBar::setPlace(const QString& place) {
  place_->setText(place);
  button_->setEnabled(!place.isEmpty());
}

void ResumeBar::retranslate() {
  button_->setText(tr("Resume from here…"));
  button_->setToolTip(tr("Opens the rest of a print that was stopped there as a new project"));
}

void ResumeBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
