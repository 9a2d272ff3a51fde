// A small project file of which every part is there.
#pragma once

#include "project/job.h"

#include <string>

namespace voluta::test {

// Planned up to its motion; three findings, two patches, three waypoints.
project::Job sampleJob();
// The same, with pieces instead of voxels.
project::Job sampleJobOfPieces();

// The same part, plan and motion as the first format had them.
std::string formatOneBytes(const project::Job& job);

} // namespace voluta::test
