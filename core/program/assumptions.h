// What is assumed of a dialect's controller, in words: its row's figures as people read them.
#pragma once

#include "base/text.h"
#include "program/dialect.h"

#include <vector>

namespace voluta::program {

// Sentences on plan::TimeModel, the joined points and the limits of the row; never empty.
std::vector<base::Message> assumptionsOf(const Dialect& dialect);

} // namespace voluta::program
