// The legend over the viewport: title, unit, a scale or a list of categories.
#pragma once

#include "scene/colouring.h"

#include <QWidget>

namespace voluta::window {

class LegendView : public QWidget {
  Q_OBJECT

public:
  explicit LegendView(QWidget* parent = nullptr);
  // Hidden while it has neither entries nor marks.
  void setLegend(const scene::Legend& legend);
  // Hidden if the user has switched it off.
  void setWanted(bool wanted);
  bool isWanted() const { return wanted_; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;
  void changeEvent(QEvent* event) override;

private:
  QString title() const;
  QString labelOf(const scene::LegendEntry& entry) const;
  int rowHeight() const;
  void showWanted();

  scene::Legend legend_;
  bool wanted_ = true;
};

} // namespace voluta::window
