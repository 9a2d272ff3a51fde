// What slicers store beside the model of a 3MF package: the kinds, names, tools and settings of
// objects and their volumes (PrusaSlicer: Metadata/Slic3r_PE_model.config; Bambu Studio and
// OrcaSlicer: Metadata/model_settings.config).
#pragma once

#include "base/text.h"
#include "geometry/formats/zip_package.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::geometry {

enum class ThreemfVolumeKind { Part, Negative, Modifier, SupportEnforcer, SupportBlocker };

// Keys and values that change the print, each key once.
using ThreemfValues = std::vector<std::pair<std::string, std::string>>;

// A piece of an object with a kind and settings of its own.
struct ThreemfVolume {
  std::string name;
  // A stretch of the object's triangles, or the object of one of its components.
  long long firstTriangle = 0, lastTriangle = -1;
  std::string objectId; // empty: a stretch
  ThreemfVolumeKind kind = ThreemfVolumeKind::Part;
  int extruder = 0; // from 1; 0: that of the object
  ThreemfValues settings;
};

struct ThreemfObjectSettings {
  std::string name;
  std::string member; // of the package, where they are
  int extruder = 0;   // from 1; 0: not given
  ThreemfValues settings;
  std::vector<ThreemfVolume> volumes;
};

struct ThreemfSettings {
  std::map<std::string, ThreemfObjectSettings> objects; // by id in the main model
  // Members, settings of plates and damaged settings that are not acted on, a sentence each.
  std::vector<base::Message> notes;
};

// Returns the names in quotes, "'a', 'b'".
std::string inQuotes(const std::vector<std::string>& names);
// Returns the keys in quotes.
std::string keysInQuotes(const ThreemfValues& settings);

// Adds a setting, in place of an earlier one of its key. Keys that change nothing in the print, or
// that are read here, are left out.
void addSetting(ThreemfValues& settings, std::string_view key, std::string_view value);

// `model`: the main model, whose tool-paths are read by others.
ThreemfSettings slicerSettings(const ZipPackage& package, const std::string& model);

// Returns the settings of Cura, keys with values, that the model states with an object itself. An
// object that is a modifier or a support as a whole is one volume of no name.
ThreemfObjectSettings
curaSettings(const std::vector<std::pair<std::string, std::string>>& settings);

} // namespace voluta::geometry
