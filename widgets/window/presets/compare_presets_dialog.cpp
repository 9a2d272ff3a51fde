#include "window/presets/compare_presets_dialog.h"

#include "forms/value_boxes.h"
#include "language/parameter_texts.h"
#include "language/words.h"
#include "pipeline/presets/chosen_preset.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
constexpr int kWidth = 720, kHeight = 420; // [px]
} // namespace

ComparePresetsDialog::ComparePresetsDialog(std::vector<ComparedSettings> compared,
                                           base::ParameterTable defaults, int first, int second,
                                           QWidget* parent)
    : QDialog(parent), compared_(std::move(compared)), defaults_(std::move(defaults)),
      first_(forms::makeCombo(this)), second_(forms::makeCombo(this)),
      table_(new QTableWidget(0, 3, this)), count_(new QLabel(this)) {
  setObjectName("comparePresetsDialog");
  setWindowTitle(tr("Compare presets"));
  first_->setObjectName("presetFirst");
  first_->setAccessibleName(tr("First preset"));
  second_->setObjectName("presetSecond");
  second_->setAccessibleName(tr("Second preset"));
  table_->setObjectName("presetDifferences");
  table_->setAccessibleName(tr("Settings that differ"));
  count_->setObjectName("presetDifferenceCount");
  auto* both = new QHBoxLayout;
  for (QComboBox* combo : {first_, second_}) {
    for (const ComparedSettings& one : compared_)
      combo->addItem(one.label);
    combo->setCurrentIndex(combo == first_ ? first : second);
    both->addWidget(combo);
    connect(combo, &QComboBox::currentIndexChanged, this, &ComparePresetsDialog::compare);
  }
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->verticalHeader()->hide();
  table_->setWordWrap(true);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addLayout(both);
  column->addWidget(count_);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
  resize(kWidth, kHeight);
  compare();
}

void ComparePresetsDialog::compare() {
  const ComparedSettings& a = compared_[static_cast<std::size_t>(first_->currentIndex())];
  const ComparedSettings& b = compared_[static_cast<std::size_t>(second_->currentIndex())];
  const auto found = pipeline::settingDifferences(a.settings, b.settings, defaults_);
  table_->setHorizontalHeaderLabels({tr("Setting"), a.label, b.label});
  table_->setRowCount(static_cast<int>(found.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const pipeline::SettingDifference& one = found[static_cast<std::size_t>(row)];
    const QString texts[] = {language::heading(one.spec.label),
                             language::valueText(one.spec, one.first),
                             language::valueText(one.spec, one.second)};
    for (int at = 0; at < table_->columnCount(); ++at) {
      auto* cell = new QTableWidgetItem(texts[at]);
      cell->setToolTip(texts[at]);
      table_->setItem(row, at, cell);
    }
  }
  table_->resizeRowsToContents();
  count_->setText(found.empty() ? tr("No differences.")
                                : tr("Settings that differ: %1").arg(found.size()));
}

} // namespace voluta::window
