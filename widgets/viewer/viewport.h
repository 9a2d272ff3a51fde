// The viewport: a scene, a turntable camera under the mouse, handles to place the part with, the
// view cube. Left drag turns the view, middle or Shift+left drag moves it, the wheel zooms at the
// cursor; arrow keys turn, plus and minus zoom.
#pragma once

#include "scene/scene.h"
#include "scene/sight.h"
#include "viewer/camera_control.h"
#include "viewer/gizmo.h"
#include "viewer/vtk_view.h"

#include <QTimer>
#include <optional>

namespace voluta::viewer {

class ViewCube;

class Viewport : public VtkView {
  Q_OBJECT

public:
  explicit Viewport(const scene::Theme& theme, QWidget* parent = nullptr);
  ~Viewport() override;

  scene::Scene& scene() { return scene_; }
  // Shows this; a frame follows.
  void setView(const scene::ViewState& view);
  const scene::ViewState& view() const { return scene_.view(); }

  void setTool(Tool tool);
  Tool tool() const { return gizmo_.tool(); }
  // Where the handles are, in the world: at the part's centre, or on a plane that cuts it.
  // `axes`: unit vectors in columns that the handles lie along.
  void setGizmoCentre(const Eigen::Vector3d& centre,
                      const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity());

  // Beside what lies over the corners.
  void frameAll();
  void viewFrom(const Eigen::Vector3d& towardsEye);
  void lookAt(const Eigen::Vector3d& pointInWork, double radiusMm);
  // As lookAt(), from where the place is seen best; says what hides it there all the same.
  scene::Sight lookAtClearly(const Eigen::Vector3d& pointInWork, double radiusMm);
  // Has the user moved the camera nearer, farther or aside since frameAll()? Until then it frames
  // all from every side and in every size of the viewport.
  bool isCameraTheUsers() const { return usersCamera_; }
  // Something other than the camera is being dragged: less detail, faster frames.
  void setDragging(bool on);
  // A widget laid over the viewport, at its upper left corner.
  void setLegendWidget(QWidget* legend);

signals:
  void toolChanged(voluta::viewer::Tool tool);
  // A drag of a handle: what it came to so far, once more with finished = true.
  void gizmoDragged(const voluta::viewer::GizmoChange& change, bool finished);
  void gizmoStarted();
  // A click that did not drag.
  void clicked(const std::optional<voluta::scene::Hit>& hit);
  // The cursor rests on something.
  void hovered(const std::optional<voluta::scene::Hit>& hit);
  void cameraMoved();

protected:
  void initializeGL() override;
  void resizeEvent(QResizeEvent* event) override;
  void beforeFrame() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  class Overlay;

  void moved();  // the camera, so that it no longer frames all
  void turned(); // the camera, about what it looks at
  void layOut();
  void applyDetail();
  std::optional<scene::Hit> hitAt(const QPointF& place) const;
  QPointF projected(const Eigen::Vector3d& world) const;
  double gizmoMmPerPixel() const;
  Ray rayAt(const QPointF& place) const;

  scene::Scene scene_;
  CameraControl camera_;
  Gizmo gizmo_;
  Eigen::Vector3d gizmoCentre_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d gizmoAxes_ = Eigen::Matrix3d::Identity();
  QString gizmoText_;
  Overlay* overlay_;
  ViewCube* cube_;
  QWidget* legend_ = nullptr;
  QTimer settle_, rest_;
  QPointF pressedAt_, last_;
  Qt::MouseButton button_ = Qt::NoButton;
  bool turning_ = false, moving_ = false, dragged_ = false, heldByOthers_ = false;
  bool usersCamera_ = false;
};

} // namespace voluta::viewer
