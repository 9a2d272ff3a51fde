#include "modes/planar_platform.h"

#include "modes/cell_choice.h"
#include "robot/cell.h"
#include "robot/plate.h"

#include <algorithm>
#include <optional>

namespace voluta::modes {

planar::PlanarPlatform carrierOf(const project::Choices& choices, const process::Process& process) {
  const robot::Cell cell = cellOnAnyPlatform(choices, process);
  planar::PlanarPlatform out;
  if (const robot::Prism* plate = robot::plateOf(cell))
    out.thicknessMm = plate->zMax - plate->zMin;
  for (const robot::Body& body : cell.bodies()) {
    if (body.role != robot::BodyRole::Platform)
      continue;
    for (const robot::Shape& shape : body.shapes) {
      if (const auto* f = std::get_if<robot::Frustum>(&shape)) {
        const bool rises = f->p0.z() < f->p1.z();
        const double low = rises ? f->r0 : f->r1, high = rises ? f->r1 : f->r0;
        out.stem.push_back(
            {std::min(f->p0.z(), f->p1.z()), std::max(f->p0.z(), f->p1.z()), low, high});
      }
    }
  }
  return out;
}

planar::PlanarPlatform planarPlatform(planar::PlanarPlatform carrier,
                                      const project::Platform& platform,
                                      const std::vector<Eigen::Vector2d>& own) {
  const std::optional<double> margin = platform.marginMm();
  if (margin && own.empty())
    carrier.marginMm = *margin;
  else
    carrier.polygon = platform.plateAround(own);
  return carrier;
}

} // namespace voluta::modes
