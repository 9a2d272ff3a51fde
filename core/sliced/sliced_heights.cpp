#include "sliced/sliced_heights.h"

#include <algorithm>
#include <cmath>

namespace voluta::sliced {

namespace {
constexpr double kSameMm = 0.005, kThinnestMm = 0.01, kFlatMm = 0.02, kUpright = 1.0 - 1e-6;
constexpr double kOdd = 2.5; // [usual heights] a first layer farther from z = 0 is on something

struct Range {
  double low, high;
  bool upright;
};

Range rangeOf(const SlicedPath& path) {
  Range range{path.points.front().position.z(), path.points.front().position.z(), true};
  for (const SlicedPoint& p : path.points) {
    range.low = std::min(range.low, p.position.z());
    range.high = std::max(range.high, p.position.z());
    range.upright = range.upright && p.direction.z() >= kUpright;
  }
  return range;
}

bool isFlat(const Range& range) {
  return range.upright && range.high - range.low <= kFlatMm;
}

void sortDistinct(std::vector<double>& tops) {
  std::ranges::sort(tops);
  std::vector<double> distinct;
  for (const double top : tops)
    if (distinct.empty() || top - distinct.back() > kSameMm)
      distinct.push_back(top);
  tops = std::move(distinct);
}
} // namespace

bool isRising(const SlicedPath& path) {
  const Range range = rangeOf(path);
  return range.upright && !isFlat(range);
}

LayerHeights::LayerHeights(const SlicedFile& file) : header_(file.header) {
  for (const SlicedPath& path : file.paths)
    if (const Range range = rangeOf(path); isFlat(range))
      (path.ofPart ? part_ : other_).push_back(range.high);
  sortDistinct(part_);
  sortDistinct(other_);
}

double LayerHeights::stated(double topMm) const {
  return header_.firstLayerHeightMm > 0.0 && topMm <= header_.firstLayerHeightMm + kSameMm
             ? header_.firstLayerHeightMm
             : header_.layerHeightMm;
}

LayerHeights::Layer LayerHeights::of(const SlicedPath& path) const {
  const Range range = rangeOf(path);
  const std::vector<double>& tops = path.ofPart ? part_ : other_;
  const auto at = std::lower_bound(tops.begin(), tops.end(), range.high - kSameMm);
  Layer layer{static_cast<int>(at - tops.begin()), 0.0};
  if (!isFlat(range) || at == tops.end()) {
    layer.heightMm = stated(range.high);
    return layer;
  }
  const double usual = tops.size() > 2 ? tops[2] - tops[1] : header_.layerHeightMm;
  layer.heightMm = at == tops.begin() ? *at : *at - *(at - 1);
  // A first layer on a body, or one above layers that only supports have.
  if (!(layer.heightMm >= kThinnestMm) || (usual > 0.0 && layer.heightMm > kOdd * usual)) {
    const double known = stated(*at);
    layer.heightMm = known > 0.0 ? known : usual >= kThinnestMm ? usual : 0.0;
  }
  return layer;
}

} // namespace voluta::sliced
