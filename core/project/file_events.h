// Stops, colours and tools at heights that the file of a part gives.
#pragma once

#include "base/text.h"
#include "geometry/formats/part_of_file.h"
#include "project/region.h"

#include <string>
#include <vector>

namespace voluta::project {

struct FileEvents {
  std::string layerEvents;   // a value of that parameter; empty: none
  std::vector<Region> tools; // ranges of heights with their tool, ascending
};

// Pauses and changes of colour become events of layers, changes of the tool ranges of heights. Adds
// a note for each event; those at or above `topMm` [mm] are left out.
FileEvents eventsOfFile(const std::vector<geometry::EventOfFile>& events, double topMm,
                        std::vector<base::Message>& notes);

} // namespace voluta::project
