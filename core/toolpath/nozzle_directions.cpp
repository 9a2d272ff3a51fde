#include "toolpath/nozzle_directions.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "geometry/directions.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "robot/cell.h"
#include "toolpath/options.h"
#include "toolpath/path_figures.h"
#include "toolpath/unsupported/head_clearance.h"
#include "toolpath/unsupported/passes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using geometry::angleBetween;
using plan::ToolPlan;

constexpr std::size_t kGrain = 512;
// Clearance to the printed part that a direction should keep: programs are checked with the head's
// true shape, and the head comes nearer between waypoints.
constexpr double kMarginMm = 0.05;
// Clearance for paths that may be skipped. In addition, motion lets the head penetrate 0.1 mm
// deeper than replay does, and a collision found by replay costs another round of both.
constexpr double kMayMissMarginMm = 0.1 + kMarginMm;

Vector3d between(const Vector3d& a, const Vector3d& b, double t) {
  const double angle = angleBetween(a, b);
  if (angle < 1e-9)
    return a;
  if (angle > base::kPi - 1e-6) // Opposite directions: turn towards any side
    return Eigen::AngleAxisd(t * angle, a.unitOrthogonal()) * a;
  return ((std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle)).normalized();
}

class Orienter {
public:
  Orienter(const ToolPlan& plan, const std::vector<Vector3d>& clear, const HeadClearance& head,
           const PassScene& scene, const ToolpathOptions& o, const MayMiss& mayMiss,
           const base::RunContext& ctx)
      : plan_(plan), clear_(clear), scene_(scene), o_(o), mayMiss_(mayMiss), ctx_(ctx),
        head_(head) {
    middle_.resize(plan.waypointCount());
    for (std::size_t i = 0; i < middle_.size(); ++i)
      middle_[i] = plan.position[i] - 0.5 * plan.heightMm[i] * plan.direction[i];
  }

  // `holds`: first run the passes over unsupported beads. `part`: the plan's beads; nullptr: they
  // are deposited here.
  OrientResult run(bool holds, std::shared_ptr<const collision::GrowingPart> part) {
    if (!part) {
      const double pitch = collision::growingPitch(plan_, scene_.tooling);
      part = std::make_shared<const collision::GrowingPart>(
          plan_, pitch, ctx_, collision::groundCells(o_.platform, plan_, pitch, ctx_));
    }
    moved_.assign(middle_.size(), 0);
    leant_ = plan_.direction;
    if (holds)
      hold(part);
    ctx_.report(0.2, "directions"_text);
    choose(*part);
    ctx_.report(0.5, "directions"_text);
    smooth(*part);
    ctx_.report(0.6, "directions"_text);
    OrientResult r;
    r.plan = subdivided();
    if (r.plan.position != plan_.position || r.plan.direction != plan_.direction)
      part = collision::regrown(r.plan, *part, plan_, scene_.tooling, ctx_);
    judge(r, *part);
    r.grown = std::move(part);
    return r;
  }
  // Returns the findings of the passes, after run().
  plan::Findings passFindings() const {
    plan::Findings findings = passFindings_;
    for (const FindingOfDirections& findingOf : findingsOfDirections_)
      if (auto finding = findingOf(plan_, direction_))
        findings.push_back(std::move(*finding));
    return findings;
  }
  // Returns the clear directions, per waypoint of the result of run().
  const std::vector<Vector3d>& subdividedClear() const { return subdividedClear_; }

private:
  Vector3d tipAt(std::size_t i, const Vector3d& d) const {
    return middle_[i] + 0.5 * plan_.heightMm[i] * d;
  }
  bool clears(const collision::GrowingPart& part, std::size_t i, const Vector3d& d,
              double marginMm = 0.0) const {
    return head_.clears(part, tipAt(i, d), d, i, marginMm);
  }

