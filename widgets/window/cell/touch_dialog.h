// Computes the position of a real cylinder from points touched on it with the nozzle.
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

// Parses one point per line [mm]: y and z, or x, y and z; separated by blanks, commas (numbers then
// have decimal points) or semicolons. The error names the invalid line.
struct TouchedPoints {
  std::vector<Eigen::Vector2d> points; // (y, z)
  QString error;
};
TouchedPoints touchedPoints(const QString& text);

class TouchDialog : public QDialog {
  Q_OBJECT

public:
  // `modelCentre`: (y, z) of the cylinder's axis at the part's current position [mm].
  explicit TouchDialog(const Eigen::Vector2d& modelCentre, QWidget* parent = nullptr);

  // nullopt: the points determine no circle.
  const std::optional<substrate::CircleFit>& circle() const { return circle_; }
  // Returns the shift from the cylinder in the model to the touched one: (y, z) [mm].
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
