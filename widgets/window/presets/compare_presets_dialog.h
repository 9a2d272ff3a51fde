// The settings in which two presets differ, or a preset and the present settings.
#pragma once

#include "pipeline/presets/print_preset.h"

#include <QDialog>
#include <QString>
#include <vector>

class QComboBox;
class QLabel;
class QTableWidget;

namespace voluta::window {

struct ComparedSettings {
  QString label;
  pipeline::Settings settings; // with those of parents
};

class ComparePresetsDialog : public QDialog {
  Q_OBJECT

public:
  // `defaults`: values of settings that are not stated. `first`, `second`: indices of the columns.
  ComparePresetsDialog(std::vector<ComparedSettings> compared, base::ParameterTable defaults,
                       int first, int second, QWidget* parent);

private:
  void compare();

  std::vector<ComparedSettings> compared_;
  base::ParameterTable defaults_;
  QComboBox *first_, *second_;
  QTableWidget* table_;
  QLabel* count_;
};

} // namespace voluta::window
