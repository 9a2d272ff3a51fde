// Coloured lines in a picture, and solids without lines along their edges.
#pragma once

#include "scene/colouring.h"
#include "scene/drawings.h"

#include <Eigen/Geometry>
#include <memory>
#include <vector>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkRenderer;

namespace voluta::scene {

// Lines of one colour, each along its points.
struct LineGroup {
  Colour colour{};
  std::vector<std::vector<Eigen::Vector3d>> lines;
};

// Lines in a frame of the world, in addition to the drawings of a scene.
class LineGroups {
public:
  // The scene that owns the renderer must outlive this.
  explicit LineGroups(vtkRenderer* renderer);

  void show(const std::vector<const LineGroup*>& groups);
  // Moves the lines into this frame; initially the world.
  void pose(const Eigen::Isometry3d& world_T_lines);

private:
  vtkSmartPointer<vtkActor> actor_;
};

// Draws a solid whose many sharp edges are not of interest: as drawPart(), without lines.
std::shared_ptr<const PartDrawing> drawWithoutEdges(const geometry::TriangleMesh& solid);

} // namespace voluta::scene
