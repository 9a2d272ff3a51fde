// The cube in the viewport's corner: shows the orientation of the view; a click on a face looks
// from there, a drag rotates the view.
#pragma once

#include <Eigen/Core>
#include <QWidget>
#include <array>

namespace voluta::viewer {

class ViewCube : public QWidget {
  Q_OBJECT

public:
  explicit ViewCube(QWidget* parent = nullptr);
  // Columns: right, up, towards the eye, as in CameraControl::axes().
  void setAxes(const Eigen::Matrix3d& axes);
  QSize sizeHint() const override { return {96, 96}; }

signals:
  void viewFrom(const Eigen::Vector3d& towardsEye);
  void orbit(double dxPixels, double dyPixels); // Logical pixels, y up

protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  QPointF projected(const Eigen::Vector3d& corner) const;
  std::array<QPointF, 4> corners(int face) const;
  int faceAt(const QPointF& place) const; // -1: none

  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  int hovered_ = -1;
  QPointF pressedAt_, last_;
  bool dragged_ = false;
};

} // namespace voluta::viewer
