#include "scene/offscreen_target.h"

#include "scene/draw_lock.h"
#include "scene/vtk_modules.h"

#include "base/error.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <algorithm>
#include <fmt/format.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtk_glew.h>

namespace voluta::scene {

namespace {

constexpr int kSmallest = 16, kLargest = 8192;

[[noreturn]] void noOpenGl(base::Text why) {
  throw base::Error(base::ErrorCode::UnusableInput,
                    base::message("OpenGL 3.2 without a display is not available: {why}"_text, why),
                    {}, "install Mesa (libegl1, libgl1-mesa-dri)"_text);
}

// VTK's GLEW queries the GLX version and fails on EGL although all functions are available.
class EglWindow : public vtkGenericOpenGLRenderWindow {
public:
  static EglWindow* New();
  vtkTypeMacro(EglWindow, vtkGenericOpenGLRenderWindow);

  void OpenGLInitContext() override {
    if (Initialized)
      return;
    ContextCreationTime.Modified();
    if (glGenVertexArrays == nullptr) // Otherwise another window has filled the table
      glewInit();
    if (glGenVertexArrays == nullptr || glMultiDrawElements == nullptr)
      noOpenGl("its functions were not found"_text);
    GlewInitValid = true;
    Initialized = true;
    int widths[2] = {1, 1};
    glGetIntegerv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
    MaximumHardwareLineWidth = static_cast<float>(widths[1]);
  }
};
vtkStandardNewMacro(EglWindow);

// A surfaceless display only draws to framebuffer objects. EGL has one such display per process. It
// is never terminated, since other targets may still be using it.
EGLDisplay surfacelessDisplay() {
  static const EGLDisplay kDisplay = [] {
    const auto platformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platformDisplay == nullptr)
      noOpenGl("EGL does not support platform displays"_text);
    const EGLDisplay display =
        platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
      noOpenGl("EGL cannot be initialized"_text);
    return display;
  }();
  return kDisplay;
}

class EglContext {
public:
  EglContext() {
    // Accepts any kind of surface: none is created.
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              2,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    if (eglBindAPI(EGL_OPENGL_API) && eglChooseConfig(display_, wanted, &config, 1, &found) &&
        found > 0)
      context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT)
      noOpenGl("no context can be made"_text);
  }
  ~EglContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void makeCurrent() const {
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      noOpenGl("the context cannot be used"_text);
  }

private:
  EGLDisplay display_ = surfacelessDisplay();
  EGLContext context_ = EGL_NO_CONTEXT;
};

// Returns the image with blocks of samples x samples pixels averaged.
Image reduced(const Image& fine, int samples) {
  Image image{fine.width / samples, fine.height / samples, {}};
  image.rgb.reserve(3 * static_cast<std::size_t>(image.width) *
                    static_cast<std::size_t>(image.height));
  const std::size_t row = 3 * static_cast<std::size_t>(fine.width);
  const auto count = static_cast<unsigned>(samples * samples);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int k = 0; k < 3; ++k) {
        unsigned sum = 0;
        for (int j = 0; j < samples; ++j)
          for (int i = 0; i < samples; ++i)
            sum += fine.rgb[static_cast<std::size_t>(y * samples + j) * row +
                            static_cast<std::size_t>(3 * (x * samples + i) + k)];
        image.rgb.push_back(static_cast<std::uint8_t>((sum + count / 2) / count));
      }
  return image;
}

void checkSize(int width, int height) {
  if (width < kSmallest || height < kSmallest || width > kLargest || height > kLargest)
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("a picture of {width} x {height} pixels cannot be drawn"_text, width, height),
        {}, base::message("choose {least} to {most} pixels per side"_text, kSmallest, kLargest));
}

} // namespace

struct OffscreenTarget::Impl {
  EglContext context;
  vtkSmartPointer<EglWindow> window;
};

OffscreenTarget::OffscreenTarget() : impl_(std::make_unique<Impl>()) {
  registerVtkModules();
  impl_->context.makeCurrent();
  impl_->window = vtkSmartPointer<EglWindow>::New();
  EglWindow& window = *impl_->window;
  window.SetOwnContext(0);
  window.SetMultiSamples(0);
  window.SetIsCurrent(true);
  window.SetReadyForRendering(true);
  window.SetSupportsOpenGL(1);
  window.SetMapped(1);
  window.SetShowWindow(false);
  window.SetUseOffScreenBuffers(true);
}

OffscreenTarget::~OffscreenTarget() {
  impl_->window->Finalize();
}

Image OffscreenTarget::imageOf(Scene& scene, int width, int height,
                               const std::function<void()>& placeCamera, int samples) {
  checkSize(width, height);
  samples = std::clamp(samples, 1, std::max(1, kLargest / std::max(width, height)));
  Session session(*this, scene, width * samples, height * samples);
  scene.setPixelRatio(samples);
  if (placeCamera)
    placeCamera();
  vtkRenderer* renderer = scene.renderer();
  const bool smoothed = renderer->GetUseFXAA();
  if (samples > 1)
    renderer->SetUseFXAA(false);
  session.draw();
  renderer->SetUseFXAA(smoothed);
  scene.setPixelRatio(1.0);
  return reduced(session.image(), samples);
}

OffscreenTarget::Session::Session(OffscreenTarget& target, Scene& scene, int width, int height)
    : target_(target), scene_(scene), width_(width), height_(height) {
  checkSize(width, height);
  target_.impl_->context.makeCurrent();
  target_.impl_->window->AddRenderer(scene.renderer());
  target_.impl_->window->SetSize(width, height);
}

// Buffers and programs live in the target's context.
OffscreenTarget::Session::~Session() {
  EglWindow* window = target_.impl_->window;
  scene_.renderer()->ReleaseGraphicsResources(window);
  window->RemoveRenderer(scene_.renderer());
}

void OffscreenTarget::Session::draw() {
  const auto lock = drawLock();
  target_.impl_->context.makeCurrent();
  target_.impl_->window->Render();
  glFinish();
}

Image OffscreenTarget::Session::image() const {
  vtkNew<vtkUnsignedCharArray> pixels;
  target_.impl_->window->GetPixelData(0, 0, width_ - 1, height_ - 1, 0, pixels, 0);
  // OpenGL counts rows from the bottom.
  Image image{width_, height_, {}};
  const std::size_t row = 3 * static_cast<std::size_t>(width_);
  image.rgb.resize(row * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y)
    std::copy_n(pixels->GetPointer(0) + static_cast<std::size_t>(height_ - 1 - y) * row, row,
                image.rgb.data() + static_cast<std::size_t>(y) * row);
  return image;
}

std::string pngBytes(const Image& image) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::size_t row = 3 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.rgb.data() + static_cast<std::size_t>(y) * row, row,
                static_cast<unsigned char*>(data->GetScalarPointer(0, image.height - 1 - y, 0)));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->WriteToMemoryOn();
  writer->Write();
  const vtkUnsignedCharArray* bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(const_cast<vtkUnsignedCharArray*>(bytes)->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfTuples())};
}

} // namespace voluta::scene
