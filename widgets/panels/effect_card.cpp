#include "panels/effect_card.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

namespace voluta::panels {

EffectCard::EffectCard(QWidget* parent)
    : QFrame(parent), sign_(new QLabel(this)), title_(new QLabel(this)), lines_(new QLabel(this)),
      undo_(new QToolButton(this)), close_(new QToolButton(this)) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  title_->setObjectName(QStringLiteral("effectTitle"));
  lines_->setObjectName(QStringLiteral("effectLines"));
  for (QLabel* label : {title_, lines_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  undo_->setObjectName(QStringLiteral("effectUndo"));
  close_->setObjectName(QStringLiteral("effectClose"));
  close_->setText(QStringLiteral("✕"));
  close_->setAutoRaise(true);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(6, 4, 6, 4);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  grid->addWidget(sign_, 0, 0, Qt::AlignTop);
  grid->addWidget(title_, 0, 1);
  grid->addWidget(undo_, 0, 2, Qt::AlignTop);
  grid->addWidget(close_, 0, 3, Qt::AlignTop);
  grid->addWidget(lines_, 1, 1, 1, 3);
  connect(undo_, &QToolButton::clicked, this, &EffectCard::undoWished);
  connect(close_, &QToolButton::clicked, this, &EffectCard::closed);
  retranslate();
  hide();
}

void EffectCard::setEffect(const Effect& effect) {
  sign_->setPixmap(forms::iconBeside(*this, effect.sign));
  title_->setText(effect.title);
  lines_->setText(effect.lines.join(QLatin1Char('\n')));
  show();
}

void EffectCard::retranslate() {
  undo_->setText(tr("Undo"));
  undo_->setToolTip(tr("Takes the remedy back, and shows the plan before it"));
  close_->setToolTip(tr("Hide this"));
  close_->setAccessibleName(close_->toolTip());
}

void EffectCard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    emit languageChanged();
  }
  QFrame::changeEvent(event);
}

} // namespace voluta::panels
