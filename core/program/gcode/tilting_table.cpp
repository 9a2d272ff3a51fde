#include "program/gcode/tilting_table.h"

#include "geometry/directions.h"
#include "geometry/nearest_share.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace voluta::program {

namespace {

using Eigen::Vector3d;

constexpr double kTwoPi = 2.0 * base::kPi;
// Turning the table while printing makes a bead less accurate than turning it in a travel.
constexpr double kPrintWeight = 10.0;
constexpr int kMaxPieces = 1024;
constexpr double kPathMm = 0.005, kPathRad = 0.002;

Vector3d aboutZ(double angle, const Vector3d& p) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
}
Vector3d aboutY(double angle, const Vector3d& p) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() + s * p.z(), p.y(), -s * p.x() + c * p.z()};
}

Vector3d directionOf(const TableAngles& angles) {
  return aboutZ(-angles.rotation, aboutY(-angles.tilt, Vector3d::UnitZ()));
}

TablePose between(const TablePose& from, const TablePose& to, double share) {
  return {from.axesMm + share * (to.axesMm - from.axesMm),
          {from.angles.tilt + share * (to.angles.tilt - from.angles.tilt),
           from.angles.rotation + share * (to.angles.rotation - from.angles.rotation)}};
}

double offLine(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  return (a + geometry::nearestShare(p, a, b) * (b - a) - p).norm();
}

double nearestAngle(double angle, double to) {
  return angle + kTwoPi * std::round((to - angle) / kTwoPi);
}

// Chooses between the two solutions for B and C of each station (Viterbi algorithm).
class Ways {
public:
  explicit Ways(std::span<const TableStation> stations) : stations_(stations) {}

  std::vector<TableAngles> best() {
    const std::size_t n = stations_.size();
    at_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t solution = 0; solution < 2; ++solution)
        at_[i][solution] =
            i == 0 ? Standing{own(0, solution, 0.0), 0.0, solution} : reached(i, solution);
    std::vector<TableAngles> angles(n);
    std::size_t solution = n > 0 && at_[n - 1][1].cost < at_[n - 1][0].cost ? 1 : 0;
    for (std::size_t i = n; i-- > 0; solution = at_[i][solution].from)
      angles[i] = at_[i][solution].angles;
    return angles;
  }

private:
  struct Standing {
    TableAngles angles;
    double cost = 0.0;
    std::size_t from = 0;
  };

  TableAngles own(std::size_t i, std::size_t solution, double angleNow) const {
    const Vector3d& n = stations_[i].direction;
    const double tilt = std::atan2(std::hypot(n.x(), n.y()), n.z());
    if (tilt <= kFlatRad)
      return {0.0, angleNow};
    const double rotation = -std::atan2(n.y(), n.x());
    return solution == 0 ? TableAngles{-tilt, nearestAngle(rotation, angleNow)}
                         : TableAngles{tilt, nearestAngle(rotation + base::kPi, angleNow)};
  }

  // Returns whether the nozzle stays near the rotation between both directions while the angles
  // change linearly. A change between the two solutions passes through the plate's normal and
  // deviates elsewhere.
  static bool staysNear(const TableAngles& from, const TableAngles& to) {
    constexpr double kSlackRad = 0.005;
    const Vector3d a = directionOf(from), b = directionOf(to),
                   middle = directionOf(
                       {0.5 * (from.tilt + to.tilt), 0.5 * (from.rotation + to.rotation)});
    return geometry::angleBetween(a, middle) + geometry::angleBetween(middle, b) <=
           2.0 * geometry::angleBetween(a, b) + kSlackRad;
  }

  Standing reached(std::size_t i, std::size_t solution) const {
    const double weight = stations_[i].prints ? kPrintWeight : 1.0;
    Standing best;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t from =
          k == 0 ? solution : 1 - solution; // keep the solution if that costs no more
      const Standing& last = at_[i - 1][from];
      const TableAngles angles = own(i, solution, last.angles.rotation);
      const double cost = last.cost + weight * (std::abs(angles.tilt - last.angles.tilt) +
                                                std::abs(angles.rotation - last.angles.rotation));
      if (k == 0 || (cost < best.cost && staysNear(last.angles, angles)))
        best = {angles, cost, from};
    }
    return best;
  }

  std::span<const TableStation> stations_;
  std::vector<std::array<Standing, 2>> at_;
};

