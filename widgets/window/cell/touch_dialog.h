// Where a real cylinder lies, from points that were touched on it with the nozzle.
#pragma once

#include "substrate/touch_fit.h"

#include <Eigen/Core>
#include <QDialog>
#include <QString>
#include <optional>
#include <vector>

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace voluta::forms {
class NumberBox;
}

namespace voluta::window {

// One point a line, in mm: y and z, or x, y and z; separated by blanks, commas (then with points in
// numbers) or semicolons. The error says which line is none.
struct TouchedPoints {
  std::vector<Eigen::Vector2d> points; // (y, z)
  QString error;
};
TouchedPoints touchedPoints(const QString& text);

class TouchDialog : public QDialog {
  Q_OBJECT

public:
  // `modelCentre`: (y, z) of the cylinder's axis where the part is now, mm.
  explicit TouchDialog(const Eigen::Vector2d& modelCentre, QWidget* parent = nullptr);

  // none: the points give no circle.
  const std::optional<substrate::CircleFit>& circle() const { return circle_; }
  // From the cylinder in the model to the one that was touched: (y, z), mm.
  Eigen::Vector2d shiftMm() const;

private:
  void fit();

  QPlainTextEdit* text_;
  QLabel* found_;
  forms::NumberBox *modelY_, *modelZ_;
  QLabel* shift_;
  QPushButton* apply_;
  std::optional<substrate::CircleFit> circle_;
};

} // namespace voluta::window
