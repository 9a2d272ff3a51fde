#include "modes/planar_platform.h"

#include "modes/cell_choice.h"
#include "robot/cell.h"

#include <algorithm>
#include <fmt/format.h>

namespace voluta::modes {

namespace {

// Thickness of the plate and the frusta about z that carry it.
planar::PlanarPlatform carrierOf(const project::Choices& choices, const process::Process& process) {
  const robot::Cell cell = cellOnAnyPlatform(choices, process);
  planar::PlanarPlatform out;
  for (const robot::Body& body : cell.bodies()) {
    if (body.role != robot::BodyRole::Platform)
      continue;
    for (const robot::Shape& shape : body.shapes) {
      if (const auto* plate = std::get_if<robot::Prism>(&shape))
        out.thicknessMm = plate->zMax - plate->zMin;
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

} // namespace

planar::PlanarPlatform planarPlatform(const project::Choices& choices,
                                      const process::Process& process,
                                      const std::vector<Eigen::Vector2d>& own) {
  planar::PlanarPlatform out = carrierOf(choices, process);
  const std::optional<double> margin = choices.platform.marginMm();
  if (margin && own.empty())
    out.marginMm = *margin;
  else
    out.polygon = choices.platform.plateAround(own);
  return out;
}

std::string carrierText(const project::Choices& choices, const process::Process& process) {
  const planar::PlanarPlatform carrier = carrierOf(choices, process);
  std::string text = fmt::format("plate {}\n", carrier.thicknessMm);
  for (const planar::StemFrustum& f : carrier.stem)
    text += fmt::format("stem {} {} {} {}\n", f.lowMm, f.highMm, f.lowRadiusMm, f.highRadiusMm);
  return text;
}

} // namespace voluta::modes
