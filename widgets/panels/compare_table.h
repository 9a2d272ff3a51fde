// Ways of building side by side: a row each, with its picture, its figures and its place.
#pragma once

#include <QImage>
#include <QString>
#include <QTableView>
#include <optional>
#include <vector>

namespace voluta::panels {

enum class CompareState { Waiting, Running, Clear, Blocked, Failed };

struct CompareEntry {
  QString way;              // "Curved layers"
  QString growth, platform; // growth: empty where it means nothing to the mode
  CompareState state = CompareState::Waiting;
  QString verdict; // in a few words
  QString tip;     // the whole reason
  int place = 0;   // 1: the best; 0: none yet
  std::optional<double> score;
  bool best = false;  // or as good as the best
  bool inUse = false; // the document's own way
  QImage picture;
  std::vector<QString> figures; // as many as there are columns
};

class CompareTable : public QTableView {
  Q_OBJECT

public:
  explicit CompareTable(QWidget* parent = nullptr);

  // Heads of the figures' columns, a line break in them where they may be broken.
  void setFigures(const std::vector<QString>& heads);
  void setEntries(std::vector<CompareEntry> entries);
  const std::vector<CompareEntry>& entries() const;
  void setEntry(int row, const CompareEntry& entry);
  // The same rows with other contents: what is selected stays so.
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
