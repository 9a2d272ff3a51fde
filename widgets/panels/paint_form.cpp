#include "panels/paint_form.h"

#include "forms/value_boxes.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace voluta::panels {

PaintForm::PaintForm(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  grid->setColumnStretch(1, 1);
  with_ = forms::makeCombo(this);
  with_->setObjectName(QStringLiteral("regionPaintWith"));
  with_->addItems({{}, {}, {}});
  withLabel_ = new QLabel(this);
  withLabel_->setBuddy(with_);
  size_ = new forms::NumberBox(this);
  size_->setObjectName(QStringLiteral("regionPaintSize"));
  sizeLabel_ = new QLabel(this);
  sizeLabel_->setBuddy(size_);
  hint_ = new QLabel(this);
  hint_->setWordWrap(true);
  grid->addWidget(withLabel_, 0, 0);
  grid->addWidget(with_, 0, 1);
  grid->addWidget(sizeLabel_, 1, 0);
  grid->addWidget(size_, 1, 1);
  grows_ = new QCheckBox(this);
  grows_->setObjectName(QStringLiteral("regionPaintGrows"));
  grows_->setChecked(choices_.growsLayers);
  grid->addWidget(grows_, 2, 0, 1, 2);
  grid->addWidget(hint_, 3, 0, 1, 2);
  connect(grows_, &QCheckBox::toggled, this, [this](bool on) { choices_.growsLayers = on; });
  connect(with_, &QComboBox::activated, this, [this](int with) {
    choices_.with = static_cast<PaintChoices::With>(with);
    showChoices();
    emit changed();
  });
  connect(size_, &QDoubleSpinBox::valueChanged, this, [this](double size) {
    (choices_.with == PaintChoices::With::Faces ? choices_.angleDeg : choices_.radiusMm) = size;
  });
  showChoices();
}

void PaintForm::setHasLayers(bool has) {
  grows_->setVisible(has);
}

void PaintForm::showChoices() {
  const bool faces = choices_.with == PaintChoices::With::Faces;
  const bool rectangle = choices_.with == PaintChoices::With::Rectangle;
  withLabel_->setText(tr("Paint with"));
  grows_->setText(tr("Layers while the brush rests"));
  grows_->setToolTip(tr("One second after a stroke, the layers are made again in the background"));
  with_->setItemText(0, tr("Brush"));
  with_->setItemText(1, tr("Whole faces"));
  with_->setItemText(2, tr("Rectangle"));
  with_->setCurrentIndex(static_cast<int>(choices_.with));
  sizeLabel_->setVisible(!rectangle);
  size_->setVisible(!rectangle);
  const QString label = faces ? tr("Up to edges of") : tr("Radius");
  sizeLabel_->setText(label);
  const QSignalBlocker quiet(size_);
  size_->setAccessibleName(label);
  size_->setUnit(faces ? QStringLiteral("°") : QStringLiteral("mm"));
  size_->setRange(faces ? 0.0 : 0.1, faces ? 180.0 : 100.0);
  size_->setValue(faces ? choices_.angleDeg : choices_.radiusMm);
  hint_->setText(rectangle
                     ? tr("Drag a rectangle: it paints what you see in it. Shift or the right "
                          "button erases.")
                     : tr("Paint on the part. Shift or the right button erases."));
}

void PaintForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    showChoices();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
