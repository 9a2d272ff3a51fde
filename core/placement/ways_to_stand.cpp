#include "placement/ways_to_stand.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/units.h"
#include "geometry/convex_polygon.h"
#include "geometry/directions.h"
#include "geometry/measures.h"
#include "geometry/placement.h"
#include "placement/coarse_growth.h"
#include "placement/resting_places.h"
#include "plan/blocking_share.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace voluta::placement {

namespace {

using geometry::angleBetween;

// Minimum cell width as a share of the bounding box's diagonal: a sheet has little volume for its
// size.
constexpr double kMinCell = 0.005;
constexpr std::size_t kPlaces = 48, kGrown = 10;
constexpr double kMinShare = 0.125; // of the largest contact; less is an edge or a few corners
constexpr double kBroader = 4.0; // ratio of the better orientation's contact to that of a poor one

// An orientation before it is grown.
struct Candidate {
  Eigen::Vector3d down; // in the mesh's frame
  OrientationScore score;
  double angle = 0.0; // from the present orientation

  Eigen::Quaterniond rotation() const { return geometry::rotationLayingFlat(down); }
};

// Returns the overhanging area per contact area.
double overhangShare(const OrientationScore& s) {
  return s.riskyMm2 / std::max(s.contactMm2, 1e-9);
}

bool isPoorFoot(const OrientationScore& now, const OrientationScore& better) {
  const bool small =
      kBroader * now.contactMm2 < better.contactMm2 && better.riskyMm2 <= now.riskyMm2;
  const bool burdened =
      now.riskyMm2 > now.contactMm2 && kBroader * overhangShare(better) < overhangShare(now);
  return small || burdened;
}

// The footprint of a rotated part: its minimum bounding rectangle.
struct Footprint {
  double angle = 0.0;    // of its longer side, towards the end with more of the volume
  double acrossMm = 0.0; // its diagonal
};
Footprint footprint(const geometry::TriangleMesh& mesh, const Eigen::Matrix3d& rotation,
                    const Eigen::Vector3d& centre) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& v : mesh.vertices)
    points.emplace_back((rotation * v).head<2>());
  const std::vector<Eigen::Vector2d> hull = geometry::convexPolygon(std::move(points));
  Footprint best;
  double minimum = -1.0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
    const Eigen::Vector2d across(-along.y(), along.x());
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : hull)
      box.extend(Eigen::Vector2d(p.dot(along), p.dot(across)));
    const Eigen::Vector2d size = box.sizes();
    if (minimum >= 0.0 && size.prod() >= minimum)
      continue;
    minimum = size.prod();
    Eigen::Vector2d longer = size.x() >= size.y() ? along : across;
    const Eigen::Vector2d middle = box.center().x() * along + box.center().y() * across;
    if (((rotation * centre).head<2>() - middle).dot(longer) < 0.0)
      longer = -longer;
    best = {std::atan2(longer.y(), longer.x()), size.norm()};
  }
  return best;
}

class OrientationSearch {
public:
  OrientationSearch(const geometry::TriangleMesh& mesh, const WaysOptions& options,
                    const base::RunContext& ctx)
      : mesh_(mesh), options_(options), ctx_(ctx),
        // A chamfer of exactly that angle is not an overhang, regardless of rounding.
        measure_(mesh, options.layerHeightMm, options.overhangRad + 1e-3),
        area_(geometry::area(mesh)), now_(candidate(-Eigen::Vector3d::UnitZ())) {
    for (Candidate& c : scored())
      add(std::move(c));
    const double minimum =
        std::max(options.layerHeightMm, kMinCell * geometry::bounds(mesh).diagonal().norm());
    widthMm_ = coarseWidth(mesh, upright(places_.empty() ? now_ : places_.front()).first, minimum,
                           options.voxels, ctx.sub(0.0, 0.1));
  }

