// Texts about the assumptions made on a dialect's controller: the figures of its row in words.
#pragma once

#include "base/text.h"
#include "program/dialect.h"

#include <vector>

namespace voluta::program {

// Returns sentences about plan::TimeModel, merged points and the limits of the row; never empty.
std::vector<base::Message> assumptionsOf(const Dialect& dialect);

} // namespace voluta::program
