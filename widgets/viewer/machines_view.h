// A view of several machines in one cell, with a turntable camera: left drag rotates the view,
// middle or Shift+left drag moves it, the wheel zooms at the cursor, a double click frames all. The
// number of each machine is drawn at its base.
#pragma once

#include "scene/machines_scene.h"
#include "viewer/camera_control.h"
#include "viewer/vtk_view.h"

#include <QPointF>

namespace voluta::viewer {

class MachinesView : public VtkView {
  Q_OBJECT

public:
  explicit MachinesView(const scene::Theme& theme, QWidget* parent = nullptr);

  // Call requestFrame() after changes.
  scene::MachinesScene& scene() { return scene_; }
  void frameAll();

protected:
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  class Numbers;
  void moved();

  scene::MachinesScene scene_;
  CameraControl camera_;
  QWidget* numbers_;
  QPointF last_;
  bool isCameraTheUsers_ = false;
};

} // namespace voluta::viewer
