// Darkens corners and gaps of a picture, where less light from the surroundings arrives. Meant for
// graphics cards: it is slow on a processor.
#pragma once

#include <vtkSmartPointer.h>

class vtkRenderer;
class vtkRenderPass;
class vtkSSAOPass;

namespace voluta::scene {

class AmbientOcclusion {
public:
  explicit AmbientOcclusion(vtkRenderer* renderer) : renderer_(renderer) {}

  void show(bool on);
  // Sets the width of the darkened rims for a picture of that height. Call before every frame.
  void update(double pictureHeightMm);

private:
  vtkRenderer* renderer_;
  vtkSmartPointer<vtkSSAOPass> pass_; // null until it is shown
  vtkSmartPointer<vtkRenderPass> smoothed_;
};

} // namespace voluta::scene
