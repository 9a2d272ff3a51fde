// The kinds of cells that the advice on cells distinguishes (Boge 2019, table 6.7; Castelli
// 2020, 6.6).
#pragma once

#include "base/text.h"
#include "process/process.h"
#include "robot/cell.h"

namespace voluta::cells {

enum class CellForm {
  FixedNozzle,  // the arm holds the plate under a stationary nozzle
  TiltingTable, // the nozzle moves, turning axes carry the plate
  RaisedPlate,  // the nozzle moves, and the head has room beside and below the plate's level
  TableOnFloor, // the nozzle moves over a plate on a table or the floor
  Rod           // prints around a rod
};

// Properties of a form. Table 6.7 has marks for raised plate and table on the floor exchanged in
// the row of the small platform; its text decides.
struct CellTraits {
  base::Text name;
  bool largeParts = false, smallPlatform = false, gravityHelps = false;
};

CellForm formOf(const robot::Cell& cell, const process::Process& process);
const CellTraits& traitsOf(CellForm form);

// Returns the free height [mm] below the level of the plate: to the highest box of an obstacle that
// ends below it; infinite if there is none.
double freeBelowPlateMm(const robot::Cell& cell);

} // namespace voluta::cells
