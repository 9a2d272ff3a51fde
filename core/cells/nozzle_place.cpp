#include "cells/nozzle_place.h"

#include "base/error.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <tuple>

namespace voluta::cells {

using Eigen::Vector3d;
using Eigen::Vector3i;

std::vector<Vector3d> reachableFrames(const robot::RobotModel& robot, const NozzleSearch& search) {
  std::mt19937_64 random(search.seed);
  // The standard library's distributions differ between implementations.
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  std::vector<Vector3d> frames;
  robot::JointVector q(robot.dof());
  for (std::size_t n = 0; n < search.samples; ++n) {
    for (int i = 0; i < robot.dof(); ++i) {
      const robot::JointLimits& limits = robot.limits[static_cast<std::size_t>(i)];
      q[i] = limits.min + (limits.max - limits.min) * unit();
    }
    const Eigen::Isometry3d work = robot.kinematics->flange(q) * search.flange_T_work;
    if (work.linear()(2, 2) >= 0.0)
      frames.push_back(work.translation());
  }
  return frames;
}

std::size_t framesInBox(const std::vector<Vector3d>& frames, const Vector3d& at,
                        const Vector3d& sizeMm) {
  const Vector3d low = at - 0.5 * sizeMm, high = at + 0.5 * sizeMm;
  return static_cast<std::size_t>(std::ranges::count_if(frames, [&](const Vector3d& p) {
    return (p.array() >= low.array()).all() && (p.array() < high.array()).all();
  }));
}

namespace {

// Sums over boxes of bins in constant time.
class SummedBins {
public:
  SummedBins(const std::vector<Vector3d>& points, double stepMm) {
    const auto bin = [&](const Vector3d& p) {
      return Vector3i((p / stepMm).array().floor().cast<int>());
    };
    low_ = bin(points.front());
    Vector3i high = low_;
    for (const Vector3d& p : points) {
      low_ = low_.cwiseMin(bin(p));
      high = high.cwiseMax(bin(p));
    }
    size_ = high - low_ + Vector3i::Ones();
    sums_.assign(static_cast<std::size_t>(size_.x() + 1) * static_cast<std::size_t>(size_.y() + 1) *
                     static_cast<std::size_t>(size_.z() + 1),
                 0);
    for (const Vector3d& p : points)
      ++at(bin(p) - low_ + Vector3i::Ones());
    for (int axis = 0; axis < 3; ++axis)
      for (int z = 1; z <= size_.z(); ++z)
        for (int y = 1; y <= size_.y(); ++y)
          for (int x = 1; x <= size_.x(); ++x) {
            const Vector3i here(x, y, z);
            at(here) += at(here - Vector3i::Unit(axis));
          }
  }

  Vector3i low() const { return low_; }
  Vector3i high() const { return low_ + size_; } // one past the last

  // Returns the sum over the bins [from, to).
  std::size_t in(const Vector3i& from, const Vector3i& to) const {
    const Vector3i a = clamped(from), b = clamped(to);
    std::size_t sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3i c(corner & 1 ? a.x() : b.x(), corner & 2 ? a.y() : b.y(),
                       corner & 4 ? a.z() : b.z());
      const bool minus = std::popcount(static_cast<unsigned>(corner)) % 2 == 1;
      sum += minus ? ~sums_[index(c)] + 1 : sums_[index(c)]; // unsigned integers wrap around
    }
    return sum;
  }

private:
  Vector3i clamped(const Vector3i& bin) const { return (bin - low_).cwiseMax(0).cwiseMin(size_); }
  std::size_t index(const Vector3i& i) const {
    return (static_cast<std::size_t>(i.z()) * static_cast<std::size_t>(size_.y() + 1) +
            static_cast<std::size_t>(i.y())) *
               static_cast<std::size_t>(size_.x() + 1) +
           static_cast<std::size_t>(i.x());
  }
  std::size_t& at(const Vector3i& i) { return sums_[index(i)]; }

  Vector3i low_, size_;
  std::vector<std::size_t> sums_;
};

} // namespace

NozzlePlace bestNozzlePlace(const std::vector<Vector3d>& frames, double stepMm,
                            const Vector3i& boxSteps) {
  base::require(stepMm > 0.0 && boxSteps.minCoeff() >= 2 &&
                    (boxSteps.array() - 2 * (boxSteps.array() / 2) == 0).all(),
                "a box of an even number of steps");
  if (frames.empty())
    return {};
  const SummedBins bins(frames, stepMm);
  const Vector3i half = boxSteps / 2;
  NozzlePlace best;
  Vector3i bestAt = Vector3i::Zero();
  const auto better = [&](std::size_t count, const Vector3i& at) {
    return std::tuple(count, -at.z(), -std::abs(at.y()), at.y(), -at.x()) >
           std::tuple(best.frames, -bestAt.z(), -std::abs(bestAt.y()), bestAt.y(), -bestAt.x());
  };
  const Vector3i from = bins.low() - half, to = bins.high() + half;
  for (int z = from.z(); z <= to.z(); ++z)
    for (int y = from.y(); y <= to.y(); ++y)
      for (int x = from.x(); x <= to.x(); ++x) {
        const Vector3i at(x, y, z);
        if (const std::size_t count = bins.in(at - half, at + half);
            count > 0 && (best.frames == 0 || better(count, at))) {
          best.frames = count;
          bestAt = at;
        }
      }
  best.at = stepMm * bestAt.cast<double>();
  return best;
}

} // namespace voluta::cells
