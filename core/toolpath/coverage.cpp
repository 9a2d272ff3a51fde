#include "toolpath/coverage.h"

#include "process/bead_model.h"
#include "toolpath/segment_grid.h"
#include "toolpath/surface_samples.h"

#include <algorithm>
#include <cstdlib>

namespace voluta::toolpath {

namespace {
// Of the square of half the widest bead: about two dozen samples across and along a width; on a
// patch of which so many tell its share to a few thousandths, coarser ones.
constexpr double kSampleOfReach = 0.15, kCoarseOfReach = 0.3, kEnough = 16000.0;
} // namespace

Coverage measureCoverage(const PatchSurface& s, const std::vector<Bead>& beads) {
  struct Piece {
    std::size_t bead;
    double along; // mm from the bead's start to the segment's
    double length, width[2], height[2];
  };
  std::vector<SegmentGrid::Segment> segments;
  std::vector<Piece> pieces;
  std::vector<double> beadLength(beads.size(), 0.0);
  double widest = 0.0;
  for (std::size_t b = 0; b < beads.size(); ++b)
    for (std::size_t i = 1; i < beads[b].points.size(); ++i) {
      const BeadPoint &p = beads[b].points[i - 1], &q = beads[b].points[i];
      const double length = (q.middle - p.middle).norm();
      segments.push_back({p.middle, q.middle});
      pieces.push_back(
          {b, beadLength[b], length, {p.widthMm, q.widthMm}, {p.heightMm, q.heightMm}});
      beadLength[b] += length;
      widest = std::max({widest, p.widthMm, q.widthMm});
    }
  Coverage result;
  const double reach = 0.5 * widest;
  const SegmentGrid grid(segments, std::max(reach, 0.1));
  struct Hit {
    std::size_t bead;
    double along;
  };
  std::vector<Hit> hits;
  const double sampleMm2 = std::clamp(s.areaMm2 / kEnough, kSampleOfReach * reach * reach,
                                      kCoarseOfReach * reach * reach);
  forEachSample(s, std::max(sampleMm2, 1e-6), [&](const SurfaceSample& sample) {
    const Eigen::Vector3d& p = sample.position;
    bool covered = false;
    hits.clear();
    grid.forEachWithin(p, reach, [&](int segment, double u, double distance) {
      const Piece& piece = pieces[static_cast<std::size_t>(segment)];
      const double w = (1 - u) * piece.width[0] + u * piece.width[1];
      const double h = (1 - u) * piece.height[0] + u * piece.height[1];
      covered = covered || distance <= 0.5 * w;
      if (distance <= 0.5 * process::hatchOf(w, h))
        hits.push_back({piece.bead, piece.along + u * piece.length});
    });
    // Stretches of one bead nearer than this along it are one and the same.
    const double apart = 1.2 * widest;
    bool twice = false;
    for (std::size_t i = 1; i < hits.size() && !twice; ++i) {
      const double along = std::abs(hits[i].along - hits[0].along);
      const bool closed = beads[hits[0].bead].closed;
      const double round = closed ? std::min(along, beadLength[hits[0].bead] - along) : along;
      twice = hits[i].bead != hits[0].bead || round > apart;
    }
    result.areaMm2 += sample.areaMm2;
    result.coveredMm2 += covered ? sample.areaMm2 : 0.0;
    result.overlapMm2 += twice ? sample.areaMm2 : 0.0;
  });
  return result;
}

} // namespace voluta::toolpath
