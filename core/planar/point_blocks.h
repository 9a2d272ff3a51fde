// Points in compact blocks, so that most of a large plate can be skipped at once.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace voluta::planar {

struct PointBlock {
  PointBlock(std::span<const Eigen::Vector3d> of, const Eigen::AlignedBox3d& about)
      : points(of), box(about) {}
  // A block without a bounding box; its points are checked one by one.
  PointBlock(const std::vector<Eigen::Vector3d>& of) : points(of) {}

  // Returns whether every point is lower than `height` along `direction`.
  bool liesBelow(const Eigen::Vector3d& direction, double height) const {
    return !box.isEmpty() &&
           direction.dot(box.center()) + 0.5 * direction.cwiseAbs().dot(box.sizes()) < height;
  }

  std::span<const Eigen::Vector3d> points; // the caller keeps them alive
  Eigen::AlignedBox3d box;                 // empty: unknown
};

class PointBlocks {
public:
  explicit PointBlocks(std::vector<Eigen::Vector3d> points);
  PointBlocks(const PointBlocks&) = delete;

  const std::vector<PointBlock>& blocks() const { return blocks_; }
  const Eigen::AlignedBox3d& box() const { return box_; }

private:
  std::vector<Eigen::Vector3d> points_;
  std::vector<PointBlock> blocks_;
  Eigen::AlignedBox3d box_;
};

} // namespace voluta::planar
