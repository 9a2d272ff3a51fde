#include "robot/kinematics/numeric_inverse.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/least_turn.h"
#include "robot/angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int kTurns = 20; // Table angles per joint
constexpr int kCells = 24; // Cells per side of the grid: outward, and up from -reach to reach
constexpr std::size_t kSeeds = 64;
constexpr double kApartRad = 0.5; // Minimum distance of two seeds
constexpr int kSteps = 12;
constexpr double kGoodMm = 1e-7, kGoodRad = 1e-10; // Required accuracy of a branch
constexpr double kSameRad = 1e-6;

double farthest(const std::array<float, 4>& a, const std::array<float, 4>& b) {
  double maximum = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
    maximum =
        std::max(maximum, std::abs(std::remainder(static_cast<double>(a[i] - b[i]), base::kTwoPi)));
  return maximum;
}

} // namespace

NumericInverse::Place NumericInverse::placeOf(const Vector3d& point, const Vector3d& axis6) const {
  const Vector3d p = base_T_first_.inverse() * point;
  const Vector3d d = base_T_first_.linear().transpose() * axis6;
  const double out = std::hypot(p.x(), p.y());
  const double c = out > 0.0 ? p.x() / out : 1.0, s = out > 0.0 ? p.y() / out : 0.0;
  Place place;
  place << static_cast<float>(out / reach_), static_cast<float>(p.z() / reach_),
      static_cast<float>(c * d.x() + s * d.y()), static_cast<float>(c * d.y() - s * d.x()),
      static_cast<float>(d.z());
  return place;
}

std::size_t NumericInverse::cellOf(int outward, int up) const {
  return static_cast<std::size_t>(std::clamp(outward, 0, kCells - 1) * kCells +
                                  std::clamp(up, 0, kCells - 1));
}

namespace {
int outwardCell(float out) {
  return static_cast<int>(out * static_cast<float>(kCells));
}
int upCell(float up) {
  return static_cast<int>(0.5F * (up + 1.0F) * static_cast<float>(kCells));
}
} // namespace

NumericInverse::NumericInverse(SerialChain chain) : chain_(std::move(chain)) {
  base::require(chain_.joints.size() == 6, "an arm of six axes");
  const std::vector<AxisLine> axes = axesAtZero(chain_);
  const Isometry3d zero = chainFlange(chain_, JointVector::Zero(6));
  base_T_first_ = Isometry3d(
      geometry::shortestRotation(Vector3d::UnitZ(), axes[0].direction).toRotationMatrix());
  base_T_first_.translation() =
      axes[0].point + axes[0].direction.dot(axes[1].point - axes[0].point) * axes[0].direction;
  axis6_ = zero.linear().transpose() * axes[5].direction;
  const Vector3d on6 =
      axes[5].point + axes[5].direction.dot(zero.translation() - axes[5].point) * axes[5].direction;
  pointOn6_ = zero.inverse() * on6;
  reach_ = 1.0 + (axes[1].point - base_T_first_.translation()).norm();
  for (std::size_t i = 1; i < 5; ++i)
    reach_ += (axes[i + 1].point - axes[i].point).norm();
  reach_ += (on6 - axes[5].point).norm();

  std::vector<Entry> entries;
  entries.reserve(static_cast<std::size_t>(kTurns * kTurns * kTurns * kTurns));
  std::array<std::array<Isometry3d, kTurns>, 4> turned;
  std::array<float, kTurns> angles;
  for (int k = 0; k < kTurns; ++k) {
    // Offset by half a step, because arms are singular at right angles.
    const double angle = -base::kPi + base::kTwoPi * (k + 0.5) / kTurns;
    angles[static_cast<std::size_t>(k)] = static_cast<float>(angle);
    for (std::size_t j = 0; j < 4; ++j)
      turned[j][static_cast<std::size_t>(k)] =
          chain_.joints[j + 1].link_T_joint *
          Isometry3d(Eigen::AngleAxisd(angle, chain_.joints[j + 1].axis));
  }
  const Isometry3d last = chain_.joints[5].link_T_joint * chain_.last_T_flange;
  for (std::size_t a = 0; a < kTurns; ++a) {
    const Isometry3d second = chain_.joints[0].link_T_joint * turned[0][a];
    for (std::size_t b = 0; b < kTurns; ++b) {
      const Isometry3d third = second * turned[1][b];
      for (std::size_t c = 0; c < kTurns; ++c) {
        const Isometry3d fourth = third * turned[2][c];
        for (std::size_t d = 0; d < kTurns; ++d) {
          const Isometry3d flange = fourth * turned[3][d] * last;
          entries.push_back({placeOf(flange * pointOn6_, flange.linear() * axis6_),
                             {angles[a], angles[b], angles[c], angles[d]}});
        }
      }
    }
  }
  // Counting sort by cell; the order within a cell is kept.
  const auto cell = [&](const Entry& e) {
    return cellOf(outwardCell(e.place[0]), upCell(e.place[1]));
  };
  cells_.assign(kCells * kCells + 1, 0);
  for (const Entry& e : entries)
    ++cells_[cell(e) + 1];
  for (std::size_t i = 1; i < cells_.size(); ++i)
    cells_[i] += cells_[i - 1];
  std::vector<std::uint32_t> next(cells_.begin(), cells_.end() - 1);
  entries_.resize(entries.size());
  for (const Entry& e : entries)
    entries_[next[cell(e)]++] = e;
}

