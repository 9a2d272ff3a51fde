#include "forms/value_boxes.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSpinBox>
#include <QStatusTipEvent>
#include <QTimer>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

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

// Returns the number that a text of the box states, whether it is a value of the box or not.
std::optional<double> numberIn(const QAbstractSpinBox& box, QString text, const QString& suffix) {
  if (!suffix.isEmpty() && text.endsWith(suffix))
    text.chop(suffix.size());
  bool isNumber = false;
  const double number = box.locale().toDouble(text.trimmed(), &isNumber);
  return isNumber ? std::optional(number) : std::nullopt;
}

// Numbers are shown without separators of thousands, so both signs are the decimal one.
void useDecimalPoint(const QAbstractSpinBox& box, QString& text) {
  const QString point = box.locale().decimalPoint();
  if (point == QLatin1String(".") || point == QLatin1String(","))
    text.replace(point == QLatin1String(".") ? ',' : '.', point.at(0));
}

// Qt refuses the keystroke that leaves the range: of 20 below a maximum of 1 only the 0 arrives.
template <class Box>
QValidator::State validated(const Box& box, const QString& text, QValidator::State byQt) {
  return byQt == QValidator::Invalid && numberIn(box, text, box.suffix()) ? QValidator::Intermediate
                                                                          : byQt;
}

template <class Box> QString textOf(const Box& box, double value) {
  return box.prefix() +
         box.textFromValue(static_cast<decltype(box.value())>(
             std::is_integral_v<decltype(box.value())> ? std::round(value) : value)) +
         box.suffix();
}

// A text without a number is no value: the box keeps its own.
template <class Box> void moveIntoRange(const Box& box, QString& text) {
  const auto number = numberIn(box, text, box.suffix());
  text = textOf(box, number ? std::clamp<double>(*number, box.minimum(), box.maximum())
                            : static_cast<double>(box.value()));
}

// Undo and redo are those of the text only while a number is being typed; otherwise they are those
// of the window.
template <class Box> class TextUndo : public QObject {
public:
  explicit TextUndo(Box* box) : QObject(box), box_(box) {}

  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::ShortcutOverride)
      return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if ((!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) ||
        (box_->text() != textOf(*box_, static_cast<double>(box_->value())) &&
         box_->text() != box_->specialValueText()))
      return false;
    event->ignore();
    return true;
  }

private:
  Box* box_;
};

void showHint(QWidget& box, const QString& text) {
  constexpr int kShownMs = 6000;
  QStatusTipEvent tip(text);
  QCoreApplication::sendEvent(&box, &tip);
  QToolTip::showText(box.mapToGlobal(QPoint(0, box.height())), text, &box, {}, kShownMs);
  QTimer::singleShot(kShownMs, &box, [&box] {
    QStatusTipEvent none{QString()};
    QCoreApplication::sendEvent(&box, &none);
  });
}

template <class Box> QString rangeText(const Box& box) {
  return QCoreApplication::translate("ValueBoxes", "%1 to %2")
      .arg(box.textFromValue(box.minimum()) + box.suffix(),
           box.textFromValue(box.maximum()) + box.suffix());
}

// Says which keys and numbers the box does not take.
template <class Box> void showRefused(Box* box, QLineEdit* line) {
  auto* undo = new TextUndo<Box>(box);
  box->installEventFilter(undo);
  line->installEventFilter(undo);
  QObject::connect(line, &QLineEdit::inputRejected, box, [box] {
    showHint(*box, QCoreApplication::translate(
                       "ValueBoxes", "This character is not possible here. Enter a number: %1.")
                       .arg(rangeText(*box)));
  });
  QObject::connect(line, &QLineEdit::textEdited, box,
                   [box](const QString& text) { box->setProperty("typed", text); });
  QObject::connect(box, &QAbstractSpinBox::editingFinished, box, [box] {
    const auto typed = numberIn(*box, box->property("typed").toString(), box->suffix());
    box->setProperty("typed", QVariant());
    constexpr double kSame = 1e-9;
    if (typed && std::abs(*typed - static_cast<double>(box->value())) >
                     kSame * std::max(1.0, std::abs(*typed)))
      showHint(*box, QCoreApplication::translate("ValueBoxes",
                                                 "%1 is not possible here: %2 is used. Range: %3.")
                         .arg(box->locale().toString(*typed),
                              box->textFromValue(box->value()) + box->suffix(), rangeText(*box)));
  });
}

class IntegerBox : public QSpinBox {
public:
  explicit IntegerBox(QWidget* parent) : QSpinBox(parent) { showRefused(this, lineEdit()); }

  QString textFromValue(int value) const override { return QSpinBox::textFromValue(value); }
  QValidator::State validate(QString& text, int& cursor) const override {
    useDecimalPoint(*this, text);
    if (text.contains(locale().decimalPoint())) // Qt would make 15 of 1.5
      return numberIn(*this, text, suffix()) ? QValidator::Intermediate : QValidator::Invalid;
    return validated(*this, text, QSpinBox::validate(text, cursor));
  }
  void fixup(QString& text) const override { moveIntoRange(*this, text); }
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
  showRefused(this, lineEdit());
}

QValidator::State NumberBox::validate(QString& text, int& cursor) const {
  useDecimalPoint(*this, text);
  return validated(*this, text, QDoubleSpinBox::validate(text, cursor));
}

void NumberBox::fixup(QString& text) const {
  moveIntoRange(*this, text);
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
  auto* box = new IntegerBox(parent);
  box->setKeyboardTracking(false);
  box->setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
  tameWheel(box);
  return box;
}

} // namespace voluta::forms
