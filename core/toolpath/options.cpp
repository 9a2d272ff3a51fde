#include "toolpath/options.h"

#include "toolpath/infill/infill.h"

namespace voluta::toolpath {

base::ParameterTable toolpathParameters() {
  std::vector<base::Choice> infills;
  for (const InfillKind& kind : infillKinds())
    infills.push_back({std::string(kind.id), kind.label});
  return base::ParameterTable({
      base::integerParameter(
          "walls", ToolpathOptions{}.walls, 0, 20, "Tool-paths"_text, "walls"_text,
          "Beads laid along the edge of each layer before it is filled."_text, true),
      base::choiceParameter("infill", ToolpathOptions{}.infill, infills, "Tool-paths"_text,
                            "infill"_text, "How the inside of each layer is filled."_text, true),
      base::numberParameter("infillDensity", "", 1.0, 0.05, 1.0, "Tool-paths"_text,
                            "infill density"_text,
                            "Share of the inside that is filled; 1 is solid."_text, true),
      base::numberParameter("infillAngle", "deg", ToolpathOptions{}.infillAngleDeg, 0.0, 180.0,
                            "Tool-paths"_text, "infill direction"_text,
                            "Direction of straight lines on the first layer, from x to y."_text),
      base::numberParameter(
          "infillTurn", "deg", ToolpathOptions{}.infillTurnDeg, 0.0, 90.0, "Tool-paths"_text,
          "turn of infill"_text,
          "How much straight lines turn from layer to layer; 0: all one way."_text),
      base::numberParameter("windingAngle", "deg", ToolpathOptions{}.windingAngleDeg, 0.0, 90.0,
                            "Tool-paths"_text, "winding angle"_text,
                            "Of helical infill: 0 winds around the axis, 90 runs along it."_text),
      base::choiceParameter(
          "underlay", "auto", {{"auto", "auto"_text}, {"none", "none"_text}}, "Tool-paths"_text,
          "support under what hangs low"_text,
          "Beads under what would hang just over the plate or over what is "
          "printed, which is laid thicker where that is enough. They come off."_text),
      base::choiceParameter("prime", "line",
                            {{"line", "a line beside the part"_text},
                             {"skirt", "a ring round the part"_text},
                             {"none", "none"_text}},
                            "Tool-paths"_text, "prime"_text,
                            "How the nozzle is filled before the part begins: on the plate, or in "
                            "the air beside it where it has no room. It is waste."_text),
      base::numberParameter("primeLengthMm", "mm", ToolpathOptions{}.primeLengthMm, 10.0, 200.0,
                            "Tool-paths"_text, "length of the prime"_text,
                            "Of the line beside the part."_text),
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
  o.rimSupports = values.text("underlay") != "none";
  o.prime = values.text("prime");
  o.primeLengthMm = values.number("primeLengthMm");
  return o;
}

} // namespace voluta::toolpath
