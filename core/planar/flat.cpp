#include "planar/flat.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <limits>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kMaxListed = 5;
constexpr double kMinMm2 = 1.0;   // smaller places are no larger than a bead
constexpr double kSampleMm = 1.0; // longest edge of the triangles that a face is judged by

struct Place {
  double areaMm2 = 0.0;
  Vector3d at = Vector3d::Zero(); // a point on the faces; their centroid may be off the surface
};

using Corners = std::array<Vector3d, 3>;

Vector3d middleOf(const Corners& c) {
  return (c[0] + c[1] + c[2]) / 3.0;
}

// Calls `take` for the area and the middle of each part of a triangle that is not supported.
// `isOpen`: of a place; null: all of it.
template <typename Take>
void eachOpenPart(const Corners& c, const std::function<bool(const Vector3d&)>& isOpen,
                  const Take& take) {
  std::size_t longest = 0;
  for (std::size_t k = 1; k < c.size(); ++k)
    if ((c[(k + 1) % 3] - c[k]).norm() > (c[(longest + 1) % 3] - c[longest]).norm())
      longest = k;
  const Vector3d &a = c[longest], &b = c[(longest + 1) % 3], &top = c[(longest + 2) % 3];
  if (isOpen && (b - a).norm() > kSampleMm) {
    const Vector3d half = 0.5 * (a + b);
    eachOpenPart({a, half, top}, isOpen, take);
    eachOpenPart({half, b, top}, isOpen, take);
  } else if (!isOpen || isOpen(middleOf(c))) {
    take(0.5 * (b - a).cross(top - a).norm(), middleOf(c));
  }
}

// Returns the edge-connected groups of risky faces, with the area that is open.
std::vector<Place> riskyPlaces(const Piece& piece, const RiskRule& rule,
                               const std::function<bool(const Vector3d&)>& isOpen) {
  const geometry::TriangleMesh faces = geometry::subMesh(piece.solid.mesh, riskyFaces(piece, rule));
  const geometry::Components parts = geometry::components(faces);
  const auto count = static_cast<std::size_t>(parts.count);
  std::vector<Place> places(count);
  std::vector<Vector3d> centre(count, Vector3d::Zero());
  const auto eachPart = [&](const auto& take) {
    for (std::size_t t = 0; t < faces.triangles.size(); ++t)
      eachOpenPart({faces.corner(t, 0), faces.corner(t, 1), faces.corner(t, 2)}, isOpen,
                   [&](double mm2, const Vector3d& middle) {
                     take(static_cast<std::size_t>(parts.ofTriangle[t]), mm2, middle);
                   });
  };
  eachPart([&](std::size_t place, double mm2, const Vector3d& middle) {
    places[place].areaMm2 += mm2;
    centre[place] += mm2 * middle;
  });
  for (std::size_t i = 0; i < count; ++i)
    if (places[i].areaMm2 > 0.0)
      centre[i] /= places[i].areaMm2;
  std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
  eachPart([&](std::size_t place, double, const Vector3d& middle) {
    if (const double d = (middle - centre[place]).squaredNorm(); d < nearest[place]) {
      nearest[place] = d;
      places[place].at = middle;
    }
  });
  return places;
}

// Returns the places of all pieces that are larger than a bead, the largest first. `supports`: of
// the part; null: none.
std::vector<Place> openPlaces(const std::vector<Piece>& pieces, const RiskRule& rule,
                              const layers::SupportRules* supports) {
  std::vector<Place> places;
  for (const Piece& piece : pieces) {
    // Columns are made for the sections half a layer above a face.
    const Vector3d lift = rule.contactMm * piece.base.normal;
    std::function<bool(const Vector3d&)> isOpen;
    if (supports)
      isOpen = [&](const Vector3d& at) {
        return supports->at(at + lift) == layers::SupportRule::None;
      };
    std::ranges::copy_if(riskyPlaces(piece, rule, isOpen), std::back_inserter(places),
                         [](const Place& place) { return place.areaMm2 >= kMinMm2; });
  }
  std::ranges::stable_sort(places, std::greater(), &Place::areaMm2);
  return places;
}

plan::Findings findingsOf(const std::vector<Place>& places, const RiskRule& rule, Overhangs of) {
  using plan::FindingKind;
  const bool flat = of == Overhangs::Flat;
  plan::Findings findings;
  for (std::size_t i = 0; i < std::min(kMaxListed, places.size()); ++i)
    findings.push_back(
        plan::makeFinding(flat ? FindingKind::OverhangOfFlat : FindingKind::OverhangOfPieces,
                          {{"area", base::mm2(places[i].areaMm2)},
                           {"angle", base::degrees(base::radiansToDegrees(rule.overhangRad))}},
                          places[i].at));
  if (places.size() > kMaxListed) {
    double rest = 0.0;
    for (std::size_t i = kMaxListed; i < places.size(); ++i)
      rest += places[i].areaMm2;
    findings.push_back(
        plan::makeFinding(flat ? FindingKind::OverhangsOfFlat : FindingKind::OverhangsOfPieces,
                          {{"places", places.size() - kMaxListed}, {"area", base::mm2(rest)}},
                          places[kMaxListed].at, places.size() - kMaxListed));
  }
  return findings;
}

} // namespace

plan::Findings overhangFindings(const std::vector<Piece>& pieces, const RiskRule& rule,
                                Overhangs of) {
  return findingsOf(openPlaces(pieces, rule, nullptr), rule, of);
}

plan::Findings openOverhangFindings(const std::vector<Piece>& pieces, const RiskRule& rule,
                                    Overhangs of, const layers::SupportRules& supports) {
  if (supports.otherwise() != layers::SupportRule::None && !supports.has(layers::SupportRule::None))
    return {};
  const std::vector<Place> open = openPlaces(pieces, rule, &supports);
  if (open.empty() || supports.otherwise() == layers::SupportRule::None)
    return findingsOf(open, rule, of);
  double mm2 = 0.0;
  for (const Place& place : open)
    mm2 += place.areaMm2;
  return {plan::makeFinding(plan::FindingKind::OverhangBlocked,
                            {{"area", base::mm2(mm2)},
                             {"angle", base::degrees(base::radiansToDegrees(rule.overhangRad))}},
                            open.front().at, open.size())};
}

PlanarDecomposition flatDecomposition(const geometry::TriangleMesh& part, const RiskRule& rule) {
  if (!isClosed(part))
    throw base::Error(base::ErrorCode::UnusableInput, "the mesh is not closed"_text, {},
                      "repair it, or use curved mode, which takes any mesh"_text);
  PlanarDecomposition out;
  Piece whole;
  whole.solid = tagged(part);
  out.pieces.push_back(std::move(whole));
  out.riskyBeforeMm2 = out.riskyMm2 = riskyArea(out.pieces.front(), rule);
  out.findings = overhangFindings(out.pieces, rule, Overhangs::Flat);
  return out;
}

} // namespace voluta::planar
