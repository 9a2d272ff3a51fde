#include "forms/value_boxes.h"

#include <QComboBox>
#include <QEvent>
#include <QSpinBox>
#include <cmath>

namespace voluta::forms {

namespace {
// Passes wheel events over a box without focus to the surrounding scroll area.
class WheelTamer : public QObject {
public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus())
      return false;
    event->ignore();
    return true;
  }
};
} // namespace

void tameWheel(QWidget* box) {
  box->setFocusPolicy(Qt::StrongFocus);
  box->installEventFilter(new WheelTamer(box));
}

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setDecimals(4);
  setKeyboardTracking(false);
  setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
  tameWheel(this);
}

void NumberBox::setUnit(const QString& unit) {
  if (unit.isEmpty())
    setSuffix({});
  else
    setSuffix(unit.startsWith(QChar(0x00b0)) ? unit : QChar(0x00a0) + unit);
}

QString NumberBox::textFromValue(double value) const {
  QString text = QDoubleSpinBox::textFromValue(value);
  const QString point = locale().decimalPoint();
  if (!text.contains(point))
    return text;
  while (text.endsWith(QLatin1Char('0')))
    text.chop(1);
  if (text.endsWith(point))
    text.chop(point.size());
  return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

double stepFor(double usualValue, double maximum) {
  const double scale = std::abs(usualValue) > 0.0 ? std::abs(usualValue) / 4.0 : maximum / 100.0;
  return scale > 0.0 ? std::pow(10.0, std::floor(std::log10(scale))) : 1.0;
}

QComboBox* makeCombo(QWidget* parent) {
  auto* combo = new QComboBox(parent);
  combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  combo->setMinimumContentsLength(6);
  combo->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  tameWheel(combo);
  return combo;
}

QSpinBox* makeIntegerBox(QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setKeyboardTracking(false);
  box->setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
  tameWheel(box);
  return box;
}

} // namespace voluta::forms
