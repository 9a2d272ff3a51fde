// The legend laid over the viewport: title, unit, a scale or a list of categories.
#pragma once

#include "scene/colouring.h"

#include <QWidget>

namespace voluta::window {

class LegendView : public QWidget {
  Q_OBJECT

public:
  explicit LegendView(QWidget* parent = nullptr);
  // Hidden while there are no entries.
  void setLegend(const scene::Legend& legend);
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;
  void changeEvent(QEvent* event) override;

private:
  QString title() const;
  QString labelOf(const scene::LegendEntry& entry) const;
  int rowHeight() const;

  scene::Legend legend_;
};

} // namespace voluta::window
