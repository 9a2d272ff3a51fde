#include "base/index.h"
#include "base/units.h"
#include "toolpath/coverage/line_cover.h"
#include "toolpath/infill/infill.h"
#include "toolpath/infill/periodic_isolines.h"
#include "toolpath/surface_fields.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kQuarter = 0.5 * base::kPi;
constexpr double kAround = 1e-3; // [rad]: lines with a smaller inclination run around
// [hatches] inside the region's edge: depth at which its ends are examined
constexpr double kEndDepth = 0.02;
constexpr double kStraight = 0.05;       // [hatches]: an end that deviates less is straight
constexpr double kMinWidth = 0.5;        // [pitches]: initial bead width of a narrowing turn
constexpr double kRevolutionStep = 0.25; // Point spacing of such a turn [mm]
constexpr double kMaxBend = 0.09;        // [rad]: maximum change of the angle to keep the spacing
constexpr double kOnChart = 1e-8;        // [mm]
constexpr double kOffSurface = 0.02; // [mm]: tolerance for chart points that are off the surface

using base::at;

Vector2d chartAt(const PatchSurface& s, const SurfacePoint& p) {
  return s.chart.blend(s.triangles[at(p.triangle)], s.barycentric(p));
}

// Returns the surface point with the chart coordinates `uv`, searched from `start`; nullopt if the
// surface has no such point.
std::optional<SurfacePoint> placeOf(const PatchSurface& s, const Vector2d& uv, SurfacePoint start) {
  Vector2d off;
  for (int round = 0; round < 12; ++round) {
    off = uv - chartAt(s, start);
    off.x() = std::remainder(off.x(), s.chart.periodMm);
    if (off.norm() < kOnChart)
      break;
    const auto& t = s.triangles[at(start.triangle)];
    Eigen::Matrix2d charted;
    charted << s.chart.between(t[0], t[1]), s.chart.between(t[0], t[2]);
    if (std::abs(charted.determinant()) < 1e-12)
      break;
    const Vector2d weights = charted.inverse() * off;
    start = s.project(start.position + weights[0] * (s.position[at(t[1])] - s.position[at(t[0])]) +
                          weights[1] * (s.position[at(t[2])] - s.position[at(t[0])]),
                      start.triangle);
  }
  return off.norm() < kOffSurface ? std::optional(start) : std::nullopt;
}

// One connected part of a region.
class Part {
public:
  Part(const InfillRegion& r, const std::vector<double>& depth, const base::RunContext& ctx)
      : r_(r), s_(r.surface), depth_(depth), ctx_(ctx), u_(depth.size(), NAN) {
    double sum = 0.0, count = 0.0;
    for (std::size_t v = 0; v < depth.size(); ++v)
      if (depth[v] >= r.from) {
        sum += r.hatchMm[v];
        ++count;
      }
    hatch_ = sum / count;
    unroll();
  }

  // Returns whether the part extends all the way around.
  bool winds() const { return winds_; }

  std::vector<SurfaceCurve> straight(double angle) const {
    std::vector<double> across(u_.size());
    for (std::size_t v = 0; v < u_.size(); ++v)
      across[v] = s_.chart.at[v].y() * std::cos(angle) - u_[v] * std::sin(angle);
    return evenLines(r_, depth_, across, ctx_).curves;
  }

  // Returns a helix over a part that extends all the way around; empty if it is too short for two
  // turns.
  std::vector<SurfaceCurve> helix() const {
    const double pitch = hatch_, period = s_.chart.periodMm;
    const auto [low, high, areStraight] = ends();
    if (high - low < 2.0 * pitch)
      return {};
    LineCover lines(r_, depth_);
    for (SurfaceCurve& c : periodicIsolines(s_, {-1.0 / period, 1.0 / pitch, -low / pitch}, ctx_))
      for (const SurfaceCurve& piece :
           areStraight ? betweenEnds(std::move(c), low, high, pitch) : std::vector{std::move(c)})
        lines.add(piece, 0);
    return lines.joined(pitch, ctx_);
  }