JointVector NumericInverse::seedOf(const Entry& entry, const Isometry3d& base_T_flange) const {
  JointVector q = JointVector::Zero(6);
  for (std::size_t i = 0; i < 4; ++i)
    q[static_cast<Eigen::Index>(i + 1)] = entry.joints[i];
  // Joint 1 brings the point to the right azimuth, joint 6 the flange as near as possible to its
  // orientation.
  const auto azimuthOf = [&](const Isometry3d& flange) {
    const Vector3d p = base_T_first_.inverse() * (flange * pointOn6_);
    return std::atan2(p.y(), p.x());
  };
  q[0] = azimuthOf(base_T_flange) - azimuthOf(chainFlange(chain_, q));
  const Eigen::Matrix3d rest = chainFlange(chain_, q).linear().transpose() * base_T_flange.linear();
  const Vector3d twice(rest(2, 1) - rest(1, 2), rest(0, 2) - rest(2, 0), rest(1, 0) - rest(0, 1));
  q[5] = std::atan2(axis6_.dot(twice), rest.trace() - axis6_.dot(rest * axis6_));
  return q;
}

void NumericInverse::inverse(const Isometry3d& base_T_flange,
                             std::vector<JointVector>& solutions) const {
  const Place wanted = placeOf(base_T_flange * pointOn6_, base_T_flange.linear() * axis6_);
  if (std::hypot(wanted[0], wanted[1]) > 1.0F)
    return;
  // Neighbours in the table differ by at most about a third of the reach.
  constexpr int kAround = 4;
  constexpr float kFar = 0.5F;
  struct Near {
    float square;
    std::uint32_t entry;
  };
  std::vector<Near> near;
  const int outward = outwardCell(wanted[0]), up = upCell(wanted[1]);
  for (int i = std::max(0, outward - kAround); i <= std::min(kCells - 1, outward + kAround); ++i)
    for (int k = std::max(0, up - kAround / 2); k <= std::min(kCells - 1, up + kAround / 2); ++k) {
      const std::size_t cell = cellOf(i, k);
      for (std::uint32_t e = cells_[cell]; e < cells_[cell + 1]; ++e) {
        Place apart = entries_[e].place - wanted;
        apart.head<2>() *= 3.0F; // Newton steps correct lengths less than angles
        const float square = apart.squaredNorm();
        if (square < kFar * kFar)
          near.push_back({square, e});
      }
    }
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return a.square != b.square ? a.square < b.square : a.entry < b.entry;
  });
  std::vector<const Entry*> seeds;
  for (const Near& n : near) {
    const Entry& entry = entries_[n.entry];
    if (std::any_of(seeds.begin(), seeds.end(),
                    [&](const Entry* s) { return farthest(s->joints, entry.joints) < kApartRad; }))
      continue;
    seeds.push_back(&entry);
    if (seeds.size() == kSeeds)
      break;
  }
  const std::size_t before = solutions.size();
  for (const Entry* seed : seeds) {
    JointVector q = seedOf(*seed, base_T_flange);
    const PoseError error = settle(chain_, base_T_flange, kSteps, q);
    if (error.mm > kGoodMm || error.rad > kGoodRad)
      continue;
    for (int i = 0; i < 6; ++i)
      q[i] = wrappedAngle(q[i]);
    const bool known =
        std::any_of(solutions.begin() + static_cast<std::ptrdiff_t>(before), solutions.end(),
                    [&](const JointVector& other) { return sameJoints(q, other, kSameRad); });
    if (!known)
      solutions.push_back(q);
  }
}

} // namespace voluta::robot
