#include "planar/given_cuts.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "planar/piece_cut.h"
#include "planar/slicing/user_planes.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

namespace voluta::planar {

using Eigen::Vector3d;
using Json = nlohmann::json;

namespace {

constexpr double kOrderSpacingMm = 2.0;
// a plane crosses a piece if the piece extends further than this on both sides
constexpr double kCrossesMm = 1e-6;
constexpr int kWidths = 36; // number of directions searched for the minimum width

geometry::TriangleMesh sectionOf(const TaggedMesh& solid, std::int32_t tag) {
  std::vector<bool> keep(solid.tag.size());
  for (std::size_t t = 0; t < keep.size(); ++t)
    keep[t] = solid.tag[t] == tag;
  return geometry::subMesh(solid.mesh, keep);
}

Vector3d triangleMiddle(const geometry::TriangleMesh& mesh, std::size_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
}

bool crosses(const geometry::TriangleMesh& mesh, const Plane& plane) {
  bool above = false, below = false;
  for (const Vector3d& v : mesh.vertices) {
    const double h = plane.heightOf(v);
    above = above || h > kCrossesMm;
    below = below || h < -kCrossesMm;
  }
  return above && below;
}

double extent(const geometry::TriangleMesh& mesh, const Vector3d& direction) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vector3d& v : mesh.vertices) {
    low = std::min(low, direction.dot(v));
    high = std::max(high, direction.dot(v));
  }
  return high - low;
}

// Returns the minimum of a piece's height over its base and its widths parallel to the base.
double thinnest(const Piece& piece) {
  const PlaneFrame frame = frameOf(piece.base.normal);
  double minimum = extent(piece.solid.mesh, piece.base.normal);
  for (int k = 0; k < kWidths; ++k) {
    const double angle = base::kPi * k / kWidths;
    minimum = std::min(minimum, extent(piece.solid.mesh, std::cos(angle) * frame.across +
                                                             std::sin(angle) * frame.along));
  }
  return minimum;
}

[[noreturn]] void wrongCut(std::size_t index, const base::Message& what,
                           const base::Message& remedy) {
  throw base::Error(base::ErrorCode::UnusableInput, what,
                    base::message("cut {number}"_text, index + 1), remedy);
}

// The intersection of a cut's plane with the remaining pieces that is nearest to a point.
struct Place {
  std::size_t piece = 0;
  geometry::TriangleMesh solid; // the solid above the plane there
  double distanceMm = std::numeric_limits<double>::infinity();
};

// Updates the places of the points where sections of pieces[number] are nearer.
void findPlaces(const Plane& plane, const std::vector<Vector3d>& points, std::int32_t tag,
                const std::vector<Piece>& pieces, std::size_t number, std::size_t index,
                std::vector<Place>& places) {
  const Piece& piece = pieces[number];
  if (!crosses(piece.solid.mesh, plane))
    return;
  PlaneCut sides;
  try {
    sides = cutByPlane(piece.solid, plane, tag);
  } catch (const base::Error& e) {
    wrongCut(index, e.message(), "move or tilt the plane slightly"_text);
  }
  for (std::size_t s = 0; s < sides.above.size(); ++s) {
    const geometry::TriangleMesh section =
        sectionOf(sides.above[s], tag + static_cast<std::int32_t>(s));
    if (section.empty())
      continue;
    const geometry::MeshQuery query(section);
    for (std::size_t p = 0; p < points.size(); ++p)
      if (const double distance = query.closest(points[p]).distance;
          distance < places[p].distanceMm)
        places[p] = {number, sides.above[s].mesh, distance};
  }
}

// Returns the places of the cut's point and of its further points, all in one piece; none if the
// plane misses the part.
std::vector<Place> placesOf(const GivenCut& cut, std::int32_t tag, const std::vector<Piece>& pieces,
                            std::size_t index) {
  std::vector<Place> first(1);
  for (std::size_t p = 0; p < pieces.size(); ++p)
    findPlaces(cut.plane, {cut.point}, tag, pieces, p, index, first);
  if (first[0].solid.empty())
    return {};
  std::vector<Place> more(cut.also.size());
  findPlaces(cut.plane, cut.also, tag, pieces, first[0].piece, index, more);
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

void requireBead(const Piece& piece, std::size_t index, double minMm) {
  if (const double mm = thinnest(piece); mm < minMm)
    wrongCut(index,
             base::message("leaves a piece only {thickness:.2g} thick, thinner than a "
                           "bead ({least})"_text,
                           base::mm(mm), base::mm(minMm)),
             "move the plane or remove it"_text);
}

// Returns the point of a section nearest to its centroid, which is not on it if it is a ring.
std::optional<Vector3d> sectionMiddle(const geometry::TriangleMesh& section) {
  Vector3d middle = Vector3d::Zero();
  double area = 0.0;
  for (std::size_t t = 0; t < section.triangles.size(); ++t) {
    const double a = geometry::triangleArea(section, t);
    middle += a * triangleMiddle(section, t);
    area += a;
  }
  if (!(area > 0.0))
    return std::nullopt;
  return geometry::MeshQuery(section).closest(middle / area).point;
}

// Returns the points "also" of an entry.
std::vector<Vector3d> furtherPoints(const Json& entry, const std::string& where) {
  std::vector<Vector3d> points;
  if (!entry.contains("also") || entry["also"].empty())
    return points;
  Json planes = Json::array();
  for (const Json& point : entry["also"])
    planes.push_back({{"point", point}, {"normal", entry["normal"]}});
  for (const UserPlane& p : readUserPlanes(planes.dump(), where))
    points.push_back(p.point);
  return points;
}

} // namespace

