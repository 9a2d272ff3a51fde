// Two processes, or two materials, side by side: the fields that differ.
#pragma once

#include "process/library.h"

#include <QDialog>
#include <vector>

class QComboBox;
class QLabel;
class QTableWidget;

namespace voluta::window {

class CompareItemsDialog : public QDialog {
  Q_OBJECT

public:
  // Compares the items with these indices first. Preconditions: items of one shelf, valid indices.
  CompareItemsDialog(std::vector<process::LibraryItem> items, int first, int second,
                     QWidget* parent);

private:
  void show();

  std::vector<process::LibraryItem> items_;
  QComboBox *first_, *second_;
  QTableWidget* table_;
  QLabel* count_;
};

} // namespace voluta::window
