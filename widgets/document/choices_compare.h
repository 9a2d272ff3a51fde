// Compares what the user chose.
#pragma once

#include "project/choices.h"

namespace voluta::document {

bool sameChoices(const project::Choices& a, const project::Choices& b);

// Does `next`, with which another part would begin, lack settings of `now`? Placement, scale and
// formats do not count, nor what mode auto has chosen.
bool losesSettings(const project::Choices& now, const project::Choices& next);

} // namespace voluta::document
