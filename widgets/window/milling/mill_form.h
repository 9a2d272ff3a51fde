// Form for cutter, block, passes and material of a milled part.
#pragma once

#include "pipeline/mill_part.h"

#include <QWidget>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace voluta::forms {
class NumberBox;
}

namespace voluta::window {

class MillForm : public QWidget {
  Q_OBJECT

public:
  explicit MillForm(QWidget* parent = nullptr);

  // Without the part's name.
  pipeline::MillOrder order() const;

signals:
  void changed();

private:
  void addNumbers(QFormLayout& form);
  void showRates();

  QComboBox* material_;
  QSpinBox* teeth_;
  QCheckBox* layDown_;
  QLabel* rates_;
  std::vector<forms::NumberBox*> numbers_; // in the order of their table
};

} // namespace voluta::window
