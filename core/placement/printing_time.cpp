#include "placement/printing_time.h"

#include "geometry/measures.h"
#include "process/bead_model.h"

#include <algorithm>
#include <cmath>

namespace voluta::placement {

namespace {
using process::Feature;
using process::Process;

double layersOf(double heightMm, const Process& p) {
  return std::ceil(heightMm / p.layerHeightMm - 1e-6);
}

// Returns the volume of a solid part that is printed in a second [mm3/s].
double rateOf(Feature feature, const Process& p) {
  const process::FeatureSettings& own = p.features.of(feature);
  const double section = process::beadArea(p.beadWidthMm, p.layerHeightMm);
  const double speed = own.speedMmPerS > 0.0 ? own.speedMmPerS : p.speedMmPerS;
  return std::min(section * speed, process::flowLimit(p) / own.flow);
}

double wallMm(const Process& p) {
  return p.overlapFactor * process::hatchOf(p.beadWidthMm, p.layerHeightMm);
}

double spiralSeconds(const StandingPart& part, const Filling& filling, const Process& p) {
  const double bottomMm = std::min(filling.bottomMm, part.heightMm);
  const double turns = part.heightMm > 0.0 ? 1.0 - bottomMm / part.heightMm : 0.0;
  const double section = process::beadArea(p.beadWidthMm, p.layerHeightMm);
  const double wallMm3 = turns * part.surface.outlinesMm2 / p.layerHeightMm * section;
  const double bottomMm3 = std::min(part.volumeMm3, bottomMm * part.contactMm2);
  return bottomMm3 / rateOf(Feature::Infill, p) + wallMm3 / rateOf(Feature::OuterWall, p);
}

double filledSeconds(const StandingPart& part, const Filling& filling, const Process& p) {
  const double wall = wallMm(p) * part.surface.outlinesMm2;
  const double outer = filling.walls > 0 ? std::min(part.volumeMm3, wall) : 0.0;
  const double inner = std::min(part.volumeMm3 - outer, std::max(0, filling.walls - 1) * wall);
  const double rest = part.volumeMm3 - outer - inner;
  const double sparse =
      filling.density < 1.0 ? std::min(rest, sparseVolume(part, filling, p)) : 0.0;
  return outer / rateOf(Feature::OuterWall, p) + inner / rateOf(Feature::InnerWall, p) +
         (rest - sparse) / rateOf(Feature::Infill, p) +
         filling.density * sparse / rateOf(Feature::SparseInfill, p);
}

// Of one layer: its walls and its interior begin with a prime, after a travel with ramps.
double startSeconds(const StandingPart& part, const Filling& filling, const Process& p) {
  const double ramp = p.travelSpeedMmPerS / p.accelerationMmPerS2;
  return (filling.walls + 1) * (p.primeS + ramp) + part.acrossMm / p.travelSpeedMmPerS;
}
} // namespace

StandingSurface standingSurface(const geometry::TriangleMesh& mesh, const Eigen::Vector3d& up) {
  StandingSurface surface;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = geometry::triangleArea(mesh, t);
    const double cosine = std::clamp(geometry::triangleNormal(mesh, t).dot(up), -1.0, 1.0);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    surface.outlinesMm2 += area * sine;
    if (sine >= std::abs(cosine))
      surface.steepMm2 += area * sine;
    else
      (cosine > 0.0 ? surface.upMm2 : surface.downMm2) += area * std::abs(cosine);
  }
  return surface;
}

double sparseVolume(const StandingPart& part, const Filling& filling, const Process& process) {
  if (part.volumeMm3 <= 0.0)
    return 0.0;
  const auto left = [&](double takenMm3) { return std::max(0.0, 1.0 - takenMm3 / part.volumeMm3); };
  const StandingSurface& s = part.surface;
  const double betweenSkins = left(filling.topMm * s.upMm2 + filling.bottomMm * s.downMm2);
  // Half of the walls for each of the two directions in which they narrow the part.
  const double betweenWalls = left(0.5 * filling.walls * wallMm(process) * s.steepMm2);
  return part.volumeMm3 * betweenSkins * betweenWalls * betweenWalls;
}

double estimatedSeconds(const StandingPart& part, const Filling& filling, const Process& process) {
  const double layers = layersOf(part.heightMm, process);
  const double withStarts =
      filling.spiral ? std::min(layers, layersOf(filling.bottomMm, process)) : layers;
  const double seconds = (filling.spiral ? spiralSeconds(part, filling, process)
                                         : filledSeconds(part, filling, process)) +
                         withStarts * startSeconds(part, filling, process);
  return std::max(seconds, layers * filling.minLayerS);
}

} // namespace voluta::placement
