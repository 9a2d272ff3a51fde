// Short pieces of beads, and those that one covers.
#pragma once

#include "plan/tool_plan.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace voluta::collision {

// A piece of a bead, about a millimetre or half its width long.
struct BeadSample {
  Eigen::Vector3d tip, direction;                  // at its middle; work frame [mm]
  Eigen::Vector3d along = Eigen::Vector3d::Zero(); // from its middle to its end [mm]
  double widthMm = 0.0, heightMm = 0.0;
  std::size_t waypoint = 0;    // at the end of its segment
  double from = 0.0, to = 0.0; // its ends as shares of the segment
};

// Appends the samples of the bead between two of its waypoints.
void appendSamples(const plan::ToolPlan& plan, std::size_t a, std::size_t b,
                   std::vector<BeadSample>& samples);

// Samples by place.
class BeadSampleGrid {
public:
  // For samples of that plan.
  explicit BeadSampleGrid(const plan::ToolPlan& plan);

  // Samples are numbered from 0 as they are added.
  void add(const BeadSample& sample);
  // Calls visit(number) for each added sample that this one covers: those about a height of bead
  // below its middle, or below one of two points at a fifth of its width on either side.
  template <typename Visit> void below(const BeadSample& upper, const Visit& visit) const {
    const Eigen::Vector3i middle = cellOf(upper.tip);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (const auto cell = cells_.find(keyOf(middle + Eigen::Vector3i(x, y, z)));
              cell != cells_.end())
            for (const std::size_t s : cell->second)
              if (covers(upper, samples_[s]))
                visit(s);
  }

private:
  static bool covers(const BeadSample& upper, const BeadSample& lower);
  Eigen::Vector3i cellOf(const Eigen::Vector3d& point) const;
  static std::uint64_t keyOf(const Eigen::Vector3i& cell);

  double cellMm_;
  std::vector<BeadSample> samples_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

} // namespace voluta::collision
