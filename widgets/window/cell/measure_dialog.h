// A body's frame from what was measured at the real cell: rows of numbers, typed or pasted, and at
// once the frame that they give and how well they agree.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Geometry>
#include <QDialog>
#include <QString>
#include <optional>

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace voluta::window {

class MeasureDialog : public QDialog {
  Q_OBJECT

public:
  // Of a frame: points as they were touched, told in `in` ("in the robot's base").
  static MeasureDialog* ofFrame(const QString& body, const QString& in, QWidget* parent);
  // Of a tip that the flange carries: poses of the flange, or joints of the robot, in which it
  // touches one point.
  static MeasureDialog* ofTip(const QString& body, const robot::RobotModel& robot, QWidget* parent);

  // What the rows give; nothing while they give none. A tip's turn is none.
  const std::optional<Eigen::Isometry3d>& frame() const { return frame_; }

private:
  MeasureDialog(const QString& body, const QString& what, const QString& example,
                std::optional<robot::RobotModel> robot, QWidget* parent);
  void evaluate();

  std::optional<robot::RobotModel> robot_; // of a tip
  std::optional<Eigen::Isometry3d> frame_;
  QPlainTextEdit* rows_;
  QLabel *sign_, *told_;
  QPushButton* use_;
};

} // namespace voluta::window
