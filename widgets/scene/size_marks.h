// The box of the active part with its edges in mm, and the size of the plate, in pixel coordinates.
#pragma once

#include "scene/theme.h"

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>
#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

namespace voluta::scene {

class SizeMarks {
public:
  explicit SizeMarks(vtkRenderer* renderer);

  void setTheme(const Theme& theme);
  void setPixelRatio(double ratio) { ratio_ = ratio; }
  // `part`: its box in the work frame, empty: none. `plate`: its corners, empty: none.
  void show(const Eigen::AlignedBox3d& part, const std::vector<Eigen::Vector2d>& plate,
            const Eigen::Isometry3d& world_T_work);
  // Updates the places of all labels. Call before every frame.
  void update();

  // Returns the labels on display: along x, y and z of the part, of the plate, of its origin.
  std::vector<std::string> shown() const;
  // Returns their areas in the picture [pixels from the lower left corner], which do not overlap.
  std::vector<Eigen::AlignedBox2d> areas() const;

private:
  static constexpr std::size_t kPlate = 3, kOrigin = 4, kLabels = 5;

  void drawBrackets();
  void placeAll();
  void separate();
  void putAt(std::size_t label, const Eigen::Vector2d& centre, const Eigen::Vector2d& half);
  // Puts a label beside a place, away from another one of the same object.
  void place(std::size_t label, const Eigen::Vector3d& at, const Eigen::Vector3d& from);
  Eigen::Vector2d onScreen(const Eigen::Vector3d& inWork) const;

  vtkRenderer* renderer_;
  double ratio_ = 1.0;
  Eigen::AlignedBox3d part_;
  std::vector<Eigen::Vector2d> plate_;
  Eigen::Isometry3d world_T_work_ = Eigen::Isometry3d::Identity();
  vtkSmartPointer<vtkActor> brackets_;
  std::array<vtkSmartPointer<vtkTextActor>, kLabels> labels_;
  std::array<Eigen::AlignedBox2d, kLabels> areas_;
};

} // namespace voluta::scene
