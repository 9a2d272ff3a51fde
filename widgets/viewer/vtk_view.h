// The Qt side of the viewport (docs/design.md, Viewport): a QOpenGLWidget that owns a VTK render
// window. VTK renders only inside paintGL; code that changes the scene requests a frame with
// requestFrame().
#pragma once

#include <QOpenGLWidget>
#include <vtkSmartPointer.h>

class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace voluta::viewer {

class VtkView : public QOpenGLWidget {
  Q_OBJECT

public:
  // To be called once before QApplication is created: the surface format that VTK needs.
  static void setDefaultFormat();

  explicit VtkView(QWidget* parent = nullptr);
  ~VtkView() override;

  void addRenderer(vtkRenderer* renderer);
  // Schedules one frame, however often it is called.
  void requestFrame() { update(); }
  // Time that the last frame took to paint [ms]; 0 before the first.
  double lastFrameMs() const { return lastFrameMs_; }
  // Returns whether the processor draws, not a graphics card; true until the first frame.
  bool isDrawnByProcessor() const { return byProcessor_; }
  // Widget coordinates (y down, logical pixels) to VTK display coordinates and back.
  QPointF toDisplay(const QPointF& widget) const;
  QPointF fromDisplay(const QPointF& display) const;
  // Returns a copy of the displayed image.
  QImage grabFrame() { return grabFramebuffer(); }

signals:
  void framePainted(double ms);
  // Drawing is possible from now on, with this VTK and OpenGL: version, vendor, renderer.
  void openGlReady(const QString& what);
  // The display offers less than OpenGL 3.2; nothing can be drawn.
  void openGlMissing(const QString& found);

protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  // For updates needed in every frame; called before VTK renders.
  virtual void beforeFrame() {}

private:
  void renderWindow();
  void releaseGl();
  QSize deviceSize() const;

  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  double lastFrameMs_ = 0.0;
  bool usable_ = false, byProcessor_ = true;
};

} // namespace voluta::viewer
