// The legend over the viewport: title, unit, a scale or a list of categories, which may have
// figures beside them; then a click on a category hides or shows it.
#pragma once

#include "scene/colouring.h"
#include "window/legend_figures.h"

#include <QWidget>
#include <vector>

class QPainter;

namespace voluta::window {

class LegendView : public QWidget {
  Q_OBJECT

public:
  explicit LegendView(QWidget* parent = nullptr);
  // Hidden while it has neither entries nor marks.
  void setLegend(const scene::Legend& legend, const LegendFigures& figures = {});
  // Hidden if the user has switched it off.
  void setWanted(bool wanted);
  bool isWanted() const { return wanted_; }
  QSize sizeHint() const override;
  // The row of the entry with that value; empty: there is none.
  QRect rowOf(int value) const;
  const LegendFigures& figures() const { return figures_; }
  const scene::Legend& legend() const { return legend_; }

signals:
  void entryClicked(int value);

protected:
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent*) override;
  void changeEvent(QEvent* event) override;

private:
  QString title() const;
  QString labelOf(const scene::LegendEntry& entry) const;
  int rowHeight() const;
  void showWanted();
  int valueAt(int y) const; // -1: none
  int nameWidth() const;
  std::vector<int> columnWidths() const;
  int topOfEntries() const;
  void paintFigures(QPainter& painter, const QStringList& cells, int y) const;

  scene::Legend legend_;
  LegendFigures figures_;
  bool wanted_ = true;
};

} // namespace voluta::window