  // Takes middles and tilts of unsupported beads from their passes.
  void hold(std::shared_ptr<const collision::GrowingPart> part) {
    PassedPlan passed =
        runUnsupportedPasses(PassPhase::WithDirections, plan_, {}, std::move(part), scene_, ctx_);
    passFindings_ = std::move(passed.findings);
    findingsOfDirections_ = std::move(passed.findingsOfDirections);
    if (!passed.isChanged)
      return;
    for (std::size_t i = 0; i < middle_.size(); ++i)
      moved_[i] = !(passed.beads.middle[i] - middle_[i]).isZero();
    middle_ = std::move(passed.beads.middle);
    leant_ = std::move(passed.beads.plan.direction);
  }

  std::optional<Vector3d> firstClear(const collision::GrowingPart& part, std::size_t i,
                                     double marginMm) const {
    const Vector3d &t = plan_.direction[i], &c = clear_[i];
    if (leant_[i] != t)
      for (const double share : {1.0, 0.75, 0.5})
        if (const Vector3d d = between(t, leant_[i], share); clears(part, i, d, marginMm))
          return d;
    if (clears(part, i, t, marginMm))
      return t;
    const double angle = angleBetween(t, c);
    const int n = std::max(1, static_cast<int>(std::ceil(angle / base::degreesToRadians(7.5))));
    for (int k = 1; k <= n; ++k)
      if (const Vector3d d = between(t, c, static_cast<double>(k) / n);
          clears(part, i, d, marginMm))
        return d;
    // Rings around the clear direction, then around the layer's own.
    for (const double tilt : {12.0, 24.0, 36.0, 48.0})
      for (const Vector3d* axis : {&c, &t}) {
        const Vector3d u = axis->unitOrthogonal();
        std::optional<Vector3d> best;
        for (int k = 0; k < 12; ++k) {
          const Vector3d side = Eigen::AngleAxisd(2 * base::kPi * k / 12, *axis) * u;
          const Vector3d d = std::cos(base::degreesToRadians(tilt)) * *axis +
                             std::sin(base::degreesToRadians(tilt)) * side;
          if ((!best || d.dot(t) > best->dot(t)) && clears(part, i, d, marginMm))
            best = d;
        }
        if (best)
          return best;
      }
    return std::nullopt;
  }

  // Returns the clear direction nearest to the layer's own, among directions 6 degrees apart: the
  // gap between two walls can be narrower than the spacing of the rings. `last`: the result for the
  // previous waypoint, which often still clears.
  std::optional<Vector3d> narrowClear(const collision::GrowingPart& part, std::size_t i,
                                      const std::optional<Vector3d>& last) const {
    constexpr int kSphere = 1000;
    const double minCosine = std::cos(base::degreesToRadians(75.0));
    const Vector3d& t = plan_.direction[i];
    if (last && last->dot(t) >= minCosine && clears(part, i, *last))
      return last;
    const Vector3d u = t.unitOrthogonal(), v = t.cross(u);
    for (int k = 0; k < kSphere; ++k) {
      const Vector3d p = geometry::onSpiral(k, 1.0 - (2.0 * k + 1.0) / kSphere);
      if (p.z() < minCosine)
        break;
      const Vector3d d = p.x() * u + p.y() * v + p.z() * t;
      if (clears(part, i, d))
        return d;
    }
    return std::nullopt;
  }

  void choose(const collision::GrowingPart& part) {
    direction_ = plan_.direction;
    if (!o_.canTilt)
      return;
    base::parallelChunks(ctx_, direction_.size(), kGrain, [&](std::size_t b, std::size_t e) {
      std::optional<Vector3d> narrow;
      for (std::size_t i = b; i < e; ++i) {
        if (i % 64 == 0 && ctx_.cancelled())
          return;
        std::optional<Vector3d> clear = firstClear(part, i, kMarginMm);
        if (!clear)
          clear = firstClear(part, i, 0.0);
        if (!clear)
          clear = narrow = narrowClear(part, i, narrow);
        direction_[i] = clear.value_or(clear_[i]);
      }
    });
    ctx_.checkpoint();
  }

