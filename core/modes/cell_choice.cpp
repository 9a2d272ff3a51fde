#include "modes/cell_choice.h"

#include "curved/platform_polygon.h"

namespace voluta::modes {

robot::Cell cellOnAnyPlatform(const project::Choices& choices, const process::Process& process) {
  constexpr double kAnyMm = 80.0;
  return robot::loadCell(choices.cell, process, curved::platformDisc(kAnyMm));
}

} // namespace voluta::modes
