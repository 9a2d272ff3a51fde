// A mapper that draws chosen stretches of its primitives, so that layer sliders rebuild nothing.
#pragma once

#include "scene/theme.h"

#include <cstddef>
#include <vector>
#include <vtkOpenGLPolyDataMapper.h>

namespace voluta::scene {

// Primitives [first, first + count) of the polygons (all triangles) or lines (all of two points).
// The data is polyDataOf()'s: corners in 32-bit arrays.
struct Stretch {
  std::size_t first = 0, count = 0;
  bool plain = false; // in the mapper's plain colour instead of the points' own
};

// Appends, joined to the one before where they touch.
void appendStretch(std::vector<Stretch>& stretches, const Stretch& next);

class RangeMapper : public vtkOpenGLPolyDataMapper {
public:
  static RangeMapper* New();
  vtkTypeMacro(RangeMapper, vtkOpenGLPolyDataMapper);

  void setStretches(std::vector<Stretch> stretches) { stretches_ = std::move(stretches); }
  // Only where prepared by addPlainColour().
  void setPlainColour(const Colour& colour) { plainColour_ = colour; }
  // Drawn whatever is before it.
  void setThroughEverything(bool through) { throughEverything_ = through; }

  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

protected:
  RangeMapper() = default;
  void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data) override;

private:
  std::vector<Stretch> stretches_;
  Colour plainColour_{};
  bool throughEverything_ = false;
};

// Lets the actor's shader know the plain colour of its RangeMapper.
void addPlainColour(vtkActor* actor);

} // namespace voluta::scene
