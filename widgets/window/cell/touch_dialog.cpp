#include "window/cell/touch_dialog.h"

#include "base/error.h"
#include "forms/value_boxes.h"
#include "language/words.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
constexpr double kFarthestMm = 5000.0;
}

TouchedPoints touchedPoints(const QString& text) {
  TouchedPoints read;
  static const QRegularExpression kBetween(QStringLiteral("[\\s,;]+"));
  const QStringList lines = text.split(QChar('\n'));
  for (qsizetype i = 0; i < lines.size(); ++i) {
    const QStringList words = lines[i].split(kBetween, Qt::SkipEmptyParts);
    if (words.isEmpty())
      continue;
    std::vector<double> numbers;
    for (const QString& word : words) {
      bool ok = false;
      numbers.push_back(QLocale::c().toDouble(word, &ok));
      if (!ok || numbers.size() > 3) {
        numbers.clear();
        break;
      }
    }
    if (numbers.size() < 2) {
      read.error = TouchDialog::tr("Line %1 is not a point: write y and z, or x, y and z, in mm.")
                       .arg(i + 1);
      return read;
    }
    read.points.emplace_back(numbers[numbers.size() - 2], numbers.back());
  }
  return read;
}

TouchDialog::TouchDialog(const Eigen::Vector2d& modelCentre, QWidget* parent)
    : QDialog(parent), text_(new QPlainTextEdit(this)), found_(new QLabel(this)),
      modelY_(new forms::NumberBox(this)), modelZ_(new forms::NumberBox(this)),
      shift_(new QLabel(this)) {
  setObjectName("touchDialog");
  setWindowTitle(tr("Place on touched points"));
  auto* words = new QLabel(tr("Touch a cylinder along x at three points or more, and enter them in "
                              "the work frame: y z, or x y z, one point per line [mm]."),
                           this);
  words->setWordWrap(true);
  text_->setObjectName("touchPoints");
  text_->setAccessibleName(tr("Touched points"));
  text_->setPlaceholderText(QStringLiteral("-14.1 14.2\n0.05 20.1\n14.2 14.1"));
  text_->setTabChangesFocus(true);
  found_->setObjectName("touchFound");
  found_->setWordWrap(true);
  found_->setMinimumHeight(2 * fontMetrics().height());
  found_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  shift_->setObjectName("touchShift");
  shift_->setWordWrap(true);
  auto* centre = new QHBoxLayout;
  for (auto* box : {modelY_, modelZ_}) {
    box->setUnit(QStringLiteral("mm"));
    box->setRange(-kFarthestMm, kFarthestMm);
    centre->addWidget(box, 1);
    connect(box, &QDoubleSpinBox::valueChanged, this, &TouchDialog::fit);
  }
  modelY_->setObjectName("touchModelY");
  modelZ_->setObjectName("touchModelZ");
  modelY_->setAccessibleName(tr("y of the axis in the model"));
  modelZ_->setAccessibleName(tr("z of the axis in the model"));
  modelY_->setValue(modelCentre.x());
  modelZ_->setValue(modelCentre.y());
  auto* form = new QFormLayout;
  form->addRow(tr("Axis in the model (y, z)"), centre);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  apply_ = buttons->addButton(tr("Move the part"), QDialogButtonBox::AcceptRole);
  apply_->setObjectName("touchApply");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words);
  column->addWidget(text_, 1);
  column->addWidget(found_);
  column->addLayout(form);
  column->addWidget(shift_);
  column->addWidget(buttons);
  connect(text_, &QPlainTextEdit::textChanged, this, &TouchDialog::fit);
  resize(400, 420);
  fit();
}

Eigen::Vector2d TouchDialog::shiftMm() const {
  return circle_ ? Eigen::Vector2d(circle_->centre -
                                   Eigen::Vector2d(modelY_->value(), modelZ_->value()))
                 : Eigen::Vector2d::Zero();
}

void TouchDialog::fit() {
  const QLocale locale;
  const auto mm = [&](double value) { return locale.toString(value, 'f', 3); };
  circle_.reset();
  const TouchedPoints read = touchedPoints(text_->toPlainText());
  QString found = read.error;
  if (found.isEmpty() && !read.points.empty()) {
    try {
      circle_ = substrate::circleThrough(read.points);
      found = tr("Centre y %1, z %2 mm; radius %3 mm; points: %4, mean deviation %5 mm.")
                  .arg(mm(circle_->centre.x()), mm(circle_->centre.y()), mm(circle_->radiusMm))
                  .arg(read.points.size())
                  .arg(mm(circle_->rmsMm));
    } catch (const base::Error& error) {
      found = language::words(error.whole());
    }
  }
  found_->setText(found);
  const Eigen::Vector2d shift = shiftMm();
  shift_->setText(circle_
                      ? tr("The part is moved by y %1, z %2 mm.").arg(mm(shift.x()), mm(shift.y()))
                      : QString());
  apply_->setEnabled(circle_.has_value());
}

} // namespace voluta::window
