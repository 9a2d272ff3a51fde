// A small project file of which every part is there.
#pragma once

#include "project/job.h"

namespace voluta::test {

// Planned up to its motion; three findings, two patches, three waypoints.
project::Job sampleJob();
// The same, with pieces instead of voxels.
project::Job sampleJobOfPieces();

} // namespace voluta::test
