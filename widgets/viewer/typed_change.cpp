#include "viewer/typed_change.h"

#include "base/units.h"

#include <QKeyEvent>
#include <algorithm>

namespace voluta::viewer {

namespace {
constexpr qsizetype kMaxDigits = 12;
constexpr int kX = 0, kZ = 2;
constexpr double kMinPercent = 0.01, kMaxPercent = 1e6;

bool isEnter(int key) {
  return key == Qt::Key_Return || key == Qt::Key_Enter;
}

std::optional<int> axisOf(int key) {
  return key >= Qt::Key_X && key <= Qt::Key_Z ? std::optional(key - Qt::Key_X) : std::nullopt;
}

// Returns the character of a number that the key types; a comma is a decimal point.
QChar digitOf(const QKeyEvent& key) {
  const QChar typed = key.text().isEmpty() ? QChar() : key.text().front();
  if (typed == u',')
    return u'.';
  return typed.isDigit() || typed == u'.' || typed == u'-' ? typed : QChar();
}
} // namespace

bool TypedChange::takes(const QKeyEvent& key, Tool tool, bool dragging) const {
  if (tool != Tool::Move && tool != Tool::Rotate && tool != Tool::Scale)
    return false;
  if (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier))
    return false;
  if (axisOf(key.key()))
    return tool != Tool::Scale;
  if (!digitOf(key).isNull())
    return active_ || dragging || tool == Tool::Scale;
  return active_ &&
         (isEnter(key.key()) || key.key() == Qt::Key_Escape || key.key() == Qt::Key_Backspace);
}

void TypedChange::begin(std::optional<int> axis) {
  active_ = true;
  axis_ = axis;
  digits_.clear();
}

TypedChange::Step TypedChange::press(const QKeyEvent& key, Tool) {
  if (key.key() == Qt::Key_Escape)
    return Step::Cancelled;
  if (isEnter(key.key()))
    return number() ? Step::Done : Step::Cancelled;
  if (key.key() == Qt::Key_Backspace) {
    digits_.chop(1);
  } else if (const auto axis = axisOf(key.key())) {
    axis_ = axis;
  } else if (const QChar digit = digitOf(key); digit == u'-') {
    digits_ = digits_.startsWith(u'-') ? digits_.mid(1) : u'-' + digits_;
  } else if (digits_.size() < kMaxDigits && !(digit == u'.' && digits_.contains(u'.'))) {
    digits_ += digit;
  }
  return Step::Edited;
}

std::optional<double> TypedChange::number() const {
  bool ok = false;
  const double value = digits_.toDouble(&ok);
  return ok ? std::optional(value) : std::nullopt;
}

GizmoChange TypedChange::change(Tool tool, const Eigen::Matrix3d& axes) const {
  GizmoChange change;
  const int axis = axis_.value_or(tool == Tool::Rotate ? kZ : kX);
  const QString name(QChar(u'X' + axis)), digits = digits_.isEmpty() ? QString("_") : digits_;
  const std::optional<double> value = number();
  switch (tool) {
  case Tool::Move:
    change.moveMm = value.value_or(0.0) * axes.col(axis);
    change.text = tr("%1: %2 mm").arg(name, digits);
    break;
  case Tool::Rotate:
    change.rotation =
        Eigen::AngleAxisd(base::degreesToRadians(value.value_or(0.0)), axes.col(axis));
    change.text = QString::fromUtf8("%1: %2°").arg(name, digits);
    break;
  case Tool::Scale:
    if (value && *value > 0.0)
      change.scale = std::clamp(*value, kMinPercent, kMaxPercent) / 100.0;
    change.text = QStringLiteral("%1 %").arg(digits);
    break;
  default:
    break;
  }
  return change;
}

} // namespace voluta::viewer
