// Large buttons for the part at the left edge of the view, in as many columns as its height needs.
#pragma once

#include <QWidget>
#include <vector>

class QAction;
class QToolButton;

namespace voluta::window {

class ViewTools : public QWidget {
  Q_OBJECT

public:
  // `parent`: the view. Hidden at first.
  explicit ViewTools(QWidget* parent);

  // Each group stands apart from the next.
  void setGroups(const std::vector<std::vector<QAction*>>& groups);
  // Null: no such button.
  QToolButton* button(const QAction* action) const;

signals:
  void fitted();

protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void fit();
  // Returns the edge of the buttons with which all are in one column, if they are not too small.
  int edgeFor(int room) const;

  std::vector<std::vector<QToolButton*>> groups_;
};

} // namespace voluta::window
