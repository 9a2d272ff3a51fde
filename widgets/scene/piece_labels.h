// Numbers of pieces in print order: each a small disc at the middle of the piece's visible region.
#pragma once

#include "scene/drawing_data.h"
#include "scene/theme.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <optional>
#include <vector>
#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

namespace voluta::scene {

class PieceLabels {
public:
  explicit PieceLabels(vtkRenderer* renderer);

  void setTheme(const Theme& theme) { theme_ = theme; }
  void setPixelRatio(double ratio) { ratio_ = ratio; }
  // Null: none. The drawing must outlive its display.
  void setDrawing(const PiecesDrawing* drawing);
  // Call before every frame. While view.dragging, the numbers keep their positions on the pieces;
  // otherwise they move to the largest visible region of each piece.
  void update(const ViewState& view, const Eigen::Isometry3d& world_T_work);
  // Returns the numbers on display.
  std::vector<int> shown() const;

private:
  // The view for which the positions were computed.
  struct Found {
    Eigen::Matrix4d clip_T_world = Eigen::Matrix4d::Zero();
    int width = 0, height = 0;
    double explodeMm = 0.0;
    std::optional<std::size_t> piece;
    bool sectionOn = false;
    Eigen::Vector3d sectionOrigin = Eigen::Vector3d::Zero();
    Eigen::Vector3d sectionNormal = Eigen::Vector3d::Zero();
    bool operator==(const Found&) const = default;
  };
  void addNumber();
  void find(const ViewState& view, const std::vector<Eigen::Isometry3d>& poses,
            const Eigen::Isometry3d& world_T_work);
  void draw(const ViewState& view, const std::vector<Eigen::Isometry3d>& poses);

  vtkRenderer* renderer_;
  Theme theme_;
  double ratio_ = 1.0;
  const PiecesDrawing* drawing_ = nullptr;
  std::optional<Found> found_;
  std::vector<std::optional<Eigen::Vector3d>> places_; // per piece, on the part
  vtkSmartPointer<vtkActor2D> discs_;
  std::vector<vtkSmartPointer<vtkTextActor>> numbers_; // per piece
};

} // namespace voluta::scene
