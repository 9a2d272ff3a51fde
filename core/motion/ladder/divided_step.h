// Divides a printed step of a run evenly.
#pragma once

#include "motion/bead_run.h"
#include "motion/motion_scene.h"

#include <vector>

namespace voluta::motion {

// Appends the path from the last of `points` to `to` in n straight steps of equal length and
// rotation: n points, each with its share of to.volumeMm3 and with to.speedMmPerS and to.next; only
// the last has to.waypoint. Each point's joints are solved near those of the previous one (to.at.q
// is not read). Returns false if that is impossible with steps of at most scene.options.maxStepRad;
// `points` then ends before the failure. Preconditions: points is not empty, n >= 1.
bool appendDivided(const MotionScene& scene, const RunPoint& to, int n,
                   std::vector<RunPoint>& points);

} // namespace voluta::motion