  void smooth(const collision::GrowingPart& part) {
    const std::vector<Vector3d> before = direction_;
    const double limit = base::degreesToRadians(o_.smoothBeyondDeg);
    constexpr int kSpread = 4, kPasses = 12;
    std::vector<char> moved(direction_.size(), 0);
    for (const plan::ToolPath& path : plan_.paths)
      for (int pass = 0; pass < kPasses; ++pass) {
        std::vector<char> rough(path.count, 0);
        bool any = false;
        for (std::size_t k = 1; k < path.count; ++k)
          if (angleBetween(direction_[path.first + k - 1], direction_[path.first + k]) > limit) {
            any = true;
            const std::size_t from = k > kSpread ? k - kSpread : 0;
            for (std::size_t j = from; j < std::min(path.count, k + kSpread); ++j)
              rough[j] = 1;
          }
        if (!any)
          break;
        const std::vector<Vector3d> old(
            direction_.begin() + static_cast<std::ptrdiff_t>(path.first),
            direction_.begin() + static_cast<std::ptrdiff_t>(path.first + path.count));
        for (std::size_t k = 0; k < path.count; ++k) {
          if (!rough[k])
            continue;
          const Vector3d sum =
              old[k > 0 ? k - 1 : k] + 2 * old[k] + old[std::min(k + 1, path.count - 1)];
          if (sum.norm() < 1e-6)
            continue;
          direction_[path.first + k] = sum.normalized();
          moved[path.first + k] = 1;
        }
      }
    base::parallelChunks(ctx_, direction_.size(), kGrain, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e; ++i) {
        if (i % 64 == 0 && ctx_.cancelled())
          return;
        if (moved[i] && !clears(part, i, direction_[i], kMarginMm) && clears(part, i, before[i]))
          direction_[i] = before[i];
      }
    });
    ctx_.checkpoint();
  }

  ToolPlan subdivided() {
    const double limit = base::degreesToRadians(o_.maxBendDeg);
    ToolPlan out;
    out.fill = plan_.fill;
    subdividedClear_.clear();
    const auto add = [&](const Vector3d& middle, const Vector3d& d, float w, float h, float v) {
      out.position.push_back(middle + 0.5 * h * d);
      out.direction.push_back(d);
      out.widthMm.push_back(w);
      out.heightMm.push_back(h);
      out.speedMmPerS.push_back(v);
    };
    for (plan::ToolPath path : plan_.paths) {
      const std::size_t first = out.waypointCount();
      for (std::size_t i = path.first; i < path.first + path.count; ++i) {
        if (i > path.first) {
          const double bend = angleBetween(direction_[i - 1], direction_[i]);
          const int n = static_cast<int>(std::ceil(bend / limit - 1e-9));
          for (int k = 1; k < n; ++k) {
            const double t = static_cast<double>(k) / n;
            const auto mix = [&](const std::vector<float>& x) {
              return static_cast<float>((1 - t) * x[i - 1] + t * x[i]);
            };
            add((1 - t) * middle_[i - 1] + t * middle_[i],
                between(direction_[i - 1], direction_[i], t), mix(plan_.widthMm),
                mix(plan_.heightMm), plan_.speedMmPerS[i]);
            subdividedClear_.push_back(between(clear_[i - 1], clear_[i], t));
          }
        }
        add(middle_[i], direction_[i], plan_.widthMm[i], plan_.heightMm[i], plan_.speedMmPerS[i]);
        if (!moved_[i] && direction_[i] == plan_.direction[i])
          out.position.back() = plan_.position[i]; // Keep the position to the last bit
        subdividedClear_.push_back(clear_[i]);
      }
      path.first = first;
      path.count = out.waypointCount() - first;
      out.paths.push_back(path);
    }
    return out;
  }

  // Evaluates the result with its own beads and waypoints.
  void judge(OrientResult& r, const collision::GrowingPart& part) const {
    const ToolPlan& p = r.plan;
    r.maxRotationDeg = maxRotationDeg(p);
    ctx_.report(0.8, "directions"_text);
    std::vector<double> marginMm(p.waypointCount(), 0.0);
    for (const plan::ToolPath& path : p.paths)
      if (mayMiss_ && mayMiss_(path))
        std::fill_n(marginMm.begin() + static_cast<std::ptrdiff_t>(path.first), path.count,
                    kMayMissMarginMm);
    std::vector<char>& gouge = r.gouging;
    gouge.assign(p.waypointCount(), 0);
    base::parallelChunks(ctx_, gouge.size(), kGrain, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e; ++i) {
        if (i % 64 == 0 && ctx_.cancelled())
          return;
        gouge[i] = !head_.clears(part, p.position[i], p.direction[i], i, marginMm[i]);
      }
    });
    ctx_.checkpoint();
    r.gouges = static_cast<std::size_t>(std::ranges::count(gouge, 1));
    if (r.gouges == 0)
      return;
    const auto first = static_cast<std::size_t>(std::ranges::find(gouge, 1) - gouge.begin());
    r.findings.push_back(
        plan::makeFinding(plan::FindingKind::Gouge, {}, p.position[first], r.gouges));
    // Motion skips waypoints where the head would collide; a few of them do not block the plan.
    double length = 0.0, gouged = 0.0;
    for (const plan::ToolPath& path : p.paths)
      for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
        const double step = (p.position[i] - p.position[i - 1]).norm();
        length += step;
        if (gouge[i] || gouge[i - 1])
          gouged += step;
      }
    r.findings.back().blocking = gouged > plan::kBlockingShare * length;
  }

  const ToolPlan& plan_;
  const std::vector<Vector3d>& clear_;
  const PassScene& scene_;
  const ToolpathOptions& o_;
  const MayMiss& mayMiss_;
  const base::RunContext ctx_;
  const HeadClearance& head_;
  std::vector<Vector3d> middle_, direction_, subdividedClear_;
  std::vector<Vector3d> leant_; // The plan's own directions, or tilted ones
  std::vector<char> moved_;     // Whether the middle was moved
  plan::Findings passFindings_;
  std::vector<FindingOfDirections> findingsOfDirections_;
};
} // namespace

