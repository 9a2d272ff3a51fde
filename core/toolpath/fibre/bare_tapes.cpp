#include "toolpath/fibre/bare_tapes.h"

#include "toolpath/coverage/segment_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

// Tested places across a tape, in half widths
constexpr std::array<double, 3> kAcross{-0.9, 0.0, 0.9};
// A bead covers places this far from its middle [widths], as gaps of a part of its width do not lay
// the tape bare, and up to this many heights below its tip.
constexpr double kBeside = 0.65, kHeights = 1.3;

// The beads of plastic.
class Beads {
public:
  explicit Beads(const plan::ToolPlan& plan)
      : plan_(plan), segments_(collect()), grid_(segments_, reachMm_) {}

  // Returns whether a bead after that path covers a place on its tape.
  bool cover(const Vector3d& place, std::size_t path) const {
    bool covered = false;
    grid_.forEachWithin(place, reachMm_, [&](int i, double t, double) {
      const Piece& piece = pieces_[static_cast<std::size_t>(i)];
      covered =
          covered || (piece.path > path && plan_.paths[piece.path].item == plan_.paths[path].item &&
                      isBelow(place, piece.waypoint, t));
    });
    return covered;
  }

private:
  struct Piece {
    std::size_t path, waypoint; // the one at its end
  };

  bool isBelow(const Vector3d& place, std::size_t w, double t) const {
    const Vector3d tip = (1.0 - t) * plan_.position[w - 1] + t * plan_.position[w];
    const Vector3d& up = plan_.direction[w];
    const double depth = up.dot(tip - place), height = static_cast<double>(plan_.heightMm[w]);
    const double lateral = (tip - place - depth * up).norm();
    return depth > 0.0 && depth <= kHeights * height &&
           lateral <= kBeside * static_cast<double>(plan_.widthMm[w]);
  }

  std::vector<SegmentGrid::Segment> collect() {
    std::vector<SegmentGrid::Segment> segments;
    double width = 0.0, height = 0.0;
    for (std::size_t k = 0; k < plan_.paths.size(); ++k) {
      const plan::ToolPath& path = plan_.paths[k];
      if (path.kind == plan::PathKind::Tape || plan::isWaste(path.kind))
        continue;
      for (std::size_t w = path.first + 1; w < path.first + path.count; ++w) {
        segments.push_back({plan_.position[w - 1], plan_.position[w]});
        pieces_.push_back({k, w});
        width = std::max(width, static_cast<double>(plan_.widthMm[w]));
        height = std::max(height, static_cast<double>(plan_.heightMm[w]));
      }
    }
    reachMm_ = std::hypot(kBeside * width, kHeights * height);
    return segments;
  }

  const plan::ToolPlan& plan_;
  std::vector<Piece> pieces_;
  double reachMm_ = 0.0; // set by collect()
  std::vector<SegmentGrid::Segment> segments_;
  SegmentGrid grid_;
};

} // namespace

BareTapes bareTapes(const plan::ToolPlan& plan, double tapeWidthMm) {
  BareTapes bare;
  if (std::ranges::find(plan.paths, plan::PathKind::Tape, &plan::ToolPath::kind) ==
      plan.paths.end())
    return bare;
  const Beads beads(plan);
  for (std::size_t k = 0; k < plan.paths.size(); ++k) {
    const plan::ToolPath& path = plan.paths[k];
    if (path.kind != plan::PathKind::Tape)
      continue;
    for (std::size_t w = path.first + 1; w < path.first + path.count; ++w) {
      const Vector3d step = plan.position[w] - plan.position[w - 1];
      const Vector3d middle = plan.position[w] - 0.5 * step;
      const Vector3d lateral = step.cross(plan.direction[w]).normalized();
      const bool covered = std::ranges::all_of(kAcross, [&](double across) {
        return beads.cover(middle + 0.5 * across * tapeWidthMm * lateral, k);
      });
      if (covered)
        continue;
      if (bare.lengthMm == 0.0) {
        bare.layer = path.layer;
        bare.where = middle;
      }
      bare.lengthMm += step.norm();
    }
  }
  return bare;
}

} // namespace voluta::toolpath
