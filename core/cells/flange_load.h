// The load on a cell's flange against what its robot carries at the load's lever.
#pragma once

#include "process/process.h"
#include "robot/cell.h"

#include <optional>

namespace voluta::cells {

struct FlangeLoad {
  double kg = 0.0;
  double leverMm = 0.0;        // distance of the load's centre from the flange
  std::optional<double> maxKg; // that the robot carries at this lever; nullopt: unknown
  bool byCurve = false;        // maxKg is from the robot's payload curve, not only its rating

  bool carried() const { return !maxKg || kg <= *maxKg; }
};

// Returns the load once everything is printed. A plate on the flange has its mass at its top and
// carries `onPlateKg` (part and body) with the centre `centreMm` above it; a head on the flange has
// its mass in the middle of its height.
FlangeLoad flangeLoad(const robot::Cell& cell, const process::Process& process, double onPlateKg,
                      double centreMm);

} // namespace voluta::cells
