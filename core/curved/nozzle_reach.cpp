#include "curved/nozzle_reach.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::curved {

namespace {

constexpr double kInside = 1e-6; // cells: touching is not inside

// Steps to the 26 neighbours of a cell and the 48 steps of type (2, 1, 0) and (2, 1, 1) in between.
const std::vector<Eigen::Vector3d>& directions() {
  static const std::vector<Eigen::Vector3d> all = [] {
    std::vector<Eigen::Vector3d> out;
    for (int k = -2; k <= 2; ++k)
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i) {
          const Eigen::Vector3i step(i, j, k);
          const int maximum = step.cwiseAbs().maxCoeff();
          const bool halved = i % 2 == 0 && j % 2 == 0 && k % 2 == 0;
          const int sum = step.cwiseAbs().sum();
          if (maximum == 0 || (maximum == 2 && (halved || sum > 3 + (i && j && k))))
            continue;
          out.push_back(step.cast<double>().normalized());
        }
    return out;
  }();
  return all;
}

} // namespace

NozzleReach::NozzleReach(const VoxelGraph& graph, const process::HeadShape& head) : graph_(graph) {
  base::require(!head.sections.empty(), "NozzleReach: a head has sections");
  for (const process::HeadSection& s : head.sections)
    sections_.push_back({s.zMm / graph.grid.pitch, s.radiusMm / graph.grid.pitch});
  voxel::VoxelGrid blocks{.size = graph.grid.size};
  for (;;) {
    levels_.push_back({blocks, std::vector<std::uint16_t>(blocks.cellCount(), 0)});
    if (blocks.size.maxCoeff() == 1)
      break;
    blocks.size = ((blocks.size.array() + 1) / 2).matrix();
  }
}

void NozzleReach::count(std::size_t v, int by) {
  Eigen::Vector3i c(graph_.cell[v][0], graph_.cell[v][1], graph_.cell[v][2]);
  for (Level& level : levels_) {
    std::uint16_t& some = level.some[level.blocks.index(c.x(), c.y(), c.z())];
    const bool before = some > 0;
    some = static_cast<std::uint16_t>(some + by);
    if (before == (some > 0))
      return;
    c /= 2;
  }
}

double NozzleReach::radiusAt(double z) const {
  return radiusBetween(z, z);
}

double NozzleReach::radiusBetween(double low, double high) const {
  double maximum = -1.0;
  for (std::size_t s = 0; s + 1 < sections_.size(); ++s) {
    const process::HeadSection &a = sections_[s], &b = sections_[s + 1];
    if (b.zMm < low || a.zMm > high)
      continue;
    const auto at = [&](double z) {
      const double rise = b.zMm - a.zMm;
      return rise <= 0.0 ? std::max(a.radiusMm, b.radiusMm)
                         : a.radiusMm +
                               (b.radiusMm - a.radiusMm) * std::clamp((z - a.zMm) / rise, 0.0, 1.0);
    };
    maximum = std::max({maximum, at(low), at(high)});
  }
  return maximum;
}

bool NozzleReach::clear(std::size_t v, const Eigen::Vector3d& d) const {
  const Eigen::Vector3d tip(graph_.cell[v][0], graph_.cell[v][1], graph_.cell[v][2]);
  // The lowest points of the head are on the rims of its sections.
  const double plate = graph_.plateLayer - 0.5;
  const double sink = std::sqrt(std::max(0.0, 1.0 - d.z() * d.z()));
  for (const process::HeadSection& s : sections_)
    if (tip.z() + s.zMm * d.z() - s.radiusMm * sink < plate - kInside)
      return false;

  struct Block {
    int level;
    Eigen::Vector3i at;
  };
  std::array<Block, 256> open;
  std::size_t count = 0;
  open[count++] = {static_cast<int>(levels_.size()) - 1, Eigen::Vector3i::Zero()};
  while (count > 0) {
    const Block block = open[--count];
    const Level& level = levels_[static_cast<std::size_t>(block.level)];
    if (level.some[level.blocks.index(block.at.x(), block.at.y(), block.at.z())] == 0)
      continue;
    const double width = std::ldexp(1.0, block.level);
    const Eigen::Vector3d centre =
        width * block.at.cast<double>() + Eigen::Vector3d::Constant(0.5 * (width - 1.0));
    const Eigen::Vector3d to = centre - tip;
    const double z = to.dot(d);
    const double across = std::sqrt(std::max(0.0, to.squaredNorm() - z * z));
    if (block.level == 0) {
      if (z > kInside && across < radiusAt(z) - kInside)
        return false;
      continue;
    }
    // Half the diagonal between the outermost centres of the block.
    const double reach = 0.5 * std::sqrt(3.0) * (width - 1.0);
    if (z + reach <= 0.0 || across - reach >= radiusBetween(std::max(0.0, z - reach), z + reach))
      continue;
    const Level& finer = levels_[static_cast<std::size_t>(block.level - 1)];
    for (int c = 0; c < 8; ++c) {
      const Eigen::Vector3i child = 2 * block.at + Eigen::Vector3i(c & 1, c >> 1 & 1, c >> 2);
      if ((child.array() < finer.blocks.size.array()).all())
        open[count++] = {block.level - 1, child};
    }
  }
  return true;
}

std::optional<Eigen::Vector3d> NozzleReach::direction(std::size_t v,
                                                      const Eigen::Vector3d& wish) const {
  std::vector<Eigen::Vector3d> tried = directions();
  std::stable_sort(tried.begin(), tried.end(),
                   [&](const auto& a, const auto& b) { return a.dot(wish) > b.dot(wish); });
  for (const Eigen::Vector3d& d : tried)
    if (clear(v, d))
      return d;
  return std::nullopt;
}

} // namespace voluta::curved
