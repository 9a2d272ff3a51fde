#include "panels/written_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace voluta::panels {

WrittenBar::WrittenBar(QWidget* parent)
    : QWidget(parent), text_(new QLabel(this)), openProof_(new QPushButton(this)),
      showFolder_(new QPushButton(this)) {
  text_->setObjectName(QStringLiteral("written"));
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  openProof_->setObjectName(QStringLiteral("openProof"));
  showFolder_->setObjectName(QStringLiteral("showFolder"));
  connect(openProof_, &QPushButton::clicked, this, &WrittenBar::openProofRequested);
  connect(showFolder_, &QPushButton::clicked, this, &WrittenBar::showFolderRequested);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->addWidget(openProof_);
  buttons->addWidget(showFolder_);
  buttons->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(text_);
  column->addLayout(buttons);
  retranslate();
  setWritten({}, false);
}

void WrittenBar::setWritten(const QString& text, bool hasProof) {
  text_->setText(text);
  openProof_->setVisible(hasProof);
  setVisible(!text.isEmpty());
}

void WrittenBar::retranslate() {
  openProof_->setText(tr("Open report"));
  openProof_->setToolTip(tr("The report to hand over: verdict, margins and hashes of the program"));
  showFolder_->setText(tr("Show folder"));
  showFolder_->setToolTip(tr("Opens the folder with the programs in the file manager"));
}

void WrittenBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
