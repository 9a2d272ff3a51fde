// What slicers store for heights of a 3MF package: settings of ranges of height (PrusaSlicer:
// Metadata/Prusa_Slicer_layer_config_ranges.xml; Bambu Studio and OrcaSlicer:
// Metadata/layer_config_ranges.xml), and stops, tools and G-code (PrusaSlicer:
// Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml; the others:
// Metadata/custom_gcode_per_layer.xml).
#pragma once

#include "base/text.h"
#include "geometry/formats/part_of_file.h"
#include "geometry/formats/threemf_settings.h"
#include "geometry/formats/zip_package.h"

#include <map>
#include <string>
#include <vector>

namespace voluta::geometry {

// A range of heights of an object, with settings of its own.
struct ThreemfRange {
  double fromMm = 0.0, toMm = 0.0; // over the lowest point of the object; any two numbers
  ThreemfValues settings;          // "extruder" is from 1
};

struct ThreemfHeights {
  // By the number of the object among those that are built, from 1.
  std::map<long long, std::vector<ThreemfRange>> ranges;
  std::string rangesMember;        // of the package; empty: none
  std::vector<EventOfFile> events; // ascending
  std::string eventsMember;
  std::vector<base::Message> notes; // G-code, damaged members; a sentence each
};

// Returns "a pause" and the like.
base::Message eventWords(const EventOfFile& event);
// Returns the sentence that an event is not used.
base::Message unusedEvent(const EventOfFile& event, const std::string& member);

ThreemfHeights slicerHeights(const ZipPackage& package);

} // namespace voluta::geometry
