// Computes a body's frame from measurements at the real cell: rows of numbers, typed or pasted;
// shows the resulting frame and how well the rows agree while typing.
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
  // For a frame: touched points, given in `in` ("in the robot's base").
  static MeasureDialog* ofFrame(const QString& body, const QString& in, QWidget* parent);
  // For a tool tip on the flange: flange poses, or joints of the robot, in which it touches one
  // point.
  static MeasureDialog* ofTip(const QString& body, const robot::RobotModel& robot, QWidget* parent);

  // The frame computed from the rows; nullopt if they are incomplete. For a tip, the identity as
  // rotation.
  const std::optional<Eigen::Isometry3d>& frame() const { return frame_; }

private:
  MeasureDialog(const QString& body, const QString& what, const QString& example,
                std::optional<robot::RobotModel> robot, QWidget* parent);
  void evaluate();

  std::optional<robot::RobotModel> robot_; // For a tip
  std::optional<Eigen::Isometry3d> frame_;
  QPlainTextEdit* rows_;
  QLabel *sign_, *result_;
  QPushButton* use_;
};

} // namespace voluta::window
