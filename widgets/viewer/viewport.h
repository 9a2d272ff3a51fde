// The viewport: a scene, a turntable camera controlled by the mouse, handles to place the part, the
// view cube. Left drag rotates the view, middle or Shift+left drag moves it, the wheel zooms at the
// cursor; arrow keys rotate, plus and minus zoom.
#pragma once

#include "scene/scene.h"
#include "scene/sight.h"
#include "viewer/camera_control.h"
#include "viewer/gizmo.h"
#include "viewer/typed_change.h"
#include "viewer/vtk_view.h"

#include <QRectF>
#include <QTimer>
#include <array>
#include <optional>
#include <vector>

namespace voluta::viewer {

class ViewCube;

class Viewport : public VtkView {
  Q_OBJECT

public:
  explicit Viewport(const scene::Theme& theme, QWidget* parent = nullptr);
  ~Viewport() override;

  scene::Scene& scene() { return scene_; }
  // Shows this view; a frame follows.
  void setView(const scene::ViewState& view);
  const scene::ViewState& view() const { return scene_.view(); }

  // With Tool::Paint: a drag from anywhere spans a rectangle instead of a stroke.
  void setPaintsRectangles(bool on) { paintsRectangles_ = on; }
  void setTool(Tool tool);
  Tool tool() const { return gizmo_.tool(); }
  // Sets the position of the handles in the world: the part's centre, or a cutting plane. `axes`:
  // unit vectors of the handles' axes, in columns.
  void setGizmoCentre(const Eigen::Vector3d& centre,
                      const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity());

  // Draws dots at these places of the world, and lines from each to the next, over the picture.
  void setMarks(std::vector<Eigen::Vector3d> places);
  const std::vector<Eigen::Vector3d>& marks() const { return marks_; }
  // Returns the size of a point of the screen at that place of the world.
  double mmPerPoint(const Eigen::Vector3d& place) const;

  // Leaves room for the widgets over the corners.
  void frameAll();
  // Frames the active part, or the print if that is shown.
  void framePart();
  void viewFrom(const Eigen::Vector3d& towardsEye);
  void lookAt(const Eigen::Vector3d& pointInWork, double radiusMm);
  // Keeps a point of the world in the middle of the view, from the same direction and distance.
  void follow(const Eigen::Vector3d& pointInWorld);
  // As lookAt(), from the direction with the best view of the point; returns what still hides it.
  scene::Sight lookAtClearly(const Eigen::Vector3d& pointInWork, double radiusMm);
  // Returns whether the user has zoomed or moved the camera since frameAll(). Until then it frames
  // everything from every direction and at every size of the viewport.
  bool isCameraTheUsers() const { return usersCamera_; }
  // Darkens corners and gaps; while dragging only on graphics cards.
  void setAmbientOcclusion(bool on);
  bool hasAmbientOcclusion() const { return ambientOcclusion_; }
  // Something other than the camera is being dragged: less detail, faster frames.
  void setDragging(bool on);
  // A widget laid over the viewport, at its upper left corner.
  void setLegendWidget(QWidget* legend);
  // One at its left edge, beside which the legend then is. Call again when its size or visibility
  // has changed.
  void setToolsWidget(QWidget* tools);

signals:
  void toolChanged(voluta::viewer::Tool tool);
  // A handle is being dragged: the effect so far, and once more with finished = true.
  void gizmoDragged(const voluta::viewer::GizmoChange& change, bool finished);
  void gizmoStarted();
  // A click without a drag.
  void clicked(const std::optional<voluta::scene::Hit>& hit);
  // With Tool::Paint: a stroke over the part is at this place, or has passed it; none: beside the
  // part. Shift, or the right button, erases. Once more with finished = true.
  void painted(const std::optional<voluta::scene::Hit>& hit, bool erases, bool finished);
  // With Tool::Paint and rectangles: the rays through its corners, in their order around it.
  void rectanglePainted(const std::array<voluta::viewer::Ray, 4>& corners, bool erases);
  // A click with the right button, without a drag.
  void menuAsked(const std::optional<voluta::scene::Hit>& hit, const QPoint& global);
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
  bool event(QEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  class Overlay;

  void moved();  // Moves the camera, so that it no longer frames everything
  void turned(); // Rotates the camera about its focal point
  void layOut();
  std::vector<Eigen::AlignedBox2d> coveredByWidgets() const;
  bool type(const QKeyEvent& event); // a number for the handles
  void applyDetail();
  void updateOverlay();
  // Sets the level of detail of a view.
  void setDetail(scene::ViewState& view) const;
  std::optional<scene::Hit> hitAt(const QPointF& place) const;
  std::optional<scene::Hit> clickedAt(const QPointF& place) const;
  bool paint(const QMouseEvent& event); // begins, continues or ends a stroke
  bool spanRectangle(const QMouseEvent& event);
  QPointF projected(const Eigen::Vector3d& world) const;
  double gizmoMmPerPixel() const;
  Ray rayAt(const QPointF& place) const;

  scene::Scene scene_;
  CameraControl camera_;
  Gizmo gizmo_;
  TypedChange typed_;
  Eigen::Vector3d gizmoCentre_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d gizmoAxes_ = Eigen::Matrix3d::Identity();
  QString gizmoText_;
  QPointF gizmoTextAt_;
  std::vector<Eigen::Vector3d> marks_;
  Overlay* overlay_;
  ViewCube* cube_;
  QWidget *legend_ = nullptr, *tools_ = nullptr;
  QTimer settle_, rest_;
  QPointF pressedAt_, last_;
  Qt::MouseButton button_ = Qt::NoButton;
  bool turning_ = false, moving_ = false, dragged_ = false, heldByOthers_ = false;
  bool usersCamera_ = false, ambientOcclusion_ = false;
  bool painting_ = false, erasing_ = false;
  QPointF strokeAt_; // of the last place of the stroke
  bool paintsRectangles_ = false;
  std::optional<QRectF> band_; // the rectangle that is being dragged
};

} // namespace voluta::viewer
