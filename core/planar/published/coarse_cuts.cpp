#include "planar/published/coarse_cuts.h"

#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "planar/face_table.h"
#include "planar/published/piece_merge.h"
#include "planar/published/section_cut.h"
#include "planar/search/plane_polish.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr int kTries = 64;
constexpr double kShiftShare = 0.025; // relative to the bounding box's diagonal
constexpr double kTiltRad = 0.0872664625997165;
constexpr double kSectionGrows = 1.2;
constexpr double kAnyFoot = 1e300; // no limit here: constrainedCut checks the contact area

// Gives the same numbers on every platform, which the standard library's distributions do not.
double uniform(std::mt19937& random) {
  return static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
}

Plane perturbed(const Plane& plane, const Vector3d& middle, double shiftMm, std::mt19937& random) {
  const PlaneFrame frame = frameOf(plane.normal);
  const double tilt = kTiltRad * std::sqrt(uniform(random)),
               angle = 2.0 * base::kPi * uniform(random);
  const Vector3d axis = std::cos(angle) * frame.across + std::sin(angle) * frame.along;
  const Vector3d normal = Eigen::AngleAxisd(tilt, axis) * plane.normal;
  return {normal, normal.dot(middle) + shiftMm * (2.0 * uniform(random) - 1.0)};
}

// Returns the piece whose own surface has most of the border.
std::size_t holderOf(const RegionPlane& at, const std::vector<Piece>& pieces) {
  std::vector<std::size_t> votes(pieces.size(), 0);
  std::vector<geometry::MeshQuery> queries;
  for (const Piece& piece : pieces)
    queries.emplace_back(piece.solid.mesh);
  for (const Vector3d& p : at.rim) {
    std::size_t nearest = 0;
    double minimum = 1e300;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (const double d = queries[i].closest(p, minimum).distance; d < minimum) {
        minimum = d;
        nearest = i;
      }
    ++votes[nearest];
  }
  return static_cast<std::size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

// Returns nullopt if no plane near the border may be used (PlanarOptions::lowestZ) and allows
// printing on its section.
std::optional<Plane> bestNear(const RegionPlane& at, const Piece& piece, int top, double shiftMm,
                              const PlanarOptions& options, std::mt19937& random) {
  const RiskRule& rule = options.rule;
  const FaceTable faces = faceTable(piece, rule);
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& p : at.rim)
    middle += p / static_cast<double>(at.rim.size());
  double maximum = std::numeric_limits<double>::infinity(); // largest area of the section
  std::optional<Plane> best;
  double gain = 0.0;
  const auto consider = [&](const Plane& plane) {
    const PlaneGain planned = planeGain(piece, faces, rule, plane, top, kAnyFoot);
    if (plane.normal.z() >= options.lowestZ && planned.allowed && planned.sectionMm2 <= maximum &&
        (!best || planned.gainMm2 > gain)) {
      gain = planned.gainMm2;
      best = plane;
    }
    return planned;
  };
  maximum = kSectionGrows * consider(at.plane).sectionMm2;
  for (int i = 0; i < kTries; ++i)
    consider(perturbed(at.plane, middle, shiftMm, random));
  return best;
}

// Cuts off only the solid with this point on its surface.
std::optional<PieceCut> cutAt(const Piece& piece, const Plane& plane, const Vector3d& beyond,
                              std::int32_t tag, const PlanarOptions& options,
                              const Footing& footing) {
  constexpr double kMovedMm = 2e-4; // shift of planes that do not close
  const auto distance = [&](const TaggedMesh& solid) {
    return geometry::MeshQuery(solid.mesh).closest(beyond).distance;
  };
  double minimum = std::numeric_limits<double>::infinity();
  constrainedCut(
      piece, plane, tag,
      [&](const TaggedMesh& solid) {
        minimum = std::min(minimum, distance(solid));
        return false;
      },
      options, footing, SectionContact::Apart);
  return constrainedCut(
      piece, plane, tag,
      [&](const TaggedMesh& solid) {
        return distance(solid) <= minimum + kMovedMm &&
               geometry::volume(solid.mesh) >= options.minVolumeMm3;
      },
      options, footing, SectionContact::Apart);
}

void mergePieces(std::vector<Piece>& pieces, const RiskRule& rule, const base::RunContext& ctx) {
  constexpr double kSame = 1e-6; // mm2
  while (true) {
    ctx.checkpoint();
    std::optional<Piece> best;
    double maximum = -kSame;
    std::size_t lower = 0, upper = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = 0; j < pieces.size(); ++j) {
        if (i == j || pieces[j].baseTag == kPlate)
          continue;
        auto one = merged(pieces[i], pieces[j]);
        if (!one)
          continue;
        const double gain =
            riskyArea(pieces[i], rule) + riskyArea(pieces[j], rule) - riskyArea(*one, rule);
        if (gain <= maximum)
          continue;
        maximum = gain;
        best = std::move(one);
        lower = i;
        upper = j;
      }
    if (!best)
      return;
    pieces[lower] = std::move(*best);
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(upper));
  }
}

} // namespace

std::vector<Piece> coarsePieces(Piece whole, const std::vector<RegionPlane>& planes,
                                const PlanarOptions& options, std::int32_t& firstTag,
                                const base::RunContext& ctx) {
  constexpr std::uint32_t kSeed = 7;
  std::mt19937 random(kSeed);
  const double shiftMm = kShiftShare * geometry::bounds(whole.solid.mesh).diagonal().norm();
  const Footing footing = footingOf(whole, options.rule);
  std::vector<Piece> pieces{std::move(whole)};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    ctx.report(static_cast<double>(i) / static_cast<double>(planes.size()), "pieces"_text);
    const std::size_t at = holderOf(planes[i], pieces);
    const int top = geometry::MeshQuery(pieces[at].solid.mesh).closest(planes[i].beyond).triangle;
    const auto plane = bestNear(planes[i], pieces[at], top, shiftMm, options, random);
    if (!plane)
      continue;
    auto cut = cutAt(pieces[at], *plane, planes[i].beyond, firstTag, options, footing);
    if (!cut)
      continue;
    firstTag += static_cast<std::int32_t>(cut->above.size());
    pieces[at] = std::move(cut->below);
    for (Piece& piece : cut->above)
      pieces.push_back(std::move(piece));
  }
  mergePieces(pieces, options.rule, ctx);
  return pieces;
}

} // namespace voluta::planar
