// Overlays in pixel coordinates: the triad of axes and the legend.
#pragma once

#include "scene/colouring.h"
#include "scene/theme.h"

#include <array>
#include <vector>
#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

namespace voluta::scene {

class Overlay {
public:
  explicit Overlay(vtkRenderer* renderer);

  void setTheme(const Theme& theme);
  void setPixelRatio(double ratio) { ratio_ = ratio; }
  void showTriad(bool show) { triadShown_ = show; }
  // A legend with neither entries nor marks is hidden.
  void setLegend(const Legend& legend);
  // Updates all positions for the renderer's size and camera. Call before every frame.
  void update();

private:
  void placeTriad();
  void placeLegend();
  vtkSmartPointer<vtkTextActor> addText();

  vtkRenderer* renderer_;
  Theme theme_;
  double ratio_ = 1.0;
  bool triadShown_ = true;
  Legend legend_;
  std::array<vtkSmartPointer<vtkActor2D>, 3> arrows_;
  std::array<vtkSmartPointer<vtkTextActor>, 3> letters_;
  vtkSmartPointer<vtkActor2D> bar_;
  vtkSmartPointer<vtkTextActor> title_;
  std::vector<vtkSmartPointer<vtkTextActor>> labels_;
};

} // namespace voluta::scene
