#include "window/library/head_numbers_dialog.h"

#include "base/error.h"
#include "forms/dialog_buttons.h"
#include "forms/icons.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "panels/head_drawing.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr double kMaxMm = 2000.0, kMaxDeg = 180.0;

struct NumberRow {
  const char *name, *label, *unit;
  double process::HeadNumbers::*value;
  double maximum;
};
constexpr NumberRow kRows[] = {
    {"headTip", QT_TRANSLATE_NOOP("HeadNumbersDialog", "Nozzle tip radius"), "mm",
     &process::HeadNumbers::tipRadiusMm, kMaxMm},
    {"headAngle", QT_TRANSLATE_NOOP("HeadNumbersDialog", "Cone angle"), "°",
     &process::HeadNumbers::coneAngleDeg, kMaxDeg},
    {"headCone", QT_TRANSLATE_NOOP("HeadNumbersDialog", "Cone height"), "mm",
     &process::HeadNumbers::coneHeightMm, kMaxMm},
    {"headWidth", QT_TRANSLATE_NOOP("HeadNumbersDialog", "Block width"), "mm",
     &process::HeadNumbers::blockWidthMm, kMaxMm},
    {"headHeight", QT_TRANSLATE_NOOP("HeadNumbersDialog", "Block height"), "mm",
     &process::HeadNumbers::blockHeightMm, kMaxMm}};
} // namespace

HeadNumbersDialog::HeadNumbersDialog(const process::Process& process, QWidget* parent)
    : QDialog(parent), process_(process), drawing_(new panels::HeadDrawing(this)),
      sign_(new QLabel(this)), problem_(new QLabel(this)) {
  setObjectName("headNumbers");
  setWindowTitle(tr("Head from a few numbers"));
  if (!process.head.sections.empty() && process.head.sections.front().radiusMm > 0.0)
    numbers_.tipRadiusMm = process.head.sections.front().radiusMm;
  auto* form = new QFormLayout;
  for (const NumberRow& row : kRows) {
    auto* box = new forms::NumberBox(this);
    box->setObjectName(row.name);
    box->setUnit(QString::fromUtf8(row.unit));
    box->setRange(0.0, row.maximum);
    box->setValue(numbers_.*row.value);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, at = row.value](double value) {
      numbers_.*at = value;
      evaluate();
    });
    form->addRow(QCoreApplication::translate("HeadNumbersDialog", row.label), box);
  }
  auto* note = new QLabel(tr("The head contains the corners of the square block."), this);
  note->setWordWrap(true);
  problem_->setObjectName("headNumbersProblem");
  problem_->setWordWrap(true);
  problem_->setMinimumHeight(2 * fontMetrics().height());
  problem_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* line = new QHBoxLayout;
  line->addWidget(sign_, 0, Qt::AlignTop);
  line->addWidget(problem_, 1);
  auto* left = new QVBoxLayout;
  left->addLayout(form);
  left->addWidget(note);
  left->addLayout(line);
  left->addStretch(1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  use_ = buttons->addButton(tr("Use this head"), QDialogButtonBox::AcceptRole);
  use_->setObjectName("headNumbersUse");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  forms::keepOpenOnEnter(*buttons);
  auto* row = new QHBoxLayout;
  row->addLayout(left, 1);
  row->addWidget(drawing_, 1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(buttons);
  resize(680, 320);
  evaluate();
}

void HeadNumbersDialog::evaluate() {
  try {
    head_ = process::headFromNumbers(numbers_);
    process_.head = *head_;
    drawing_->setProcess(process_);
    sign_->clear();
    problem_->clear();
  } catch (const base::Error& error) {
    head_.reset();
    sign_->setPixmap(forms::iconBeside(*this, forms::Icon::Blocked));
    problem_->setText(language::words(error.whole()));
  }
  use_->setEnabled(head_.has_value());
}

} // namespace voluta::window
