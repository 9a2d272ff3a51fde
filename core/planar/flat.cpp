#include "planar/flat.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kMaxListed = 5;
constexpr double kMinMm2 = 1.0; // smaller places are no larger than a bead

struct Place {
  double areaMm2 = 0.0;
  Vector3d at = Vector3d::Zero(); // a point on the faces; their centroid may be off the surface
};

Vector3d middleOf(const geometry::TriangleMesh& mesh, std::size_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
}

// Returns the edge-connected groups of risky faces.
std::vector<Place> riskyPlaces(const Piece& piece, const RiskRule& rule) {
  const geometry::TriangleMesh faces = geometry::subMesh(piece.solid.mesh, riskyFaces(piece, rule));
  const geometry::Components parts = geometry::components(faces);
  const auto count = static_cast<std::size_t>(parts.count);
  std::vector<Place> places(count);
  std::vector<Vector3d> centre(count, Vector3d::Zero());
  for (std::size_t t = 0; t < faces.triangles.size(); ++t) {
    const auto place = static_cast<std::size_t>(parts.ofTriangle[t]);
    const double area = geometry::triangleArea(faces, t);
    places[place].areaMm2 += area;
    centre[place] += area * middleOf(faces, t);
  }
  for (std::size_t i = 0; i < count; ++i)
    if (places[i].areaMm2 > 0.0)
      centre[i] /= places[i].areaMm2;
  std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < faces.triangles.size(); ++t) {
    const auto place = static_cast<std::size_t>(parts.ofTriangle[t]);
    const Vector3d middle = middleOf(faces, t);
    if (const double d = (middle - centre[place]).squaredNorm(); d < nearest[place]) {
      nearest[place] = d;
      places[place].at = middle;
    }
  }
  return places;
}

} // namespace

plan::Findings overhangFindings(const std::vector<Piece>& pieces, const RiskRule& rule,
                                Overhangs of) {
  std::vector<Place> places;
  for (const Piece& piece : pieces) {
    const std::vector<Place> more = riskyPlaces(piece, rule);
    std::copy_if(more.begin(), more.end(), std::back_inserter(places),
                 [](const Place& place) { return place.areaMm2 >= kMinMm2; });
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.areaMm2 > b.areaMm2; });
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
