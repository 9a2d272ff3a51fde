#include "forms/choice_combo.h"

#include "base/data_files.h"

#include <QAbstractItemView>
#include <QColor>
#include <QComboBox>
#include <QSignalBlocker>
#include <algorithm>

namespace voluta::forms {

namespace {
constexpr int kBesideLabel = 48; // [px] scroll bar, frame and picture
}

void fillCombo(QComboBox* combo, const std::vector<ChoiceItem>& items) {
  const QSignalBlocker quiet(combo);
  const QString chosen = combo->currentData().toString();
  combo->clear();
  for (const ChoiceItem& item : items) {
    combo->addItem(item.label.isEmpty() ? item.id : item.label, item.id);
    combo->setItemData(combo->count() - 1, item.help, Qt::ToolTipRole);
  }
  if (const int at = combo->findData(chosen); at >= 0)
    combo->setCurrentIndex(at);
  // The open list shows whole labels, also below a narrow box.
  int widest = 0;
  for (const ChoiceItem& item : items)
    widest = std::max(widest, combo->fontMetrics().horizontalAdvance(item.label));
  combo->view()->setMinimumWidth(widest + kBesideLabel);
}

void chooseId(QComboBox* combo, const QString& id, const QString& label) {
  const QSignalBlocker quiet(combo);
  int at = combo->findData(id);
  if (at < 0 && !id.isEmpty()) {
    combo->addItem(
        label.isEmpty() ? QString::fromStdString(base::dataName(id.toStdString())) : label, id);
    at = combo->count() - 1;
  }
  combo->setCurrentIndex(at);
}

QPixmap swatchOf(const QColor& colour, int sidePx) {
  QPixmap swatch(sidePx, sidePx);
  swatch.fill(colour);
  return swatch;
}

} // namespace voluta::forms
