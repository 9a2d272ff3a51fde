// The sections of a head as a small table of height and radius.
#pragma once

#include "process/process.h"

#include <QWidget>

class QLabel;
class QTableWidget;
class QToolButton;

namespace voluta::panels {

class HeadTable : public QWidget {
  Q_OBJECT

public:
  explicit HeadTable(QWidget* parent = nullptr);

  // Emits nothing.
  void setHead(const process::HeadShape& head);
  // The head that the reset button restores; the button is shown while the head differs from it.
  void setReference(const process::HeadShape& head);
  void setReadOnly(bool readOnly);
  // The line below the table that explains why the head is invalid; empty: it is valid.
  void setProblem(const QString& problem);

signals:
  void headChanged(const voluta::process::HeadShape& head);

protected:
  void changeEvent(QEvent* event) override;

private:
  void take(process::HeadShape head);
  void fill();
  void edit(int row, int column);
  void addRow();
  void removeRow();
  void showButtons();
  void retranslate();

  process::HeadShape head_, reference_;
  bool readOnly_ = false;
  QTableWidget* table_;
  QToolButton *add_, *remove_, *reset_;
  QLabel *problemIcon_, *problem_;
};

} // namespace voluta::panels
