#include "base/error.h"
#include "toolpath/coverage/line_cover.h"
#include "toolpath/fibre/streamlines.h"
#include "toolpath/infill/across_field.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/infill.h"
#include "toolpath/surface_fields.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

namespace voluta::toolpath {

namespace {
// [hatches]: the least distance of lines, and half of the greatest; beads can be wider more than
// they can be narrower. Beyond them the number of lines is halved or doubled.
constexpr double kLeastApart = 0.84;
constexpr int kMostOctaves = 3;
// [hatches]: pieces of lines that are shorter are left to the gaps' beads.
constexpr double kShortest = 3.0;
// Less of the gradient than this is across the directions: there is no such function.
constexpr double kFollowed = 0.6;

// Returns how often the number of lines is doubled where the gradient is that steep.
int octaveOf(double gradient) {
  const double apart = 1.0 / std::max(gradient, 1e-9); // without doubling [hatches]
  const double octave = std::floor(std::log2(apart / kLeastApart));
  return static_cast<int>(std::clamp<double>(octave, -kMostOctaves, kMostOctaves));
}

// How often a line's number can be halved: lines that stay where others end.
int evenness(int number) {
  return number == 0 ? kMostOctaves * 2 : std::countr_zero(static_cast<unsigned>(std::abs(number)));
}

class FieldLines {
public:
  FieldLines(const InfillRegion& region, const std::vector<double>& depth, const AcrossField& field)
      : r_(region), depth_(depth), field_(field), cover_(region, depth) {}

  std::vector<SurfaceCurve> lines(const base::RunContext& ctx) {
    measure();
    const double fineMm = spacingMm_ * std::exp2(-densest_);
    const int before = static_cast<int>(std::ceil((first_ - low_) / fineMm)),
              after = static_cast<int>(std::ceil((high_ - first_) / fineMm));
    const EvenIsolines levels(r_.surface, field_.mm, first_ - (before + 0.5) * fineMm, fineMm,
                              before + after + 1);
    for (int k = 0; k <= before + after; ++k) {
      ctx.checkpoint();
      const int octave = densest_ - std::min(densest_ + kMostOctaves, evenness(k - before));
      for (const SurfaceCurve& curve : levels.curvesAt(k))
        addWhere(curve, octave, k);
    }
    return cover_.joined(spacingMm_, ctx);
  }

private:
  void measure() {
    double hatch = 0.0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < depth_.size(); ++v) {
      if (depth_[v] < r_.from)
        continue;
      low_ = std::min(low_, field_.mm[v]);
      high_ = std::max(high_, field_.mm[v]);
      densest_ = std::max(densest_, octaveOf(field_.gradient[v]));
      hatch += r_.hatchMm[v];
      ++count;
    }
    hatch /= static_cast<double>(count);
    const double lines = std::max(1.0, std::round((high_ - low_) / hatch));
    spacingMm_ = (high_ - low_) / lines;
    first_ = low_ + 0.5 * spacingMm_;
  }

  // Adds the pieces of a line where lines of that octave are needed.
  void addWhere(const SurfaceCurve& curve, int octave, int number) {
    const std::size_t n = curve.points.size();
    std::vector<char> isWanted(n);
    for (std::size_t i = 0; i < n; ++i)
      isWanted[i] = octaveOf(r_.surface.interpolate(field_.gradient, curve.points[i])) >= octave;
    const auto gap = std::ranges::find(isWanted, 0);
    if (gap == isWanted.end()) {
      cover_.add(curve, number);
      return;
    }
    const std::size_t start =
        curve.closed ? static_cast<std::size_t>(gap - isWanted.begin()) : std::size_t{0};
    SurfaceCurve piece;
    const auto finish = [&] {
      if (piece.points.size() >= 2 && lengthOf(piece) >= kShortest * spacingMm_)
        cover_.add(piece, number);
      piece = {};
    };
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (start + k) % n;
      if (isWanted[i])
        piece.points.push_back(curve.points[i]);
      else
        finish();
    }
    finish();
  }

  const InfillRegion& r_;
  const std::vector<double>& depth_;
  const AcrossField& field_;
  LineCover cover_;
  double low_ = INFINITY, high_ = -INFINITY, spacingMm_ = 0.0, first_ = 0.0;
  int densest_ = -kMostOctaves;
};
// No function has isolines along the axis of a tube that closes around it, or from the middle of a
// ring outwards: the field's streamlines, which begin where others have become twice as far apart.
std::vector<SurfaceCurve> streamlines(const InfillRegion& r, const std::vector<double>& depth,
                                      const base::RunContext& ctx) {
  const double hatch = meanHatchMm(r);
  LineCover cover(r, depth);
  int number = 0;
  for (const SurfaceCurve& line : evenStreamlines(r.surface, DirectionField(*r.strands),
                                                  kLeastApart * hatch, 0.5 * hatch, ctx))
    cover.add(line, number++);
  return cover.joined(hatch, ctx);
}
} // namespace

InfillLines fieldInfill(const InfillRegion& region, const base::RunContext& ctx) {
  if (!region.strands || !*region.strands)
    throw base::Error(base::ErrorCode::Usage, "there is no field of directions for the infill"_text,
                      "infillField"_name,
                      "give a direction x,y,z or samples x,y,z,dx,dy,dz, or the part regions that "
                      "hold it and regions with a force"_text);
  InfillLines lines;
  if (std::ranges::none_of(region.depth, [&](double d) { return d >= region.from; }))
    return lines;
  const AcrossField field = acrossField(region, ctx);
  lines.lacksField = !(field.followed > 0.0);
  const bool isFollowed = field.followed >= kFollowed;
  forEachPart(region, ctx, [&](const std::vector<double>& depth, double deepest) {
    std::vector<SurfaceCurve> more = deepest < kNarrowPart
                                         ? concentricInfill(partOf(region, depth), ctx).curves
                                     : isFollowed ? FieldLines(region, depth, field).lines(ctx)
                                                  : streamlines(region, depth, ctx);
    if (more.empty()) // as where the field has no direction within the layer
      more = zigzagInfill(partOf(region, depth), ctx).curves;
    std::ranges::move(more, std::back_inserter(lines.curves));
  });
  return lines;
}

} // namespace voluta::toolpath
