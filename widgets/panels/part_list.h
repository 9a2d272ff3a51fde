// The parts of a job: one of them is active; add, duplicate, remove, and the order of printing.
#pragma once

#include "layers/print_order.h"

#include <QString>
#include <QWidget>
#include <cstddef>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;
class QTreeWidget;

namespace voluta::panels {

struct ListedPart {
  QString name, strategy, size; // way: of building
};

class PartList : public QWidget {
  Q_OBJECT

public:
  explicit PartList(QWidget* parent = nullptr);

  // Emits nothing.
  void setParts(const std::vector<ListedPart>& parts, std::size_t active);
  void setPrintOrder(layers::PrintOrder order);
  void selectAll();
  // Indices in ascending order.
  std::vector<std::size_t> selection() const;

signals:
  void selected(std::size_t part);
  void addRequested();
  void duplicateRequested();
  void removeRequested();
  void arrangeRequested();
  void printOrderChosen(voluta::layers::PrintOrder order);

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  void retranslate();
  void fitHeight();

  QTreeWidget* rows_;
  QToolButton *add_, *duplicate_, *remove_, *arrange_;
  QLabel* orderLabel_;
  QComboBox* order_;
};

} // namespace voluta::panels
