// Actors of pieces: faces, faces that need support, edges and base planes.
#pragma once

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/theme.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::scene {

class PieceActors {
public:
  explicit PieceActors(vtkRenderer* renderer);

  // Null: none. The drawing must outlive its display.
  void setDrawing(const PiecesDrawing* drawing);
  void setTheme(const Theme& theme);
  void show(const ViewState& view, const Eigen::Isometry3d& world_T_work);
  void hide();

  // Returns the actors that a section plane cuts.
  std::vector<vtkActor*> actors() const;

private:
  struct One {
    vtkSmartPointer<vtkActor> safe, risky, edges, base, baseRim;
  };
  void remove();

  vtkRenderer* renderer_;
  Theme theme_;
  const PiecesDrawing* drawing_ = nullptr;
  std::vector<One> pieces_;
};

// Returns the legend of the pieces' colours; `named`: lists each piece by its number, if the
// picture does not show the numbers.
Legend pieceLegend(const PiecesDrawing& drawing, const Theme& theme, bool named);

} // namespace voluta::scene
