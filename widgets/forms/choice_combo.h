// Boxes that offer choices by id.
#pragma once

#include <QPixmap>
#include <QString>
#include <vector>

class QComboBox;

namespace voluta::forms {

// One entry of a list: its id, its label, and its tool tip (may be empty).
struct ChoiceItem {
  QString id, label, help;
};

// Keeps the selection if the new list contains it. Emits nothing.
void fillCombo(QComboBox* combo, const std::vector<ChoiceItem>& items);
// Emits nothing. An id that is not in the list is added to it, with its label if that is known.
void chooseId(QComboBox* combo, const QString& id, const QString& label = {});

// A square of that colour.
QPixmap swatchOf(const QColor& colour, int sidePx);

} // namespace voluta::forms
