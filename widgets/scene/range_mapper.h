// A mapper that draws selected ranges of its primitives, so that layer sliders need not rebuild any
// buffers.
#pragma once

#include "scene/theme.h"

#include <cstddef>
#include <vector>
#include <vtkOpenGLPolyDataMapper.h>

namespace voluta::scene {

// Primitives [first, first + count) of the polygons (all triangles) or lines (all with two points).
// The data must come from polyDataOf(): corners in 32-bit arrays.
struct Stretch {
  std::size_t first = 0, count = 0;
  bool plain = false; // drawn in the mapper's plain colour instead of the points' own
};

// Appends a stretch, merged with the last one if they adjoin.
void appendStretch(std::vector<Stretch>& stretches, const Stretch& next);

class RangeMapper : public vtkOpenGLPolyDataMapper {
public:
  static RangeMapper* New();
  vtkTypeMacro(RangeMapper, vtkOpenGLPolyDataMapper);

  void setStretches(std::vector<Stretch> stretches) { stretches_ = std::move(stretches); }
  // Requires an actor prepared by addPlainColour().
  void setPlainColour(const Colour& colour) { plainColour_ = colour; }
  // Draws it in front of everything.
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

// Passes the plain colour of the actor's RangeMapper to its shader.
void addPlainColour(vtkActor* actor);

} // namespace voluta::scene
