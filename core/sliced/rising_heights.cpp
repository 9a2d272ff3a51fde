#include "sliced/rising_heights.h"

#include "base/error.h"
#include "sliced/sliced_heights.h"

#include <algorithm>
#include <cmath>

namespace voluta::sliced {

namespace {
using Eigen::Vector3d;

constexpr double kMinOwnGap = 0.25; // [usual heights] of a path above its own earlier turn
constexpr double kFarthest = 2.5;   // [usual heights]
constexpr double kWidest = 1.5;     // [usual widths]
constexpr double kThinnestMm = 0.01;
constexpr double kOwnReaches = 3.0; // A path is not below itself within that many reaches

constexpr double kLevelMm = 1e-4;
constexpr double kMaxSteps = 1000.0; // Along one segment

double medianOf(std::vector<double> values) {
  if (values.empty())
    return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Returns heights from the gaps (negative: not known) below the ways to the points.
std::vector<double> heightsFrom(const std::vector<double>& gaps, const SlicedPath& path,
                                const std::vector<double>& areasMm2, double statedMm) {
  std::vector<double> known, areas;
  for (std::size_t i = 1; i < gaps.size(); ++i) {
    if (gaps[i] >= kThinnestMm)
      known.push_back(gaps[i]);
    if (areasMm2[i] > 0.0)
      areas.push_back(areasMm2[i]);
  }
  const double usual = known.empty() ? statedMm : medianOf(std::move(known));
  std::vector<double> heights(gaps.size(), 0.0);
  if (!(usual > 0.0))
    return heights;
  const double otherwise = statedMm > 0.0 ? statedMm : usual;
  const double widest = kWidest * medianOf(std::move(areas)) / usual;
  for (std::size_t i = 1; i < gaps.size(); ++i) {
    const double z = 0.5 * (path.points[i - 1].position.z() + path.points[i].position.z());
    double gap = gaps[i] >= 0.0 ? gaps[i] : z;
    if (gap < 0.0 || gap > kFarthest * usual)
      gap = otherwise;
    heights[i] = std::max({gap, kThinnestMm, widest > 0.0 ? areasMm2[i] / widest : 0.0});
  }
  return heights;
}
} // namespace

std::int64_t BeadTops::cellOf(double x, double y) const {
  const auto cell = [&](double mm) {
    return static_cast<std::int64_t>(std::floor(mm / (0.5 * reachMm_)));
  };
  constexpr std::int64_t kRow = 1LL << 32;
  return cell(x) + kRow * cell(y);
}

void BeadTops::release(double alongMm) {
  for (; !waiting_.empty() && waiting_.front().alongMm < alongMm; waiting_.pop_front()) {
    const Sample& sample = waiting_.front().sample;
    latest_.insert_or_assign(cellOf(sample.at.x(), sample.at.y()), sample);
  }
}

double BeadTops::gapBelow(const Vector3d& point, double minMm) const {
  double minimum = -1.0;
  const double cell = 0.5 * reachMm_;
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i) {
      const auto found = latest_.find(cellOf(point.x() + i * cell, point.y() + j * cell));
      if (found == latest_.end())
        continue;
      const Vector3d apart = point - found->second.at;
      const double needed = found->second.path == path_    ? minMm
                            : found->second.path == kLevel ? kThinnestMm
                                                           : 0.0;
      if (apart.head<2>().norm() <= reachMm_ && apart.z() >= needed &&
          (minimum < 0.0 || apart.z() < minimum))
        minimum = apart.z();
    }
  return minimum;
}

std::vector<double> BeadTops::add(const SlicedPath& path, const std::vector<double>& areasMm2,
                                  double statedMm) {
  base::require(areasMm2.size() == path.points.size(), "an area for each point");
  const bool rises = isRising(path);
  const double minMm = std::max(kThinnestMm, kMinOwnGap * statedMm);
  std::vector<double> gaps(path.points.size(), -1.0); // Mean on the way to each point
  double alongMm = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Vector3d &from = path.points[i - 1].position, &to = path.points[i].position;
    const double distance = (to - from).norm();
    const int steps =
        static_cast<int>(std::clamp(std::ceil(distance / (0.25 * reachMm_)), 1.0, kMaxSteps));
    const bool isLevel = std::abs(to.z() - from.z()) < kLevelMm;
    double sum = 0.0;
    int found = 0;
    for (int k = 0; k < steps; ++k) {
      const Vector3d at = from + (k + 0.5) / steps * (to - from);
      const double here = alongMm + (k + 0.5) / steps * distance;
      if (rises) {
        release(here - kOwnReaches * reachMm_);
        if (const double gap = gapBelow(at, minMm); gap >= 0.0) {
          sum += gap;
          ++found;
        }
      }
      waiting_.push_back({{at, isLevel ? kLevel : path_}, here});
    }
    if (found > 0)
      gaps[i] = sum / found;
    alongMm += distance;
  }
  release(alongMm + 1.0);
  ++path_;
  if (!rises)
    return {};
  return heightsFrom(gaps, path, areasMm2, statedMm);
}

} // namespace voluta::sliced
