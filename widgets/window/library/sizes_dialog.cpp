#include "window/library/sizes_dialog.h"

#include "base/error.h"
#include "forms/dialog_buttons.h"
#include "forms/icons.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "project/accuracy_plate.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
using process::SizeKind;
using project::AccuracyPlate;

struct SizeRow {
  const char *name, *label;
  SizeKind kind;
  char axis;
  double AccuracyPlate::*nominal;
};
constexpr SizeRow kRows[] = {{"sizeLength", QT_TRANSLATE_NOOP("SizesDialog", "Length"),
                              SizeKind::Length, 'x', &AccuracyPlate::lengthMm},
                             {"sizeWidth", QT_TRANSLATE_NOOP("SizesDialog", "Width"),
                              SizeKind::Length, 'y', &AccuracyPlate::widthMm},
                             {"sizeSlotLength", QT_TRANSLATE_NOOP("SizesDialog", "Slot length"),
                              SizeKind::Slot, 'x', &AccuracyPlate::slotLengthMm},
                             {"sizeSlotWidth", QT_TRANSLATE_NOOP("SizesDialog", "Slot width"),
                              SizeKind::Slot, 'y', &AccuracyPlate::slotWidthMm},
                             {"sizeHole", QT_TRANSLATE_NOOP("SizesDialog", "Hole diameter"),
                              SizeKind::Hole, 'x', &AccuracyPlate::holeDiameterMm}};
constexpr double kLengthsMm[] = {50.0, 100.0, 210.0, 260.0, 310.0, 360.0};

QString mm(double length) {
  return QLocale().toString(length, 'g', 6) + QStringLiteral(" mm");
}
} // namespace

SizesDialog::SizesDialog(const process::Process& process, QWidget* parent)
    : QDialog(parent), process_(process), plate_(forms::makeCombo(this)), sign_(new QLabel(this)),
      found_(new QLabel(this)) {
  setObjectName("sizes");
  setWindowTitle(tr("Sizes from a measured plate"));
  plate_->setObjectName("sizesPlate");
  for (const double length : kLengthsMm)
    plate_->addItem(tr("Plate of %1").arg(mm(length)), length);
  auto* note = new QLabel(
      tr("Print the sample plate (File > Samples) with this process, and measure it."), this);
  note->setWordWrap(true);
  auto* grid = new QGridLayout;
  grid->addWidget(new QLabel(tr("Nominal"), this), 0, 1);
  grid->addWidget(new QLabel(tr("Measured"), this), 0, 2);
  for (const SizeRow& row : kRows) {
    auto* box = new forms::NumberBox(this);
    box->setObjectName(row.name);
    box->setUnit(QStringLiteral("mm"));
    box->setDecimals(3);
    box->setRange(0.001, 1000.0);
    connect(box, &QDoubleSpinBox::valueChanged, this, &SizesDialog::evaluate);
    auto* label = new QLabel(QCoreApplication::translate("SizesDialog", row.label), this);
    label->setBuddy(box);
    const auto line = static_cast<int>(measured_.size()) + 1;
    nominal_.push_back(new QLabel(this));
    measured_.push_back(box);
    grid->addWidget(label, line, 0);
    grid->addWidget(nominal_.back(), line, 1);
    grid->addWidget(box, line, 2);
  }
  found_->setObjectName("sizesFound");
  found_->setWordWrap(true);
  found_->setMinimumHeight(4 * fontMetrics().height());
  found_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* line = new QHBoxLayout;
  line->addWidget(sign_, 0, Qt::AlignTop);
  line->addWidget(found_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  use_ = buttons->addButton(tr("Use these sizes"), QDialogButtonBox::AcceptRole);
  use_->setObjectName("sizesUse");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  forms::keepOpenOnEnter(*buttons);
  auto* column = new QVBoxLayout(this);
  column->addWidget(note);
  column->addWidget(plate_);
  column->addLayout(grid);
  column->addLayout(line);
  column->addStretch(1);
  column->addWidget(buttons);
  connect(plate_, &QComboBox::currentIndexChanged, this, &SizesDialog::choosePlate);
  choosePlate();
}

void SizesDialog::choosePlate() {
  const AccuracyPlate plate = project::accuracyPlate(plate_->currentData().toDouble());
  sizes_.clear();
  for (std::size_t i = 0; i < measured_.size(); ++i) {
    const SizeRow& row = kRows[i];
    const double nominal = plate.*row.nominal;
    sizes_.push_back({row.kind, row.axis, nominal, nominal});
    nominal_[i]->setText(mm(nominal));
    const QSignalBlocker quiet(measured_[i]);
    measured_[i]->setValue(nominal);
  }
  evaluate();
}

void SizesDialog::evaluate() {
  for (std::size_t i = 0; i < sizes_.size(); ++i)
    sizes_[i].measuredMm = measured_[i]->value();
  try {
    const process::SizeFit fit = process::fitSizes(sizes_, process_);
    corrected_ = fit.process;
    sign_->clear();
    const QLocale locale;
    found_->setText(tr("Size factors %1 (x) and %2 (y), outlines %3, holes %4; the measured sizes "
                       "fit within %5.")
                        .arg(locale.toString(fit.process.scaleX, 'f', 5),
                             locale.toString(fit.process.scaleY, 'f', 5),
                             mm(fit.process.outlineOffsetMm), mm(fit.process.holeOffsetMm),
                             mm(fit.residualMm < 5e-4 ? 0.0 : fit.residualMm)));
  } catch (const base::Error& error) {
    corrected_.reset();
    sign_->setPixmap(forms::iconBeside(*this, forms::Icon::Blocked));
    found_->setText(language::words(error.whole()));
  }
  use_->setEnabled(corrected_.has_value());
}

} // namespace voluta::window
