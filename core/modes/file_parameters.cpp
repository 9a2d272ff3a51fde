#include "modes/file_parameters.h"

namespace voluta::modes {

const std::vector<FileParameter>& fileParameters() {
  static const std::vector<FileParameter> kAll{
      {"cutPlanes", "*.json", ""},
      {"layerPlanes", "*.json", ""},
      {"rodProfile", "*.txt *.csv *.dat", ""},
      {"endSurface", "*.stl *.obj *.ply *.off *.3mf", "mesh:"},
  };
  return kAll;
}

} // namespace voluta::modes
