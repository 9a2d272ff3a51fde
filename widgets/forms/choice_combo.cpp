#include "forms/choice_combo.h"

#include "base/data_files.h"

#include <QColor>
#include <QComboBox>
#include <QSignalBlocker>

namespace voluta::forms {

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
}

void chooseId(QComboBox* combo, const QString& id) {
  const QSignalBlocker quiet(combo);
  int at = combo->findData(id);
  if (at < 0 && !id.isEmpty()) {
    combo->addItem(QString::fromStdString(base::dataName(id.toStdString())), id);
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
