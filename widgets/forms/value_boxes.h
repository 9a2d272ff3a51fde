// Spin boxes and combo boxes for forms: a value is committed by Enter, by leaving the field or by a
// step, never by a keystroke, and the wheel over a box without focus scrolls the area around it. A
// number beyond the range can be typed and becomes the nearest possible one. What a box does not
// take is said below it and in the status line.
#pragma once

#include <QDoubleSpinBox>

class QComboBox;
class QSpinBox;

namespace voluta::forms {

// Shows up to `decimals` digits, without trailing zeros.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

public:
  explicit NumberBox(QWidget* parent = nullptr);

  // Unit as in the tables ("mm", "deg", ""), shown after the number.
  void setUnit(const QString& unit);
  QString textFromValue(double value) const override;
  QValidator::State validate(QString& text, int& cursor) const override;
  void fixup(QString& text) const override;
};

// Gives a box the wheel behaviour described above for its lifetime.
void tameWheel(QWidget* box);

// Returns a suitable step for a typical value: a tenth of it or less, a power of ten.
double stepFor(double usualValue, double maximum);

// Returns a combo box that may be narrower than its longest entry, with tameWheel().
QComboBox* makeCombo(QWidget* parent);
// Returns a spin box without keyboard tracking, with tameWheel().
QSpinBox* makeIntegerBox(QWidget* parent);

} // namespace voluta::forms
