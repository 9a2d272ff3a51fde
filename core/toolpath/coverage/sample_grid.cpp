#include "toolpath/coverage/sample_grid.h"

#include "base/error.h"
#include "base/index.h"

#include <limits>

namespace voluta::toolpath {

namespace {
using base::at;

constexpr double kBinMm = 0.7;
constexpr double kMaxBins = 1 << 22;
} // namespace

SampleGrid::SampleGrid(const PatchSurface& surface, double maxMm2) : surface_(surface) {
  base::require(maxMm2 > 0.0, "samples stand for an area");
  std::vector<SurfaceSample> found;
  forEachSample(surface, maxMm2, [&](const SurfaceSample& sample) { found.push_back(sample); });
  if (found.empty()) {
    begin_.assign(2, 0);
    return;
  }
  Eigen::Vector3d facing = Eigen::Vector3d::Zero(), high = found.front().position;
  origin_ = high;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    facing += surface.triangleArea[t] * surface.triangleNormal[t].cwiseAbs();
  for (const SurfaceSample& sample : found) {
    origin_ = origin_.cwiseMin(sample.position);
    high = high.cwiseMax(sample.position);
  }
  Eigen::Index across = 2;
  facing.maxCoeff(&across);
  axes_ = {(across + 1) % 3, (across + 2) % 3};
  const auto binsOf = [&](std::size_t k) {
    return std::floor((high - origin_)[axes_[k]] / bin_) + 1.0;
  };
  for (bin_ = kBinMm; binsOf(0) * binsOf(1) > kMaxBins;)
    bin_ *= 2.0;
  size_ = {static_cast<int>(binsOf(0)), static_cast<int>(binsOf(1))};

  std::vector<std::uint32_t> bin(found.size());
  begin_.assign(at(size_[0]) * at(size_[1]) + 1, 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Eigen::Vector3d off = found[i].position - origin_;
    bin[i] = static_cast<std::uint32_t>(
        binAt(static_cast<int>(off[axes_[0]] / bin_), static_cast<int>(off[axes_[1]] / bin_)));
    ++begin_[bin[i] + 1];
  }
  for (std::size_t b = 1; b < begin_.size(); ++b)
    begin_[b] += begin_[b - 1];
  samples_.resize(found.size());
  for (std::vector<float>& coordinate : point_)
    coordinate.resize(found.size() + kLanes - 1);
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t place = next[bin[i]]++;
    samples_[place] = found[i];
    for (std::size_t k = 0; k < 3; ++k)
      point_[k][place] = static_cast<float>((found[i].position - origin_)[static_cast<int>(k)]);
  }
}

} // namespace voluta::toolpath
