#include "window/milling/mill_form.h"

#include "forms/value_boxes.h"
#include "language/numbers.h"
#include "language/words.h"
#include "milling/cutting_data.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>
#include <array>

namespace voluta::window {

using milling::MillRule;

namespace {

struct NumberRow {
  const char *id, *label, *tip; // source texts of the context "MillForm"
  double& (*value)(MillRule&);
  double minimum, maximum, step;
  const char* atMinimum = nullptr; // shown instead of the least value
};

const std::array<NumberRow, 8> kNumbers{{
    {"millCutter", QT_TRANSLATE_NOOP("MillForm", "Cutter diameter"),
     QT_TRANSLATE_NOOP("MillForm", "The cutter has a round end"),
     [](MillRule& r) -> double& { return r.cutter.diameterMm; }, 0.2, 50.0, 0.5},
    {"millLine", QT_TRANSLATE_NOOP("MillForm", "Stepover"),
     QT_TRANSLATE_NOOP("MillForm", "0: side load of the material; less leaves lower ridges"),
     [](MillRule& r) -> double& { return r.lineMm; }, 0.0, 50.0, 0.1,
     QT_TRANSLATE_NOOP("MillForm", "by material")},
    {"millRoughing", QT_TRANSLATE_NOOP("MillForm", "Roughing depth"),
     QT_TRANSLATE_NOOP("MillForm", "Depth of one pass that stays above the part"),
     [](MillRule& r) -> double& { return r.roughingMm; }, 0.1, 50.0, 0.5},
    {"millAcross", QT_TRANSLATE_NOOP("MillForm", "Stock beyond the part, y"),
     QT_TRANSLATE_NOOP("MillForm", "Across the lines; more than the cutter's diameter"),
     [](MillRule& r) -> double& { return r.acrossMm; }, 0.2, 200.0, 1.0},
    {"millAlong", QT_TRANSLATE_NOOP("MillForm", "Stock beyond the part, x"),
     QT_TRANSLATE_NOOP("MillForm", "Along the lines, with the ends that hold the block; more than "
                                   "the cutter's diameter"),
     [](MillRule& r) -> double& { return r.alongMm; }, 0.2, 200.0, 1.0},
    {"millSkin", QT_TRANSLATE_NOOP("MillForm", "Stock above and below"),
     QT_TRANSLATE_NOOP("MillForm", "Thickness that is milled away over the whole part"),
     [](MillRule& r) -> double& { return r.skinMm; }, 0.0, 100.0, 0.5},
    {"millClearance", QT_TRANSLATE_NOOP("MillForm", "Clearance"),
     QT_TRANSLATE_NOOP("MillForm", "Height of rapid moves above the block"),
     [](MillRule& r) -> double& { return r.clearanceMm; }, 0.1, 100.0, 0.5},
    {"millStrip", QT_TRANSLATE_NOOP("MillForm", "Holding tab"),
     QT_TRANSLATE_NOOP("MillForm", "Of the contour, at the part's lower end along y; cut by hand"),
     [](MillRule& r) -> double& { return r.stripMm; }, 0.0, 100.0, 0.5},
}};

QString text(const char* source) {
  return QCoreApplication::translate("MillForm", source);
}

} // namespace

MillForm::MillForm(QWidget* parent)
    : QWidget(parent), material_(forms::makeCombo(this)), teeth_(forms::makeIntegerBox(this)),
      layDown_(new QCheckBox(tr("Lay the part down"), this)), rates_(new QLabel(this)) {
  material_->setObjectName("millMaterial");
  for (const milling::CuttingData& row : milling::cuttingData())
    material_->addItem(language::heading(row.label),
                       QString::fromUtf8(row.id.data(), static_cast<qsizetype>(row.id.size())));
  teeth_->setObjectName("millTeeth");
  teeth_->setRange(1, 12);
  layDown_->setObjectName("millLayDown");
  layDown_->setChecked(true);
  layDown_->setToolTip(tr("Turns the part so that the least material is milled away; otherwise it "
                          "keeps its orientation on the plate"));
  rates_->setObjectName("millRates");
  rates_->setWordWrap(true);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Material"), material_);
  form->addRow(tr("Teeth"), teeth_);
  addNumbers(*form);
  form->addRow(layDown_);
  form->addRow(rates_);
  const auto change = [this] {
    showRates();
    emit changed();
  };
  connect(material_, &QComboBox::currentIndexChanged, this, change);
  connect(teeth_, &QSpinBox::valueChanged, this, change);
  connect(layDown_, &QCheckBox::toggled, this, change);
  for (forms::NumberBox* box : numbers_)
    connect(box, &QDoubleSpinBox::valueChanged, this, change);
  showRates();
}

void MillForm::addNumbers(QFormLayout& form) {
  MillRule rule;
  for (const NumberRow& row : kNumbers) {
    auto* box = new forms::NumberBox(this);
    box->setObjectName(row.id);
    box->setUnit(QStringLiteral("mm"));
    box->setDecimals(3);
    box->setRange(row.minimum, row.maximum);
    box->setSingleStep(row.step);
    if (row.atMinimum)
      box->setSpecialValueText(text(row.atMinimum));
    box->setValue(row.value(rule));
    box->setToolTip(text(row.tip));
    form.addRow(text(row.label), box);
    numbers_.push_back(box);
  }
}

pipeline::MillOrder MillForm::order() const {
  pipeline::MillOrder order;
  order.layDown = layDown_->isChecked();
  MillRule& rule = order.rule;
  rule.data = milling::cuttingData()[static_cast<std::size_t>(material_->currentIndex())];
  rule.cutter.teeth = teeth_->value();
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    kNumbers[i].value(rule) = numbers_[i]->value();
  return order;
}

void MillForm::showRates() {
  const MillRule rule = order().rule;
  rates_->setText(tr("%1 rpm, feed %2 mm/min, lines every %3 mm, fine passes of %4 mm")
                      .arg(language::numberText(rule.data.rpm, 5),
                           language::numberText(milling::feedMmPerMin(rule.cutter, rule.data), 5),
                           language::numberText(rule.distanceMm(), 3),
                           language::numberText(milling::finePassMm(rule.cutter, rule.data), 3)));
}

} // namespace voluta::window
