// A printed step of a run, divided evenly.
#pragma once

#include "motion/motion_scene.h"
#include "motion/run.h"

#include <vector>

namespace voluta::motion {

// Appends the way from the last of `points` to `to` in n straight steps of equal length and turn:
// n points, each with its share of to.volumeMm3, to.speedMmPerS and to.next; only the last is
// to.waypoint. Joints follow from those of the point before (to.at.q is not read). False: they
// cannot, by steps of scene.options.maxStepRad; `points` then ends before that. Preconditions:
// points is not empty, n >= 1.
bool appendDivided(const MotionScene& scene, const RunPoint& to, int n,
                   std::vector<RunPoint>& points);

} // namespace voluta::motion
