// Handles around the part, or on a cutting plane, for moving, rotating and scaling with the mouse:
// their positions on the screen, the one under the cursor, and the effect of dragging one. Uses a
// camera, but no widget.
#pragma once

#include "viewer/camera_control.h"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <QPointF>
#include <QPolygonF>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

class QPainter;
class QPalette;

namespace voluta::viewer {

// CutPlane: a plane moved along its normal and tilted about the two other axes of its frame. Frame:
// moved along its axes and rotated about them. MoveRegion: as Move, for a region. Regions: regions
// without handles. PickPoint, Measure: no handles; a click selects a
// point.
enum class Tool {
  None,
  Move,
  Rotate,
  Scale,
  LayFlat,
  CutPlane,
  Frame,
  PickPoint,
  Measure,
  Regions,
  MoveRegion,
  Paint
};
inline bool takesClicks(Tool tool) {
  return tool == Tool::LayFlat || tool == Tool::PickPoint || tool == Tool::Measure ||
         tool == Tool::Paint;
}
inline bool hasHandles(Tool tool) {
  return tool != Tool::None && tool != Tool::Regions && !takesClicks(tool);
}

// The total effect of a drag since its start.
struct GizmoChange {
  Eigen::Vector3d moveMm = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation =
      Eigen::Quaterniond::Identity(); // About the gizmo's centre, in the world
  double scale = 1.0;
  QString text; // For the label beside the cursor
};

class Gizmo {
  Q_DECLARE_TR_FUNCTIONS(Gizmo)

public:
  void setTool(Tool tool);
  Tool tool() const { return tool_; }
  // Centre in world mm; the handles keep their size on the screen.
  void setCentre(const Eigen::Vector3d& centre) { centre_ = centre; }
  // Unit vectors of the handles' axes, in columns; initially the world's.
  void setAxes(const Eigen::Matrix3d& axes) { axes_ = axes; }

  // Returns the widget coordinates of a point in the world.
  using Projection = std::function<QPointF(const Eigen::Vector3d&)>;
  // mmPerPixel: for the widget's pixels at the centre.
  void paint(QPainter& painter, const Projection& project, double mmPerPixel,
             const QPalette& palette) const;
  // Returns whether a handle is under the cursor; it is highlighted from then on.
  bool hover(const QPointF& cursor, const Projection& project, double mmPerPixel);

  // Precondition of begin: hover() returned true. The ray is the cursor's.
  void begin(const QPointF& cursor, const Ray& ray, const Projection& project, double mmPerPixel);
  bool dragging() const { return dragging_; }
  // Of the handle being dragged; none: there is none, or it has all axes.
  std::optional<int> draggedAxis() const {
    return dragging_ && grabbed_ != 3 ? std::optional(axisOf(grabbed_)) : std::nullopt;
  }
  // snap: whole mm, 15 degrees, 5 %.
  GizmoChange drag(const QPointF& cursor, const Ray& ray, bool snap);
  void end() { dragging_ = false; }

private:
  // 0-2: handles along or about an axis; 3: all axes (the plane z for Move, the centre for Scale);
  // 4-6: a ring about an axis that also has an arrow.
  struct Handle {
    int axis;
    QPolygonF line;
    bool closed;
  };
  static int axisOf(int handle) { return handle % 4; }
  Eigen::Vector3d axis(int handle) const { return axes_.col(axisOf(handle)); }
  // Returns the axis that follows a handle's by this many steps.
  Eigen::Vector3d axisAfter(int handle, int steps) const {
    return axes_.col((axisOf(handle) + steps) % 3);
  }
  bool turns(int handle) const {
    return tool_ == Tool::Rotate || (tool_ == Tool::CutPlane && handle < 2) || handle > 3;
  }
  std::vector<Handle> handles(const Projection& project, double mmPerPixel) const;
  double alongAxis(const Ray& ray) const; // Position along the dragged axis [mm]
  std::optional<Eigen::Vector3d> onPlane(const Ray& ray, const Eigen::Vector3d& normal) const;
  double angleOnRing(const Ray& ray, const QPointF& cursor) const;

  Tool tool_ = Tool::None;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  int grabbed_ = -1; // Under the cursor or being dragged
  bool dragging_ = false;
  Eigen::Vector3d centreAtBegin_ = Eigen::Vector3d::Zero();
  QPointF centreOnScreen_;
  double beganAt_ = 0.0;
  Eigen::Vector3d beganOnPlane_ = Eigen::Vector3d::Zero();
};

} // namespace voluta::viewer
