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
      base::numberParameter("infillAngle", "deg", ToolpathOptions{}.infillAngleDeg, 0.0, 180.0,
                            "Tool-paths", "infill direction",
                            "Direction of straight lines on the first layer, from x to y."),
      base::numberParameter("infillTurn", "deg", ToolpathOptions{}.infillTurnDeg, 0.0, 90.0,
                            "Tool-paths", "turn of infill",
                            "How much straight lines turn from layer to layer; 0: all one way."),
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
  o.infillAngleDeg = values.number("infillAngle");
  o.infillTurnDeg = values.number("infillTurn");
  o.windingAngleDeg = values.number("windingAngle");
  return o;
}

} // namespace voluta::toolpath