// Stations [first, end) are flat; on the way to `end`, if it exists, the turn has to change.
void rotateWhileFree(std::span<const TableStation> stations, std::vector<TableAngles>& angles,
                     std::size_t first, std::size_t end) {
  if (end == stations.size())
    return;
  const double to = angles[end].rotation;
  if (first == 0) {
    for (std::size_t i = 0; i < end; ++i)
      angles[i].rotation = to;
    return;
  }
  // The motions to stations [begin, last) take the turn: the last travel, else all.
  std::size_t last = end + 1;
  while (last > first && stations[last - 1].prints)
    --last;
  std::size_t begin = last;
  double seconds = 0.0;
  while (begin > first && !stations[begin - 1].prints)
    seconds += stations[--begin].seconds;
  if (!(seconds > 0.0)) {
    begin = first;
    last = end + 1;
    for (std::size_t i = begin; i < last; ++i)
      seconds += stations[i].seconds;
  }
  const double from = angles[first].rotation;
  double passed = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    if (i < last)
      passed += stations[i].seconds;
    angles[i].rotation = from + (seconds > 0.0 ? passed / seconds : 0.0) * (to - from);
  }
}

} // namespace

TablePose tablePose(const TableFrame& frame, const Vector3d& tip, TableAngles angles) {
  const Vector3d centre(frame.xMm, 0.0, frame.zMm);
  return {aboutY(angles.tilt, aboutZ(angles.rotation, tip) + centre) - centre, angles};
}

plan::NozzlePoint nozzleAt(const TableFrame& frame, const TablePose& pose) {
  const Vector3d centre(frame.xMm, 0.0, frame.zMm);
  return {aboutZ(-pose.angles.rotation, aboutY(-pose.angles.tilt, pose.axesMm + centre) - centre),
          directionOf(pose.angles).normalized()};
}

std::vector<TableAngles> tableAngles(std::span<const TableStation> stations) {
  std::vector<TableAngles> angles = Ways(stations).best();
  for (std::size_t i = 0; i < angles.size();) {
    std::size_t end = i;
    while (end < angles.size() && angles[end].tilt == 0.0)
      ++end;
    if (end > i)
      rotateWhileFree(stations, angles, i, end);
    i = end + 1;
  }
  return angles;
}

double sagMm(const TableFrame& frame, const TablePose& from, const TablePose& to) {
  const double turns = std::max(std::abs(to.angles.rotation - from.angles.rotation),
                                std::abs(to.angles.tilt - from.angles.tilt));
  if (turns == 0.0)
    return 0.0;
  const int samples = 8 * static_cast<int>(std::clamp(std::ceil(2.0 * turns), 1.0, 64.0));
  const Vector3d a = nozzleAt(frame, from).position, b = nozzleAt(frame, to).position;
  double maximum = 0.0;
  for (int k = 1; k < samples; ++k)
    maximum = std::max(
        maximum,
        offLine(nozzleAt(frame, between(from, to, static_cast<double>(k) / samples)).position, a,
                b));
  return maximum;
}

TablePose tablePiece(const TableFrame& frame, const TablePose& from, const TablePose& to,
                     double share) {
  const Vector3d a = nozzleAt(frame, from).position, b = nozzleAt(frame, to).position;
  return tablePose(frame, a + share * (b - a), between(from, to, share).angles);
}

int tablePieces(const TableFrame& frame, const TablePose& from, const TablePose& to, double maxMm) {
  const auto fits = [&](int pieces) {
    TablePose last = from;
    for (int k = 1; k <= pieces; ++k) {
      const TablePose next =
          k == pieces ? to : tablePiece(frame, from, to, static_cast<double>(k) / pieces);
      if (sagMm(frame, last, next) > maxMm)
        return false;
      last = next;
    }
    return true;
  };
  int pieces = 1;
  while (pieces < kMaxPieces && !fits(pieces))
    pieces *= 2;
  return pieces;
}

std::vector<plan::NozzlePoint> pathOnPart(const TableFrame& frame, const TablePose& from,
                                          const TablePose& to) {
  if (from.angles.tilt == to.angles.tilt && from.angles.rotation == to.angles.rotation)
    return {};
  const auto at = [&](double share) { return nozzleAt(frame, between(from, to, share)); };
  const auto fits = [&](int pieces) {
    plan::NozzlePoint last = at(0.0);
    for (int k = 1; k <= pieces; ++k) {
      const plan::NozzlePoint next = at(static_cast<double>(k) / pieces),
                              middle = at((k - 0.5) / pieces);
      if ((0.5 * (last.position + next.position) - middle.position).norm() > kPathMm ||
          geometry::angleBetween(last.direction + next.direction, middle.direction) > kPathRad)
        return false;
      last = next;
    }
    return true;
  };
  int pieces = 2;
  while (pieces < kMaxPieces && !fits(pieces))
    pieces *= 2;
  std::vector<plan::NozzlePoint> path;
  path.reserve(static_cast<std::size_t>(pieces - 1));
  for (int k = 1; k < pieces; ++k)
    path.push_back(at(static_cast<double>(k) / pieces));
  return path;
}

} // namespace voluta::program