  std::vector<StandingOrientation> ways() {
    std::vector<Candidate> chosen = promising();
    if (now_.score.stands) {
      std::erase_if(chosen, [&](const Candidate& c) { return same(c, now_); });
      chosen.insert(chosen.begin(), now_);
    }
    std::vector<StandingOrientation> ways = grown(chosen, ctx_.sub(0.1, 1.0));
    if (now_.score.stands && !ways.empty())
      ways.front().now = true;
    std::ranges::stable_sort(ways, {}, rank);
    if (ways.size() > options_.maxCount) {
      const auto last = ways.begin() + static_cast<std::ptrdiff_t>(options_.maxCount) - 1;
      const auto now = std::ranges::find_if(ways, &StandingOrientation::now);
      if (now != ways.end() && now > last)
        std::iter_swap(now, last);
      ways.resize(options_.maxCount);
    }
    return ways;
  }

  StandingOrientation asItLies() {
    StandingOrientation orientation = grown({now_}, ctx_.sub(0.1, 0.2)).front();
    orientation.now = true;
    return orientation;
  }

  // Returns whether the present orientation can be poor at all, whatever it misses.
  bool mayLieBadly(const StandingOrientation& now) const {
    return !now.score.stands || now.missedShare() > plan::kBlockingShare ||
           std::ranges::any_of(places_,
                               [&](const Candidate& c) { return isPoorFoot(now.score, c.score); });
  }

private:
  Candidate candidate(const Eigen::Vector3d& down) const {
    Candidate c;
    c.down = down;
    c.score = measure_.of(c.rotation().toRotationMatrix());
    c.angle = angleBetween(down, -Eigen::Vector3d::UnitZ());
    return c;
  }

  // Returns the orientations in which the part stands, largest contact first.
  std::vector<Candidate> scored() const {
    std::vector<Eigen::Vector3d> downs = restingPlaces(mesh_, kPlaces);
    if (options_.quarterTurns)
      std::erase_if(downs,
                    [](const Eigen::Vector3d& d) { return d.cwiseAbs().maxCoeff() < 0.999; });
    std::vector<Candidate> all(downs.size());
    base::parallelChunks(ctx_.quiet(), downs.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
        all[n] = candidate(measure_.settled(downs[n]));
    });
    const auto contact = [](const Candidate& c) { return c.score.contactMm2; };
    std::ranges::stable_sort(all, std::ranges::greater{}, contact);
    const double minimum = all.empty() ? 0.0 : kMinShare * contact(all.front());
    std::erase_if(all, [&](const Candidate& c) {
      return !c.score.stands || contact(c) < minimum ||
             !measure_.balances(c.rotation().toRotationMatrix());
    });
    return all;
  }

  void add(Candidate c) {
    constexpr double kNear = base::degreesToRadians(15.0), kAsNear = 1e-6;
    for (Candidate& other : places_) {
      if (same(c, other)) {
        if (c.angle < other.angle - kAsNear)
          other = std::move(c);
        return;
      }
      if (angleBetween(c.down, other.down) < kNear)
        return;
    }
    places_.push_back(std::move(c));
  }

  // Returns whether both agree within one per cent: the same direction, or directions that a
  // symmetry maps to each other.
  bool same(const Candidate& a, const Candidate& b) const {
    const auto within = [](double x, double y, double of) { return std::abs(x - y) <= 0.01 * of; };
    const OrientationScore &p = a.score, &q = b.score;
    return within(p.contactMm2, q.contactMm2, std::max(p.contactMm2, q.contactMm2)) &&
           within(p.heightMm, q.heightMm, p.heightMm) && within(p.riskyMm2, q.riskyMm2, area_) &&
           within(p.middleMm, q.middleMm, p.heightMm);
  }

  // Returns the candidates worth a growth: those with the largest contact and those with the
  // smallest overhang.
  std::vector<Candidate> promising() const {
    if (places_.size() <= kGrown)
      return places_;
    std::vector<Candidate> chosen(places_.begin(), places_.begin() + kGrown / 2);
    std::vector<Candidate> rest(places_.begin() + kGrown / 2, places_.end());
    std::ranges::stable_sort(rest, {}, [](const Candidate& c) { return overhangShare(c.score); });
    chosen.insert(chosen.end(), rest.begin(), rest.begin() + kGrown / 2);
    return chosen;
  }

  static std::tuple<double, double, double> rank(const StandingOrientation& w) {
    return {std::floor(w.missedShare() / plan::kBlockingShare), overhangShare(w.score),
            w.score.heightMm};
  }

  // Returns a rotation that is also normalized about the vertical, so that the voxels do not depend
  // on the mesh's present orientation.
  std::pair<Eigen::Quaterniond, Footprint> upright(const Candidate& c) const {
    const Eigen::Quaterniond rotation = c.rotation();
    const Footprint foot = footprint(mesh_, rotation.toRotationMatrix(), measure_.centre());
    return {Eigen::Quaterniond(Eigen::AngleAxisd(-foot.angle, Eigen::Vector3d::UnitZ()) * rotation),
            foot};
  }

  std::vector<StandingOrientation> grown(const std::vector<Candidate>& chosen,
                                         const base::RunContext& ctx) const {
    std::vector<StandingOrientation> ways;
    std::vector<Eigen::Quaterniond> turns;
    const double volume = std::abs(geometry::volume(mesh_));
    for (const Candidate& c : chosen) {
      const auto& [rotation, foot] = upright(c);
      turns.push_back(rotation);
      StandingOrientation orientation;
      orientation.rotation = c.rotation();
      orientation.score = c.score;
      orientation.voxelMm = widthMm_;
      orientation.part = {volume, c.score.heightMm, c.score.contactMm2, foot.acrossMm,
                          standingSurface(mesh_, -c.down)};
      ways.push_back(orientation);
    }
    const std::vector<CoarseGrowth> growths = coarseGrowths(mesh_, turns, {widthMm_}, ctx);
    for (std::size_t n = 0; n < ways.size(); ++n) {
      ways[n].voxels = growths[n].voxels;
      ways[n].missed = growths[n].missed;
    }
    return ways;
  }

  const geometry::TriangleMesh& mesh_;
  const WaysOptions& options_;
  const base::RunContext& ctx_;
  OrientationMeasure measure_;
  double area_;
  Candidate now_;
  std::vector<Candidate> places_; // distinct
  double widthMm_ = 0.0;
};

