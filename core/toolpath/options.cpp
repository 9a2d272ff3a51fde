#include "toolpath/options.h"

#include "toolpath/infill.h"

namespace voluta::toolpath {

base::ParameterTable toolpathParameters() {
  std::vector<std::string> infills;
  for (const InfillKind& kind : infillKinds())
    infills.emplace_back(kind.id);
  return base::ParameterTable({
      base::integerParameter("walls", ToolpathOptions{}.walls, 0, 20, "Tool-paths", "walls",
                             "Beads laid along the edge of each layer before it is filled.", true),
      base::choiceParameter("infill", ToolpathOptions{}.infill, infills, "Tool-paths", "infill",
                            "How the inside of each layer is filled.", true),
      base::numberParameter("infillDensity", "", 1.0, 0.05, 1.0, "Tool-paths", "infill density",
                            "Share of the inside that is filled; 1 is solid.", true),
      base::numberParameter("windingAngle", "deg", ToolpathOptions{}.windingAngleDeg, 0.0, 90.0,
                            "Tool-paths", "winding angle",
                            "Of helical infill: 0 winds around the axis, 90 runs along it."),
  });
}

ToolpathOptions toolpathOptions(const base::ParameterValues& values) {
  ToolpathOptions o;
  o.walls = static_cast<int>(values.integer("walls"));
  o.infill = values.text("infill");
  o.infillDensity = values.number("infillDensity");
  o.windingAngleDeg = values.number("windingAngle");
  return o;
}

} // namespace voluta::toolpath
