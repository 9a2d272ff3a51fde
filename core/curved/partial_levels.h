// Where a level of the field is too thick or too thin to be laid as it is, and what is laid
// instead.
#pragma once

#include "base/run_context.h"
#include "curved/level_field.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace voluta::curved {

// What lies between two values of the field: [index w, (index + 1) w) with w = 2^scale * spacing.
// Scale 0 is a whole level; below it a part of one; above it levels that are laid as one.
struct Slab {
  int scale = 0, index = 0;
};

// Share of levels by slabs, so that each point of the part is in exactly one: going down from the
// largest scale, a slab is left whole or cut into its halves, as told by the thickness that a level
// would have at its middle. Levels stay whole where that lies within the limits. That thickness is
// known to a voxel, smoothed; places too small to be worth a patch are left as they are.
class PartialLevels {
public:
  // Scales that are tried: levels are quartered at most, and four laid as one.
  static constexpr int kFinest = -2, kCoarsest = 2;

  struct Options {
    double spacingMm = 0.8; // of whole levels, in the field
    double heightMinMm = 0.4, heightMaxMm = 1.0;
    double leastVolumeMm3 = 4.0; // beyond the limits, for a place to be changed
  };
  // Preconditions: 0 < heightMinMm <= heightMaxMm, spacingMm > 0. Throws Cancelled.
  PartialLevels(const LevelField& field, const Options& options, const base::RunContext& ctx);

  double spacingMm() const { return options_.spacingMm; }
  double widthMm(int scale) const;
  double midOf(const Slab& slab) const { return (slab.index + 0.5) * widthMm(slab.scale); }
  // Bottom of a slab in units of the finest: what slabs are ordered by.
  static int bottomOf(const Slab& slab) { return slab.index << (slab.scale - kFinest); }

  // Some place is laid otherwise than by whole levels.
  bool any() const { return used_ != wholeOnly(); }
  bool uses(int scale) const { return (used_ & bit(scale)) != 0; }
  // False only where no slab of this scale is laid near the cell (LevelField::cell).
  bool mayHold(int scale, int i, int j, int k) const;

  // Positive where the slab is laid at a point of its middle surface, zero at its rim, negative
  // where it is cut or part of a larger one. `gradient` of the field there.
  double margin(const Slab& slab, const Eigen::Vector3d& point,
                const Eigen::Vector3d& gradient) const;

private:
  using Mask = std::uint8_t; // bit scale - kFinest
  static constexpr int kBlock = 4;

  static Mask bit(int scale) { return static_cast<Mask>(1u << (scale - kFinest)); }
  static Mask wholeOnly() { return bit(0); }
  // Log2 of the thickness of a whole level above which a slab of this scale is cut.
  double cutAbove(int scale) const;
  void measure(const base::RunContext& ctx);
  void leaveSmallPlaces(const base::RunContext& ctx);
  void markBlocks();
  double thicknessAt(const Eigen::Vector3d& point) const;
  std::size_t blockOf(int i, int j, int k) const;

  const LevelField& field_;
  Options options_;
  double splitAt_ = 0.0, mergeAt_ = 0.0; // log2 mm
  std::vector<float> thickness_;         // log2 mm of a whole level, NaN outside; per grid cell
  Eigen::Vector3i blocks_ = Eigen::Vector3i::Zero();
  std::vector<Mask> near_; // per block
  Mask used_ = wholeOnly();
};

} // namespace voluta::curved
