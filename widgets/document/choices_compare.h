// Comparison of user choices.
#pragma once

#include "project/choices.h"

namespace voluta::document {

bool sameChoices(const project::Choices& a, const project::Choices& b);

// Returns whether `next`, with which another part would begin, lacks settings of `now`. Ignores
// placement, scale and formats, and the way chosen by mode auto.
bool losesSettings(const project::Choices& now, const project::Choices& next);

} // namespace voluta::document