  // Returns parallel helices over a part that extends all the way around.
  std::vector<SurfaceCurve> inclined(double angle) const {
    const double spacing = hatch_, period = s_.chart.periodMm;
    const double sine = std::sin(std::abs(angle));
    const double starts = std::max(1.0, std::round(period * sine / spacing));
    Winding winding;
    winding.perU = starts / period;
    if (std::abs(angle) < kQuarter - kAround) {
      // Use the angle that gives the required spacing, unless it deviates too much; then change the
      // spacing.
      const double fitting = std::asin(std::min(1.0, winding.perU * spacing));
      const bool fits = std::abs(fitting - std::abs(angle)) < kMaxBend;
      winding.perV = winding.perU / std::tan(fits ? fitting : std::abs(angle));
    }
    if (angle > 0)
      winding.perU = -winding.perU;
    const auto count = static_cast<long>(starts);
    std::vector<SurfaceCurve> curves = periodicIsolines(s_, winding, ctx_);
    const auto levelOf = [&](const SurfaceCurve& c) {
      const long line = std::lround(winding.at(chartAt(s_, c.points.front())) - 0.5);
      return static_cast<int>((line % count + count) % count);
    };
    std::ranges::stable_sort(curves, {}, levelOf);
    LineCover lines(r_, depth_);
    for (const SurfaceCurve& c : curves) {
      ctx_.checkpoint();
      lines.add(c, levelOf(c));
    }
    return lines.joined(spacing, ctx_);
  }

private:
  struct Ends {
    double low = 0.0, high = 0.0; // Range of v
    bool areStraight = false;
  };

  // Computes u without jumps, in the part and one triangle around it.
  void unroll() {
    std::vector<int> stack;
    for (std::size_t first = 0; first < depth_.size() && stack.empty(); ++first)
      if (depth_[first] >= r_.from) {
        u_[first] = s_.chart.at[first].x();
        stack.push_back(static_cast<int>(first));
      }
    while (!stack.empty()) {
      const int a = stack.back();
      stack.pop_back();
      for (const int* t = s_.ringBegin(a); t != s_.ringEnd(a); ++t)
        for (const int b : s_.triangles[at(*t)]) {
          const double u = u_[at(a)] + s_.chart.between(a, b).x();
          if (std::isnan(u_[at(b)])) {
            u_[at(b)] = u;
            if (depth_[at(b)] >= r_.from)
              stack.push_back(b);
          } else if (depth_[at(b)] >= r_.from) {
            winds_ = winds_ || std::abs(u - u_[at(b)]) > 0.5 * s_.chart.periodMm;
          }
        }
    }
    winds_ = winds_ && s_.chart.periodMm > 0.0;
  }

  Ends ends() const {
    Ends e{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    int around = 0;
    bool areStraight = true;
    for (const SurfaceCurve& c : isolines(s_, depth_, r_.from + kEndDepth)) {
      double turned = 0.0, low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::size_t i = 0; i < c.points.size(); ++i) {
        const Vector2d here = chartAt(s_, c.points[i]),
                       next = chartAt(s_, c.points[(i + 1) % c.points.size()]);
        turned += std::remainder(next.x() - here.x(), s_.chart.periodMm);
        low = std::min(low, here.y());
        high = std::max(high, here.y());
      }
      e.low = std::min(e.low, low);
      e.high = std::max(e.high, high);
      if (!c.closed || std::abs(turned) < 0.5 * s_.chart.periodMm)
        continue;
      ++around;
      areStraight = areStraight && high - low < kStraight * hatch_;
    }
    e.low -= kEndDepth * hatch_;
    e.high += kEndDepth * hatch_;
    e.areStraight = areStraight && around == 2;
    return e;
  }