std::vector<GivenCut> readGivenCuts(const std::string& json, const std::string& where) {
  std::vector<GivenCut> cuts;
  const std::vector<UserPlane> planes = readUserPlanes(json, where);
  const Json list = Json::parse(json);
  for (const UserPlane& p : planes) {
    if (!p.corners.empty())
      throw base::Error(base::ErrorCode::UnusableInput, "a quadrilateral cannot cut a part"_text,
                        base::message("{where}, entry {number}"_text, where, cuts.size() + 1),
                        "give planes: {\"point\": [x, y, z], \"normal\": [x, y, z]}"_text);
    cuts.push_back({p.point, p.plane, furtherPoints(list[cuts.size()], where)});
  }
  return cuts;
}

std::string givenCutsText(const std::vector<GivenCut>& cuts) {
  Json list = Json::array();
  for (const GivenCut& cut : cuts) {
    const Vector3d &p = cut.point, &n = cut.plane.normal;
    list.push_back({{"point", {p.x(), p.y(), p.z()}}, {"normal", {n.x(), n.y(), n.z()}}});
    for (const Vector3d& q : cut.also)
      list.back()["also"].push_back({q.x(), q.y(), q.z()});
  }
  return list.dump();
}

std::vector<std::size_t> cutPieces(const std::vector<Piece>& pieces) {
  std::vector<std::size_t> order;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    if (pieces[p].baseTag >= 0)
      order.push_back(p);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return pieces[a].baseTag < pieces[b].baseTag;
  });
  return order;
}

std::vector<GivenCut> cutsOf(const std::vector<Piece>& pieces) {
  std::vector<GivenCut> cuts;
  for (const std::size_t p : cutPieces(pieces)) {
    const Piece& piece = pieces[p];
    GivenCut cut{piece.base.offsetMm * piece.base.normal, piece.base, {}};
    for (const TaggedMesh& solid : solids(piece.solid))
      if (const auto middle = sectionMiddle(sectionOf(solid, piece.baseTag)))
        cut.also.push_back(*middle);
    if (!cut.also.empty()) {
      cut.point = cut.also.front();
      cut.also.erase(cut.also.begin());
    }
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

std::vector<Piece> cutApart(Piece whole, const std::vector<GivenCut>& cuts, const RiskRule& rule,
                            double minMm, const base::RunContext& ctx) {
  std::vector<Piece> pieces;
  pieces.push_back(std::move(whole));
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    ctx.report(static_cast<double>(i) / static_cast<double>(cuts.size()), "cutting"_text);
    const auto tag = static_cast<std::int32_t>(i);
    const std::vector<Place> places = placesOf(cuts[i], tag, pieces, i);
    if (places.empty())
      wrongCut(i, "the plane misses the part"_text, "move it so that it crosses the part"_text);
    Piece& piece = pieces[places.front().piece];
    const Wanted wanted = [&](const TaggedMesh& solid) {
      return std::any_of(places.begin(), places.end(), [&](const Place& place) {
        return solid.mesh.vertices == place.solid.vertices;
      });
    };
    std::optional<PieceCut> cut = splitPiece(piece, cuts[i].plane, tag, wanted, rule);
    if (!cut)
      wrongCut(i, "leaves a piece without a base"_text,
               "move the plane, or point its normal to the side to cut off"_text);
    requireBead(cut->below, i, minMm);
    for (const Piece& above : cut->above)
      requireBead(above, i, minMm);
    PieceCut one = joined(std::move(*cut));
    piece = std::move(one.below);
    pieces.push_back(std::move(one.above.front()));
  }
  return pieces;
}

PlanarDecomposition decomposeByCuts(const geometry::TriangleMesh& part,
                                    const std::vector<GivenCut>& cuts, const PlanarOptions& options,
                                    double minMm, const base::RunContext& ctx) {
  if (part.empty() || !isClosed(part))
    throw base::Error(base::ErrorCode::UnusableInput, "the mesh is not closed"_text, {},
                      "repair it, or use curved mode, which takes any mesh"_text);
  const base::Stopwatch watch;
  PlanarDecomposition out;
  Piece whole = wholePart(part, options.rule);
  out.riskyBeforeMm2 = riskyArea(whole, options.rule);
  std::vector<Piece> pieces =
      cutApart(std::move(whole), cuts, options.rule, minMm, ctx.sub(0.0, 0.9));
  out.pieces = printOrder(std::move(pieces), options, kOrderSpacingMm, out.blockedPieces);
  for (const Piece& piece : out.pieces) {
    out.riskyMm2 += riskyArea(piece, options.rule);
    out.sectionMm2 += piece.baseTag == kPlate ? 0.0 : baseArea(piece, options.rule);
  }
  out.seconds.cut = watch.seconds();
  ctx.report(1.0, "pieces"_text);
  return out;
}

} // namespace voluta::planar
