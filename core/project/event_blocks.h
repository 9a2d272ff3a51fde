// The blocks of a project file with the events of a trajectory.
#pragma once

#include "plan/trajectory.h"

#include <optional>
#include <vector>

namespace voluta::project {

class BlockReader;
class BlockWriter;

void addEvents(BlockWriter& out, const std::vector<plan::TrajectoryEvent>& events);
// Returns none without such blocks; nullopt if they contradict each other. Throws as BlockReader.
std::optional<std::vector<plan::TrajectoryEvent>> getEvents(const BlockReader& in);

} // namespace voluta::project