OrientResult orientDirections(const ToolPlan& plan, const std::vector<Vector3d>& clearDirection,
                              const robot::Cell& cell, const process::Tooling& tooling,
                              const ToolpathOptions& options, const base::RunContext& ctx,
                              const MayMiss& mayMiss,
                              std::shared_ptr<const collision::GrowingPart> grown) {
  base::require(clearDirection.size() == plan.waypointCount(), "one clear direction per waypoint");
  if (plan.waypointCount() == 0)
    return {};
  // Tilting moves tips and beads a little, and subdividing adds waypoints. Repeat for the waypoints
  // that are not clear afterwards, as long as their number decreases.
  constexpr int kRounds = 4;
  // The cell has the head of the first tool.
  const HeadClearance head(cell, tooling.first().process);
  const PassScene scene{cell, tooling, options.platform, {}, options.canTilt};
  ToolPlan current = plan;
  std::vector<Vector3d> clear = clearDirection;
  OrientResult best;
  plan::Findings passFindings;
  for (int round = 0; round < kRounds; ++round) {
    Orienter orienter(current, clear, head, scene, options, mayMiss,
                      round == 0 ? ctx.sub(0.0, 0.7) : ctx.sub(0.7, 1.0));
    OrientResult result = orienter.run(round == 0, std::exchange(grown, {}));
    if (round == 0)
      passFindings = orienter.passFindings();
    if (round > 0 && result.gouges >= best.gouges)
      break;
    best = std::move(result);
    if (best.gouges == 0)
      break;
    const std::vector<Vector3d>& ways = orienter.subdividedClear();
    std::vector<char> missed(best.gouging.size(), 0);
    if (mayMiss)
      for (const plan::ToolPath& path : best.plan.paths)
        if (mayMiss(path))
          std::copy_n(best.gouging.begin() + static_cast<std::ptrdiff_t>(path.first), path.count,
                      missed.begin() + static_cast<std::ptrdiff_t>(path.first));
    plan::RestOfPlan rest = plan::without(best.plan, missed);
    grown = best.grown;
    if (rest.waypoint.size() < best.plan.waypointCount())
      grown = collision::regrown(rest.plan, *grown, best.plan, tooling, ctx);
    clear.clear();
    for (const std::size_t i : rest.waypoint)
      clear.push_back(ways[i]);
    current = std::move(rest.plan);
  }
  std::ranges::move(passFindings, std::back_inserter(best.findings));
  return best;
}

} // namespace voluta::toolpath