void check(const geometry::TriangleMesh& mesh, const WaysOptions& options) {
  base::require(!mesh.empty() && options.maxCount >= 1, "waysToStand: facets, a way or more");
}

} // namespace

double StandingOrientation::missedShare() const {
  return voxels > 0 ? static_cast<double>(missed) / static_cast<double>(voxels) : 0.0;
}

std::vector<StandingOrientation> waysToStand(const geometry::TriangleMesh& mesh,
                                             const WaysOptions& options,
                                             const base::RunContext& ctx) {
  check(mesh, options);
  std::vector<StandingOrientation> ways = OrientationSearch(mesh, options, ctx).ways();
  ctx.report(1.0, "orientations"_text);
  return ways;
}

bool liesBadly(const StandingOrientation& now, const StandingOrientation& better) {
  if (!now.score.stands)
    return better.score.stands;
  const double is = now.missedShare(), canBe = better.missedShare();
  if (is > canBe + plan::kBlockingShare && is > 2.0 * canBe)
    return true;
  return canBe <= is + plan::kBlockingShare && isPoorFoot(now.score, better.score);
}

std::optional<BetterOrientation> betterOrientation(const geometry::TriangleMesh& mesh,
                                                   const WaysOptions& options,
                                                   const base::RunContext& ctx) {
  check(mesh, options);
  OrientationSearch search(mesh, options, ctx);
  const StandingOrientation now = search.asItLies();
  if (!search.mayLieBadly(now))
    return std::nullopt;
  const std::vector<StandingOrientation> ways = search.ways();
  if (ways.empty() || ways.front().now || !liesBadly(now, ways.front()))
    return std::nullopt;
  return BetterOrientation{now, ways.front()};
}

} // namespace voluta::placement
