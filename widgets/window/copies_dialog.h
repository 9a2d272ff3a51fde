// Asks how often a part is printed on the plate.
#pragma once

#include <QDialog>
#include <cstddef>
#include <optional>

class QSpinBox;

namespace voluta::window {

class CopiesDialog : public QDialog {
  Q_OBJECT

public:
  // `present`: number of such parts on the plate. Deletes itself when closed.
  CopiesDialog(std::size_t present, QWidget* parent);

signals:
  // none: as many as the plate has room for.
  void chosen(std::optional<std::size_t> count);

private:
  void choose(std::optional<std::size_t> count);

  QSpinBox* count_;
};

} // namespace voluta::window
