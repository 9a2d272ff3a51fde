#include "motion/transfers/known_transfers.h"

#include "base/key_text.h"

namespace voluta::motion {

std::string KnownTransfers::keyOf(Purpose purpose, const RobotState& from, const RobotState& to,
                                  std::size_t fromWaypoint, std::size_t toWaypoint,
                                  const PrintedBounds& surround) {
  return base::keyText(purpose, fromWaypoint, toWaypoint, from.q, from.tip, from.tool.coeffs(),
                       from.axes, to.q, to.tip, to.tool.coeffs(), to.axes, surround.centre,
                       surround.radius);
}

} // namespace voluta::motion
