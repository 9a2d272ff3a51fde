// The bodies of a cell and the printed part as FCL's own objects, to hold our checks against: a
// capsule, box or cylinder a shape (frusta by their larger radius, prisms by their boxes), the part
// a tree of oriented boxes over the faces of its cells. Boxes along the axes come first, as in a
// broad phase.
#pragma once

#include "collision/growing_part.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <vector>

namespace voluta::test {

class FclCell {
public:
  FclCell(const robot::Cell& cell, const collision::GrowingPart& part, std::size_t before);
  ~FclCell();
  FclCell(const FclCell&) = delete;
  FclCell& operator=(const FclCell&) = delete;

  std::size_t partTriangles() const { return partTriangles_; }

  // Does a checked pair, or a body other than the head with the part, overlap?
  bool collides(const std::vector<Eigen::Isometry3d>& base_T_frame);
  // The least distance of all those, mm; 0 where they overlap.
  double distance(const std::vector<Eigen::Isometry3d>& base_T_frame);

private:
  struct Objects;
  void place(const std::vector<Eigen::Isometry3d>& base_T_frame);
  const robot::Cell& cell_;
  std::size_t partTriangles_ = 0;
  std::unique_ptr<Objects> objects_;
};

} // namespace voluta::test
