// Spin boxes and combo boxes as the forms use them: a value is committed by Enter, by leaving the
// field or by a step, never by a keystroke, and the wheel over a box without focus scrolls what it
// lies in.
#pragma once

#include <QDoubleSpinBox>

class QComboBox;
class QSpinBox;

namespace voluta::forms {

// Up to `decimals` digits, without zeros at the end.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

public:
  explicit NumberBox(QWidget* parent = nullptr);

  // Unit as in the tables ("mm", "deg", ""): shown behind the number.
  void setUnit(const QString& unit);
  QString textFromValue(double value) const override;
};

// Gives a box the behaviour named above. The box keeps it for its life.
void tameWheel(QWidget* box);

// A step that suits a usual value: a tenth of it or less, a power of ten.
double stepFor(double usualValue, double maximum);

// A combo box that shrinks below its longest entry, tamed.
QComboBox* makeCombo(QWidget* parent);
// A spin box without keyboard tracking, tamed.
QSpinBox* makeIntegerBox(QWidget* parent);

} // namespace voluta::forms
