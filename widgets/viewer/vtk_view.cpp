#include "viewer/vtk_view.h"

#include "scene/draw_lock.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <algorithm>
#include <array>
#include <cmath>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkVersion.h>

namespace voluta::viewer {

namespace {
// Returns a one-line description of the context.
QString describe(QOpenGLContext& context) {
  const auto text = [&](GLenum name) {
    return QString::fromUtf8(reinterpret_cast<const char*>(context.functions()->glGetString(name)));
  };
  return QStringLiteral("OpenGL %1, %2, %3")
      .arg(text(GL_VERSION), text(GL_VENDOR), text(GL_RENDERER));
}

bool isSoftware(const QString& description) {
  return std::ranges::any_of(
      std::array{"llvmpipe", "softpipe", "swrast", "software", "basic render"},
      [&](const char* name) {
        return description.contains(QLatin1String(name), Qt::CaseInsensitive);
      });
}

constexpr int kMajor = 3, kMinor = 2;

QSurfaceFormat vtkFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(kMajor, kMinor);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setAlphaBufferSize(8);
  format.setSamples(0); // Multisampling is too slow with software rendering
  return format;
}

// VTK queries through events whether its context is current and requests to make it so.
void answerVtk(vtkObject*, unsigned long event, void* client, void* data) {
  auto* view = static_cast<VtkView*>(client);
  const bool current = view->context() && QOpenGLContext::currentContext() == view->context();
  if (event == vtkCommand::WindowIsCurrentEvent)
    *static_cast<bool*>(data) = current;
  else if (event == vtkCommand::WindowSupportsOpenGLEvent)
    *static_cast<int*>(data) = 1;
  else if (event == vtkCommand::WindowMakeCurrentEvent && !current && view->isValid())
    // Only if it isn't current: makeCurrent would bind Qt's framebuffer in the middle of a frame.
    view->makeCurrent();
}
} // namespace

void VtkView::setDefaultFormat() {
  QSurfaceFormat::setDefaultFormat(vtkFormat());
}

VtkView::VtkView(QWidget* parent)
    : QOpenGLWidget(parent), window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()) {
  setFormat(vtkFormat());
  window_->SetOwnContext(0);
  window_->SetFrameBlitModeToBlitToCurrent();
  window_->SetReadyForRendering(false);
  window_->SetMultiSamples(0);
  window_->SetMapped(1);
  const auto answer = vtkSmartPointer<vtkCallbackCommand>::New();
  answer->SetCallback(answerVtk);
  answer->SetClientData(this);
  for (const unsigned long event :
       {vtkCommand::WindowIsCurrentEvent, vtkCommand::WindowSupportsOpenGLEvent,
        vtkCommand::WindowMakeCurrentEvent})
    window_->AddObserver(event, answer);
}

VtkView::~VtkView() {
  releaseGl();
  // The base class destroys the context when this is no longer a VtkView.
  if (context())
    disconnect(context(), nullptr, this, nullptr);
  window_->RemoveAllObservers();
}

void VtkView::addRenderer(vtkRenderer* renderer) {
  window_->AddRenderer(renderer);
}

QSize VtkView::deviceSize() const {
  const double ratio = devicePixelRatioF();
  return {static_cast<int>(std::lround(width() * ratio)),
          static_cast<int>(std::lround(height() * ratio))};
}

QPointF VtkView::toDisplay(const QPointF& widget) const {
  const double ratio = devicePixelRatioF();
  return {widget.x() * ratio, (height() - widget.y()) * ratio};
}

QPointF VtkView::fromDisplay(const QPointF& display) const {
  const double ratio = devicePixelRatioF();
  return {display.x() / ratio, height() - display.y() / ratio};
}

void VtkView::initializeGL() {
  const QSurfaceFormat found = context()->format();
  usable_ = found.version() >= qMakePair(kMajor, kMinor);
  if (!usable_) {
    emit openGlMissing(QString("%1.%2").arg(found.majorVersion()).arg(found.minorVersion()));
    return;
  }
  // The context is destroyed before the widget if the widget moves to another window.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkView::releaseGl,
          Qt::DirectConnection);
  {
    const auto lock = scene::drawLock();
    window_->OpenGLInit();
  }
  const QString description = describe(*context());
  byProcessor_ = isSoftware(description);
  emit openGlReady(
      QStringLiteral("VTK %1, %2").arg(QLatin1String(vtkVersion::GetVTKVersion()), description));
}

void VtkView::resizeGL(int, int) {
  const QSize size = deviceSize();
  window_->SetSize(size.width(), size.height());
}

void VtkView::renderWindow() {
  const auto lock = scene::drawLock();
  // Qt has used the context since VTK's last frame, so VTK's cached state is out of date.
  vtkOpenGLState* state = window_->GetState();
  state->Reset();
  state->Push();
  window_->SetReadyForRendering(true);
  window_->Render();
  window_->SetReadyForRendering(false);
  state->Pop();
}

void VtkView::paintGL() {
  if (!usable_)
    return;
  QElapsedTimer timer;
  timer.start();
  const QSize size = deviceSize();
  if (window_->GetSize()[0] != size.width() || window_->GetSize()[1] != size.height())
    window_->SetSize(size.width(), size.height());
  beforeFrame();
  renderWindow();
  // The alpha channel left by VTK would let the desktop show through.
  QOpenGLFunctions* gl = context()->functions();
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl->glFinish(); // Makes the time include the frame's rendering, not only its submission
  lastFrameMs_ = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
  emit framePainted(lastFrameMs_);
}

void VtkView::releaseGl() {
  if (!usable_)
    return;
  usable_ = false;
  makeCurrent();
  window_->SetReadyForRendering(false);
  window_->Finalize();
  doneCurrent();
}

} // namespace voluta::viewer
