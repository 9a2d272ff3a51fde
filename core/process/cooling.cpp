#include "process/cooling.h"

namespace voluta::process {

double fanShare(const Material& material, const plan::ToolPath& path) {
  if (path.layer == 0)
    return 0.0;
  return path.kind == plan::PathKind::Bridge ? material.bridgeFan.value_or(material.fan)
                                             : material.fan;
}

} // namespace voluta::process
