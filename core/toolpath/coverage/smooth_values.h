// Binomial smoothing of values along a curve.
#pragma once

#include <vector>

namespace voluta::toolpath {

// Replaces each value by the weighted mean with its neighbours, `passes` times. Values are
// reflected at the ends of an open curve, which keeps their sum.
void smoothValues(std::vector<double>& values, bool closed, int passes);

} // namespace voluta::toolpath