  // Cuts a helix where its bead reaches the ends, and appends at each end a turn in the middle of
  // the gap between the previous turn and the end.
  std::vector<SurfaceCurve> betweenEnds(SurfaceCurve c, double low, double high,
                                        double pitch) const {
    if (chartAt(s_, c.points.front()).y() > chartAt(s_, c.points.back()).y())
      std::ranges::reverse(c.points);
    const double first = low + 0.5 * pitch, last = high - 0.5 * pitch;
    std::vector<double> v;
    for (const SurfacePoint& p : c.points)
      v.push_back(chartAt(s_, p).y());
    const auto place = [&](std::size_t i, double where) {
      const double t = (where - v[i - 1]) / (v[i] - v[i - 1]);
      return s_.project((1 - t) * c.points[i - 1].position + t * c.points[i].position,
                        c.points[i].triangle);
    };
    SurfaceCurve piece;
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (i > 0 && v[i - 1] < first && v[i] >= first) {
        piece.points.push_back(place(i, first));
        appendNarrowing(piece, -1.0, pitch);
        std::ranges::reverse(piece.points);
      }
      if (v[i] >= first && v[i] <= last)
        piece.points.push_back(c.points[i]);
      if (i > 0 && v[i - 1] <= last && v[i] > last) {
        piece.points.push_back(place(i, last));
        appendNarrowing(piece, 1.0, pitch);
      }
    }
    if (piece.points.size() < 2)
      return {};
    return {std::move(piece)};
  }

  // Appends a turn from the curve's end, where the bead is a pitch wide and touches the end of the
  // part, towards that end (`sign`: direction in v). Over this turn the gap next to the previous
  // turn narrows; the bead fills it and stays at the end.
  void appendNarrowing(SurfaceCurve& c, double sign, double pitch) const {
    const double period = s_.chart.periodMm;
    const Vector2d from = chartAt(s_, c.points.back());
    const int steps = static_cast<int>(std::ceil((1.0 - kMinWidth) * period / kRevolutionStep));
    for (int k = 1; k <= steps; ++k) {
      const double turned = (1.0 - kMinWidth) * k / steps;
      const auto p = placeOf(s_, from + sign * Vector2d(turned * period, 0.5 * turned * pitch),
                             c.points.back());
      if (!p)
        return;
      c.points.push_back(*p);
    }
  }

  const InfillRegion& r_;
  const PatchSurface& s_;
  const std::vector<double>& depth_;
  const base::RunContext& ctx_;
  std::vector<double> u_; // Per vertex; NaN outside the part
  double hatch_ = 0.0;    // Mean
  bool winds_ = false;
};

InfillLines wound(const InfillRegion& r, double angle, const base::RunContext& ctx) {
  if (std::ranges::none_of(r.depth, [&](double d) { return d >= r.from; }))
    return {};
  std::vector<SurfaceCurve> curves;
  forEachPart(r, ctx, [&](const std::vector<double>& depth, double deepest) {
    const Part part(r, depth, ctx);
    const bool isAround = std::abs(angle) < kAround;
    std::vector<SurfaceCurve> lines;
    if (part.winds() && isAround)
      lines = part.helix();
    else if (deepest >= kNarrowPart)
      lines = part.winds() ? part.inclined(angle) : part.straight(angle);
    if (lines.empty())
      lines = concentricInfill(partOf(r, depth), ctx).curves;
    std::ranges::move(lines, std::back_inserter(curves));
  });
  return {std::move(curves)};
}

} // namespace

InfillLines aroundInfill(const InfillRegion& region, const base::RunContext& ctx) {
  return wound(region, 0.0, ctx);
}

InfillLines alongInfill(const InfillRegion& region, const base::RunContext& ctx) {
  return wound(region, kQuarter, ctx);
}

InfillLines helicalInfill(const InfillRegion& region, const base::RunContext& ctx) {
  return wound(region, region.layer % 2 == 0 ? region.windingRad : -region.windingRad, ctx);
}

InfillLines wovenInfill(const InfillRegion& region, const base::RunContext& ctx) {
  return region.layer % 2 == 0 ? aroundInfill(region, ctx) : alongInfill(region, ctx);
}

} // namespace voluta::toolpath
