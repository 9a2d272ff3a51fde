// Splits and merges levels of the field that are too thick or too thin to be printed as one layer.
#pragma once

#include "base/run_context.h"
#include "curved/level_field.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace voluta::curved {

// The region between two values of the field: [index w, (index + 1) w) with w = 2^scale * spacing.
// Scale 0 is a whole level; negative scales are parts of a level, positive ones merged levels.
struct Slab {
  int scale = 0, index = 0;
};

// Partition of the part into slabs. From the largest scale downwards, a slab is kept whole or cut
// into halves, depending on the thickness that a level would have at its middle. Levels stay whole
// where that is within the limits. The thickness is stored per voxel and smoothed; places too small
// for a patch of their own are not changed.
class PartialLevels {
public:
  // Range of scales: levels are at most quartered, and at most four are merged.
  static constexpr int kFinest = -2, kCoarsest = 2;

  struct Options {
    double spacingMm = 0.8; // of whole levels, in the field
    double heightMinMm = 0.4, heightMaxMm = 1.0;
    double minVolumeMm3 = 4.0; // minimum volume beyond the limits for a place to be changed
  };
  // Preconditions: 0 < heightMinMm <= heightMaxMm, spacingMm > 0. Throws Cancelled.
  PartialLevels(const LevelField& field, const Options& options, const base::RunContext& ctx);

  double spacingMm() const { return options_.spacingMm; }
  double widthMm(int scale) const;
  double midOf(const Slab& slab) const { return (slab.index + 0.5) * widthMm(slab.scale); }
  // Returns the bottom of a slab in units of the finest scale, by which slabs are sorted.
  static int bottomOf(const Slab& slab) { return slab.index << (slab.scale - kFinest); }

  // Returns whether any place differs from whole levels.
  bool any() const { return used_ != wholeOnly(); }
  bool uses(int scale) const { return (used_ & bit(scale)) != 0; }
  // Returns false only if no slab of this scale is used near the cell (LevelField::cell).
  bool mayHold(int scale, int i, int j, int k) const;

  // Returns a positive value if the slab is used at a point of its middle surface, zero at its rim,
  // a negative one if it is cut or part of a larger slab there. `gradient`: of the field at the
  // point.
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
