#include "scene/ambient_occlusion.h"

#include <vtkNew.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>

namespace voluta::scene {

namespace {
// Relative to the picture's height.
constexpr double kRadiusShare = 0.03, kBiasShare = 0.004;
constexpr unsigned int kSamples = 64;
} // namespace

void AmbientOcclusion::show(bool on) {
  if (on && !pass_) {
    pass_ = vtkSmartPointer<vtkSSAOPass>::New();
    pass_->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
    pass_->SetKernelSize(kSamples);
    pass_->BlurOn();
    vtkNew<vtkOpenGLFXAAPass> smoothed;
    smoothed->SetDelegatePass(pass_);
    smoothed_ = smoothed;
  }
  renderer_->SetPass(on ? smoothed_.Get() : nullptr);
}

void AmbientOcclusion::update(double pictureHeightMm) {
  if (!pass_)
    return;
  pass_->SetRadius(kRadiusShare * pictureHeightMm);
  pass_->SetBias(kBiasShare * pictureHeightMm);
}

} // namespace voluta::scene
