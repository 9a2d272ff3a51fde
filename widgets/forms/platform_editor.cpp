#include "forms/platform_editor.h"

#include "forms/value_boxes.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace voluta::forms {

namespace {
constexpr double kLargestMm = 5000.0;

QString numberText(double value) {
  return QString::number(value, 'g', 10);
}
} // namespace

PlatformEditor::PlatformEditor(QWidget* parent) : QWidget(parent) {
  kind_ = makeCombo(this);
  kind_->setObjectName(QStringLiteral("kind"));
  for (const char* kind : {"fit", "disc", "rect"})
    kind_->addItem(QString(), QLatin1String(kind));
  const auto box = [this](const char* name) {
    auto* made = new NumberBox(this);
    made->setObjectName(QLatin1String(name));
    made->setUnit(QStringLiteral("mm"));
    made->setRange(0.0, kLargestMm);
    made->setMinimumWidth(fontMetrics().averageCharWidth() * 9);
    connect(made, &QDoubleSpinBox::valueChanged, this, &PlatformEditor::commit);
    return made;
  };
  first_ = box("first");
  second_ = box("second");
  times_ = new QLabel(QStringLiteral("×"), this);

  auto* sizes = new QHBoxLayout;
  sizes->setSpacing(4);
  sizes->addWidget(first_, 1);
  sizes->addWidget(times_);
  sizes->addWidget(second_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(kind_);
  column->addLayout(sizes);

  connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
    const bool fit = kind_->currentData().toString() == QLatin1String("fit");
    const QSignalBlocker quietFirst(first_), quietSecond(second_);
    first_->setValue(fit ? 0.0 : 200.0);
    second_->setValue(200.0);
    showKind();
    commit();
  });
  retranslate();
  showKind();
}

void PlatformEditor::setText(const QString& text) {
  const QString kind = text.section(QChar(':'), 0, 0);
  const QString size = text.section(QChar(':'), 1);
  const int at = kind_->findData(kind);
  bool firstOk = false, secondOk = true;
  double first = 0.0, second = 0.0;
  if (kind == QLatin1String("rect")) {
    first = size.section(QChar('x'), 0, 0).toDouble(&firstOk);
    second = size.section(QChar('x'), 1).toDouble(&secondOk);
  } else {
    first = size.toDouble(&firstOk);
    firstOk = firstOk || (kind == QLatin1String("fit") && size.isEmpty());
  }
  if (at < 0 || !firstOk || !secondOk)
    return;
  const QSignalBlocker quietKind(kind_), quietFirst(first_), quietSecond(second_);
  kind_->setCurrentIndex(at);
  showKind();
  first_->setValue(first);
  second_->setValue(second);
}

QString PlatformEditor::text() const {
  const QString kind = kind_->currentData().toString();
  QString text = kind + QChar(':') + numberText(first_->value());
  if (kind == QLatin1String("rect"))
    text += QChar('x') + numberText(second_->value());
  return text;
}

void PlatformEditor::showKind() {
  const QString kind = kind_->currentData().toString();
  const bool rect = kind == QLatin1String("rect");
  const QSignalBlocker quiet(first_), quietSecond(second_);
  const double least = kind == QLatin1String("fit") ? 0.0 : 1.0;
  first_->setMinimum(least);
  second_->setMinimum(1.0);
  times_->setVisible(rect);
  second_->setVisible(rect);
  const QString name = kind == QLatin1String("fit") ? tr("Margin around what stands on the plate")
                       : kind == QLatin1String("disc") ? tr("Diameter")
                                                       : tr("Width (X)");
  first_->setToolTip(name);
  first_->setAccessibleName(name);
  second_->setToolTip(tr("Depth (Y)"));
  second_->setAccessibleName(tr("Depth (Y)"));
}

void PlatformEditor::commit() {
  emit changed(text());
}

void PlatformEditor::retranslate() {
  kind_->setItemText(0, tr("Contact area, margin"));
  kind_->setItemText(1, tr("Disc, diameter"));
  kind_->setItemText(2, tr("Rectangle"));
  showKind();
}

void PlatformEditor::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::forms
