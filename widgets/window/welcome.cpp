#include "window/welcome.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
constexpr int kWidth = 360;
}

Welcome::Welcome(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), text_(new QLabel(this)),
      open_(new QPushButton(this)), sample_(new QPushButton(this)) {
  setObjectName("welcome");
  setFixedWidth(kWidth);
  QFont large = title_->font();
  large.setPointSizeF(1.5 * large.pointSizeF());
  title_->setFont(large);
  for (QLabel* label : {title_, text_}) {
    label->setAlignment(Qt::AlignCenter);
    label->setWordWrap(true);
  }
  open_->setObjectName("welcomeOpen");
  sample_->setObjectName("welcomeSample");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(24, 20, 24, 20);
  column->setSpacing(12);
  column->addWidget(title_);
  column->addWidget(text_);
  auto* row = new QHBoxLayout;
  row->addWidget(open_);
  row->addWidget(sample_);
  column->addLayout(row);
  connect(open_, &QPushButton::clicked, this, &Welcome::openRequested);
  connect(sample_, &QPushButton::clicked, this, &Welcome::sampleRequested);
  parent->installEventFilter(this);
  retranslate();
}

void Welcome::setMessage(const QString& message) {
  message_ = message;
  retranslate();
}

void Welcome::retranslate() {
  title_->setText(message_.isEmpty() ? tr("Print a part with a robot") : tr("No picture"));
  text_->setText(message_.isEmpty() ? tr("Drop a mesh (STL, OBJ, PLY, OFF or 3MF), a slicer's "
                                         "G-code or a Voluta project here.")
                                    : message_);
  open_->setText(tr("Open…"));
  sample_->setText(tr("Sample vase"));
  open_->setVisible(message_.isEmpty());
  sample_->setVisible(message_.isEmpty());
  keepToTheMiddle();
}

void Welcome::keepToTheMiddle() {
  adjustSize();
  move((parentWidget()->width() - width()) / 2, (parentWidget()->height() - height()) / 2);
}

void Welcome::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = palette().window().color();
  ground.setAlpha(235);
  painter.setBrush(ground);
  painter.setPen(palette().mid().color());
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8, 8);
}

void Welcome::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

bool Welcome::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Show)
    keepToTheMiddle();
  return QWidget::eventFilter(watched, event);
}

} // namespace voluta::window
