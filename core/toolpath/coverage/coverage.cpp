#include "toolpath/coverage/coverage.h"

#include "process/bead_model.h"
#include "toolpath/coverage/sample_grid.h"
#include "toolpath/coverage/segment_grid.h"

#include <algorithm>
#include <cstdlib>

namespace voluta::toolpath {

namespace {
// Area of a sample as a share of the square of half the widest bead: about two dozen samples per
// square of the bead width. Coarser on a patch with more than kEnough samples, which determine its
// coverage to a few thousandths.
constexpr double kSampleOfReach = 0.15, kCoarseOfReach = 0.3, kEnough = 16000.0;

// The beads that cover one sample.
struct Footprint {
  int firstBead = -1; // First bead whose centreline is within half a hatch
  float firstAlong = 0.0F;
  bool covered = false, twice = false;
};

// The beads as segments that mark the samples they cover.
class Painter {
public:
  explicit Painter(const std::vector<Bead>& beads) : beads_(beads), beadLength_(beads.size(), 0.0) {
    for (std::size_t b = 0; b < beads.size(); ++b)
      for (std::size_t i = 1; i < beads[b].points.size(); ++i) {
        const BeadPoint &p = beads[b].points[i - 1], &q = beads[b].points[i];
        const double length = (q.middle - p.middle).norm();
        segments_.push_back({p.middle, q.middle});
        pieces_.push_back(
            {b, beadLength_[b], length, {p.widthMm, q.widthMm}, {p.heightMm, q.heightMm}});
        beadLength_[b] += length;
        widest_ = std::max({widest_, p.widthMm, q.widthMm});
      }
  }

  const std::vector<SegmentGrid::Segment>& segments() const { return segments_; }
  double widestMm() const { return widest_; }
  double widthMm(std::size_t segment) const {
    return std::max(pieces_[segment].width[0], pieces_[segment].width[1]);
  }

  // Marks a sample at squared distance `squared` from the point `t` of the segment.
  void paint(std::size_t segment, double t, double squared, Footprint& under) const {
    if (under.covered && under.twice)
      return;
    const Piece& piece = pieces_[segment];
    const double w = (1 - t) * piece.width[0] + t * piece.width[1];
    if (squared > 0.25 * w * w)
      return; // A hatch is never wider than its bead
    under.covered = true;
    const double h = (1 - t) * piece.height[0] + t * piece.height[1];
    const double hatch = process::hatchOf(w, h);
    if (under.twice || squared > 0.25 * hatch * hatch)
      return;
    const double along = piece.along + t * piece.length;
    if (under.firstBead < 0) {
      under.firstBead = static_cast<int>(piece.bead);
      under.firstAlong = static_cast<float>(along);
      return;
    }
    // Parts of one bead that are closer than this along the bead count as the same part.
    const double apart = 1.2 * widest_;
    const double between = std::abs(along - static_cast<double>(under.firstAlong));
    const double round =
        beads_[piece.bead].closed ? std::min(between, beadLength_[piece.bead] - between) : between;
    under.twice = static_cast<int>(piece.bead) != under.firstBead || round > apart;
  }

private:
  struct Piece {
    std::size_t bead;
    double along; // From the bead's start to the segment's [mm]
    double length, width[2], height[2];
  };
  const std::vector<Bead>& beads_;
  std::vector<SegmentGrid::Segment> segments_;
  std::vector<Piece> pieces_;
  std::vector<double> beadLength_;
  double widest_ = 0.0;
};

template <typename Samples> Coverage painted(const Samples& samples, const Painter& painter) {
  std::vector<Footprint> under(samples.count());
  for (std::size_t i = 0; i < painter.segments().size(); ++i) {
    const auto& [a, b] = painter.segments()[i];
    const double radius = 0.5 * painter.widthMm(i);
    samples.forEachNear(
        a, b, radius, {radius, radius}, [&](std::size_t cell, float squared, float t) {
          painter.paint(i, static_cast<double>(t), static_cast<double>(squared), under[cell]);
        });
  }
  Coverage result;
  for (std::size_t cell = 0; cell < samples.count(); ++cell) {
    if (!samples.isInside(cell))
      continue;
    const double areaMm2 = samples.sample(cell).areaMm2;
    result.areaMm2 += areaMm2;
    result.coveredMm2 += under[cell].covered ? areaMm2 : 0.0;
    result.overlapMm2 += under[cell].twice ? areaMm2 : 0.0;
  }
  return result;
}
} // namespace

Coverage measureCoverage(const PatchSurface& s, const std::vector<Bead>& beads) {
  const Painter painter(beads);
  const double reach = 0.5 * painter.widestMm();
  const double sampleMm2 = std::clamp(s.areaMm2 / kEnough, kSampleOfReach * reach * reach,
                                      kCoarseOfReach * reach * reach);
  return painted(SampleGrid(s, std::max(sampleMm2, 1e-6)), painter);
}

Coverage measureCoverage(const PlaneSamples& samples, const std::vector<Bead>& beads) {
  return painted(samples, Painter(beads));
}

} // namespace voluta::toolpath
