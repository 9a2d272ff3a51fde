// The thickness of layers as a histogram, in the colours of the layers' colour map.
#pragma once

#include "window/layer_spacing.h"

#include <QWidget>

class QLabel;

namespace voluta::window {

class SpacingChart;

class SpacingView : public QWidget {
  Q_OBJECT

public:
  explicit SpacingView(QWidget* parent = nullptr);

  // Hidden if there are no layers.
  void setSpacing(const LayerSpacing& spacing);
  // Returns the mean and the shares within the limits, as shown.
  QString words() const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  LayerSpacing spacing_;
  QLabel *title_, *words_;
  SpacingChart* chart_;
};

} // namespace voluta::window
