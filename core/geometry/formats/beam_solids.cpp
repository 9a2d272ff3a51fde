#include "geometry/formats/beam_solids.h"

#include "base/units.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace voluta::geometry {

using Eigen::Vector3d;

namespace {

constexpr int kSides = 16;        // of a beam's cross-section
constexpr int kBallDivisions = 2; // each splits a face of an icosahedron into four

using Ring = std::array<Vector3d, kSides>;

// Returns a polygon around `centre` with the area of the circle.
Ring ringOf(const Vector3d& centre, const Vector3d& u, const Vector3d& v, double radius) {
  constexpr double kSectorRad = 2.0 * base::kPi / kSides;
  const double corner = radius * std::sqrt(kSectorRad / std::sin(kSectorRad));
  Ring ring;
  for (int i = 0; i < kSides; ++i)
    ring[static_cast<std::size_t>(i)] =
        centre + corner * (std::cos(kSectorRad * i) * u + std::sin(kSectorRad * i) * v);
  return ring;
}

void addFrustum(const Vector3d& from, const Vector3d& to, const std::array<double, 2>& radii,
                std::vector<Facet>& facets) {
  const Vector3d axis = (to - from).normalized();
  const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const Ring low = ringOf(from, u, v, radii[0]), high = ringOf(to, u, v, radii[1]);
  for (std::size_t i = 0; i < kSides; ++i) {
    const std::size_t next = (i + 1) % kSides;
    facets.push_back({low[i], low[next], high[next]});
    facets.push_back({low[i], high[next], high[i]});
    facets.push_back({from, low[next], low[i]});
    facets.push_back({to, high[i], high[next]});
  }
}

std::vector<Facet> icosahedron() {
  constexpr double kGolden = 1.6180339887498949;
  std::array<Vector3d, 12> p;
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = i & 1 ? 1.0 : -1.0, b = i & 2 ? kGolden : -kGolden;
    p[i] = {0.0, a, b};
    p[4 + i] = {a, b, 0.0};
    p[8 + i] = {b, 0.0, a};
  }
  // The faces are the triples of vertices at the minimum distance, which is 2.
  std::vector<Facet> faces;
  const auto near = [](const Vector3d& a, const Vector3d& b) { return (a - b).norm() < 2.1; };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k) {
        if (!near(p[i], p[j]) || !near(p[j], p[k]) || !near(p[i], p[k]))
          continue;
        const bool outward = p[i].dot(p[j].cross(p[k])) > 0.0;
        faces.push_back({p[i], p[outward ? j : k], p[outward ? k : j]});
      }
  return faces;
}

// Returns a polyhedron about the origin with the volume of the unit ball.
std::vector<Facet> unitBall() {
  std::vector<Facet> faces = icosahedron();
  for (int division = 0; division < kBallDivisions; ++division) {
    std::vector<Facet> finer;
    for (const Facet& f : faces) {
      const Vector3d ab = f[0] + f[1], bc = f[1] + f[2], ca = f[2] + f[0];
      for (const Facet& part : {Facet{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}})
        finer.push_back(part);
      for (std::size_t i = finer.size() - 4; i < finer.size(); ++i)
        for (Vector3d& corner : finer[i])
          corner.normalize();
    }
    faces = std::move(finer);
  }
  double sum = 0.0;
  for (const Facet& f : faces)
    sum += f[0].dot(f[1].cross(f[2])) / 6.0;
  const double scale = std::cbrt(4.0 / 3.0 * base::kPi / sum);
  for (Facet& f : faces)
    for (Vector3d& corner : f)
      corner *= scale;
  return faces;
}

} // namespace

std::vector<Facet> beamSolids(const ThreemfObject& object) {
  std::map<long long, double> balls = object.balls;
  std::vector<Facet> facets;
  const auto at = [&](long long v) { return object.vertices[static_cast<std::size_t>(v)]; };
  for (const ThreemfBeam& beam : object.beams) {
    addFrustum(at(beam.ends[0]), at(beam.ends[1]), beam.radii, facets);
    for (std::size_t end = 0; end < 2; ++end)
      if (beam.round[end]) {
        double& radius = balls[beam.ends[end]];
        radius = std::max(radius, beam.radii[end]);
      }
  }
  const std::vector<Facet> ball = unitBall();
  for (const auto& [vertex, radius] : balls) {
    if (!(radius > 0.0))
      continue;
    for (const Facet& f : ball)
      facets.push_back(
          {at(vertex) + radius * f[0], at(vertex) + radius * f[1], at(vertex) + radius * f[2]});
  }
  return facets;
}

} // namespace voluta::geometry
