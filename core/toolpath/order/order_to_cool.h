// An order of beads in which those below them have cooled for as long as possible.
#pragma once

#include "toolpath/order/assemble.h"

namespace voluta::toolpath {

// Reorders the paths of each patch that may change places (print_turn.h): those above the oldest
// beads come first, otherwise the order stays. Turns round open paths, and begins closed ones
// elsewhere if `movesSeams`, where that lets what is below them cool for longer. If beads have to
// be `minS` old, all paths of a patch may change places where the arm would wait for a twentieth
// of it, unless that needs a longer wait: on a slope, walls cover those that their turn prints
// last. Counts no time for travel.
void orderToCool(Assembled& assembled, bool movesSeams, double minS = 0.0);

} // namespace voluta::toolpath
