// Comparison of ways of building: one row each, with its picture, figures and rank.
#pragma once

#include <QImage>
#include <QString>
#include <QTableView>
#include <optional>
#include <vector>

namespace voluta::panels {

enum class CompareState { Waiting, Running, Clear, Blocked, Failed };

struct CompareEntry {
  QString strategy;         // "Curved layers"
  QString growth, platform; // growth: empty if the mode does not use it
  CompareState state = CompareState::Waiting;
  QString verdict; // in a few words
  QString tip;     // the full reason
  int place = 0;   // 1: the best; 0: none yet
  std::optional<double> score;
  bool best = false;  // or tied with the best
  bool inUse = false; // the document's own way
  QImage picture;
  std::vector<QString> figures; // one per column
};

class CompareTable : public QTableView {
  Q_OBJECT

public:
  explicit CompareTable(QWidget* parent = nullptr);

  // Headers of the figures' columns, with line breaks where they may be wrapped.
  void setFigures(const std::vector<QString>& heads);
  void setEntries(std::vector<CompareEntry> entries);
  const std::vector<CompareEntry>& entries() const;
  void setEntry(int row, const CompareEntry& entry);
  // Updates the contents of the same rows; keeps the selection.
  void updateEntries(std::vector<CompareEntry> entries);
  // -1: none.
  int selectedRow() const;

signals:
  void rowSelected(int row);  // -1: none
  void rowActivated(int row); // double click or Return

protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  class Model;
  void layColumns();

  Model* model_;
};

} // namespace voluta::panels
