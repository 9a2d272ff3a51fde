// The pieces of planar mode as a tree in print order, with the measures of each; and controls for
// their display and for the source of the cuts.
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QSlider;
class QTreeWidget;
class QTreeWidgetItem;

namespace voluta::panels {

struct PieceRow {
  int parent = -1; // index of the piece that it is printed on; -1: the plate
  QColor colour;   // its display colour
  double volumeMm3 = 0.0, riskyMm2 = 0.0;
  QString material;
};

// Area that needs support while a cut is being moved, or why it cannot be computed.
struct CutEstimate {
  double riskyMm2 = 0.0;
  bool exact = false;
  QString problem; // empty: none
};

class PiecesPanel : public QWidget {
  Q_OBJECT

public:
  explicit PiecesPanel(QWidget* parent = nullptr);

  // In print order. `riskyBeforeMm2`: of the uncut part. Clears the selection; emits nothing.
  void setPieces(std::vector<PieceRow> pieces, double riskyBeforeMm2);
  // -1: none. Emits nothing.
  void select(int piece);
  int selected() const { return selected_; }
  // The cuts are the user's, not the search's.
  void setOwnCuts(bool own);
  // The selected piece's base plane has handles: shows how to use them.
  void setHandles(bool there);
  // Shown instead of the pieces' area until cleared.
  void setEstimate(const CutEstimate& estimate);
  void clearEstimate();
  // Whether the user may choose which region of the part is on the plate.
  void setRootOffered(bool offered);
  void setPickingRoot(bool picking);

  double explodeShare() const; // 0 to 1
  void setExplodeShare(double share);
  bool basePlanes() const;
  bool numbers() const;

signals:
  void selectionChanged(int piece);
  void viewChanged(); // explodeShare, basePlanes, numbers
  void dragging(bool on);
  void keepCutsRequested();
  void searchRequested();
  void rootPicking(bool on);

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  void fill();
  void retranslate();
  void showTotal();
  void showHint();

  std::vector<PieceRow> rows_;
  std::vector<QTreeWidgetItem*> items_;
  double before_ = 0.0;
  CutEstimate estimate_;
  bool estimated_ = false, own_ = false, filling_ = false, handles_ = false;
  int selected_ = -1;
  QTreeWidget* tree_;
  QLabel *total_, *explodeLabel_, *hint_;
  QSlider* explode_;
  QCheckBox *numbers_, *planes_;
  QPushButton *cuts_, *root_;
};

} // namespace voluta::panels
