#include "toolpath/fibre/tape_cover.h"

#include "toolpath/coverage/segment_grid.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

class TapesAbove {
public:
  TapesAbove(TapeSet tapes, double widthMm)
      : halfMm_(0.5 * widthMm), grid_(collect(tapes), widthMm) {}

  // Returns the number of tapes above a point of the surface, at most 2.
  int above(const Vector3d& p) const {
    int first = -1;
    bool second = false;
    grid_.forEachWithin(p, halfMm_, [&](int i, double t, double) {
      const Piece& piece = pieces_[static_cast<std::size_t>(i)];
      if ((piece.begins && t <= 0.0) || (piece.ends && t >= 1.0))
        return; // beyond a square end
      second = second || (first >= 0 && piece.tape != first);
      first = piece.tape;
    });
    return first < 0 ? 0 : second ? 2 : 1;
  }

private:
  struct Piece {
    int tape;
    bool begins, ends; // at the tape's end
  };

  std::vector<SegmentGrid::Segment> collect(TapeSet tapes) {
    std::vector<SegmentGrid::Segment> segments;
    for (std::size_t k = 0; k < tapes.size(); ++k) {
      const auto& p = tapes[k].points;
      const std::size_t n = p.size() + (tapes[k].closed ? 1 : 0);
      for (std::size_t i = 1; i < n; ++i) {
        segments.push_back({p[i - 1].position, p[i % p.size()].position});
        pieces_.push_back(
            {static_cast<int>(k), !tapes[k].closed && i == 1, !tapes[k].closed && i + 1 == n});
      }
    }
    return segments;
  }

  double halfMm_;
  std::vector<Piece> pieces_; // before the grid, which is made from the same tapes
  SegmentGrid grid_;
};

} // namespace

TapeCover coverOf(const PatchSurface& surface, TapeSet chosen, std::span<const TapeSet> sets,
                  double widthMm, const base::RunContext& ctx) {
  ctx.checkpoint();
  const TapesAbove own(chosen, widthMm);
  std::vector<TapesAbove> others;
  for (const TapeSet& set : sets)
    if (set.data() != chosen.data())
      others.emplace_back(set, widthMm);
  TapeCover cover;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Vector3d middle = Vector3d::Zero();
    for (const int v : surface.triangles[t])
      middle += surface.position[static_cast<std::size_t>(v)] / 3.0;
    const double area = surface.triangleArea[t];
    const int tapes = own.above(middle);
    cover.coveredMm2 += tapes > 0 ? area : 0.0;
    cover.overlapMm2 += tapes > 1 ? area : 0.0;
    if (tapes > 0 || std::ranges::any_of(
                         others, [&](const TapesAbove& other) { return other.above(middle) > 0; }))
      cover.regionMm2 += area;
  }
  return cover;
}

} // namespace voluta::toolpath
