#include "toolpath/options.h"

#include "base/key_text.h"
#include "toolpath/fibre/tape_curves.h"
#include "toolpath/fibre/tape_paths.h"
#include "toolpath/infill/infill.h"
#include "toolpath/order/seam.h"
#include "toolpath/sparse/patterns.h"

namespace voluta::toolpath {

base::ParameterTable toolpathParameters() {
  std::vector<base::Choice> infills;
  for (const InfillKind& kind : infillKinds())
    infills.push_back({std::string(kind.id), kind.label});
  std::vector<base::Choice> patterns;
  for (const SparsePattern& pattern : sparsePatterns())
    patterns.push_back({std::string(pattern.id), pattern.label});
  std::vector<base::Choice> seams;
  for (const SeamKind& kind : seamKinds())
    seams.push_back({std::string(kind.id), kind.label});
  std::vector<base::Choice> tapes;
  for (const TapeKind& kind : tapeKinds())
    tapes.push_back({std::string(kind.id), kind.label});
  return base::ParameterTable({
      base::ofRegion(base::integerParameter(
          "walls", ToolpathOptions{}.walls, 0, 20, "Tool-paths"_text, "walls"_text,
          "Number of beads along the outline of each layer."_text, true)),
      base::ofRegion(base::choiceParameter(
          "infill", ToolpathOptions{}.infill, infills, "Tool-paths"_text, "infill"_text,
          "Pattern that fills the interior of each layer."_text, true)),
      base::ofRegion(base::numberParameter(
          "infillDensity", "share", 1.0, 0.0, 1.0, "Tool-paths"_text, "infill density"_text,
          "Share of the interior that is filled: the whole is solid, none is "
          "hollow. Walls and skins are always solid."_text,
          true)),
      base::ofRegion(base::choiceParameter(
          "sparsePattern", ToolpathOptions{}.sparsePattern, patterns, "Tool-paths"_text,
          "sparse pattern"_text, "Pattern of the interior if it is not solid."_text, true)),
      base::ofRegion(base::integerParameter(
          "topLayers", ToolpathOptions{}.topLayers, 0, 100, "Tool-paths"_text, "top layers"_text,
          "Solid layers between the sparse interior and the surface above it."_text, true)),
      base::ofRegion(base::integerParameter(
          "bottomLayers", ToolpathOptions{}.bottomLayers, 0, 100, "Tool-paths"_text,
          "bottom layers"_text,
          "Solid layers between the sparse interior and the surface below it."_text, true)),
      base::ofRegion(base::numberParameter(
          "skinMm", "mm", ToolpathOptions{}.skinMm, 0.0, 100.0, "Tool-paths"_text,
          "skin thickness"_text,
          "Minimum thickness of the top and bottom layers together with their "
          "number."_text)),
      base::ofRegion(base::numberParameter(
          "infillAngle", "deg", ToolpathOptions{}.infillAngleDeg, 0.0, 180.0, "Tool-paths"_text,
          "infill direction"_text,
          "Direction of straight lines on the first layer, measured from x to y."_text)),
      base::ofRegion(base::numberParameter(
          "infillRotation", "deg", ToolpathOptions{}.infillRotationDeg, 0.0, 90.0,
          "Tool-paths"_text, "infill rotation per layer"_text,
          "Rotation of straight lines from layer to layer; 0: the same direction "
          "throughout."_text)),
      base::ofItem(base::numberParameter(
          "windingAngle", "deg", ToolpathOptions{}.windingAngleDeg, 0.0, 90.0, "Tool-paths"_text,
          "winding angle"_text,
          "For helical infill: 0 winds around the axis, 90 runs along it."_text)),
      base::choiceParameter(
          "rimSupports", "auto", {{"auto", "auto"_text}, {"none", "none"_text}}, "Tool-paths"_text,
          "support low overhangs"_text,
          "Adds break-away beads under low overhangs; thickens the overhanging bead "
          "instead where that is enough."_text),
      base::choiceParameter(
          "prime", "line",
          {{"line", "a line beside the part"_text},
           {"skirt", "a ring around the part"_text},
           {"none", "none"_text}},
          "Tool-paths"_text, "prime"_text,
          "Fills the nozzle before the part begins: on the plate, or in the air beside "
          "it if there is no room. The material is waste."_text),
      base::numberParameter("primeLengthMm", "mm", ToolpathOptions{}.primeLengthMm, 10.0, 1000.0,
                            "Tool-paths"_text, "prime length"_text,
                            "Length of the line beside the part."_text),
      base::numberParameter("brimWidthMm", "mm", ToolpathOptions{}.brimWidthMm, 0.0, 500.0,
                            "Tool-paths"_text, "brim width"_text,
                            "Width of the loops on the plate around the first layer, which keep "
                            "it from lifting; break them off after printing. 0: no brim."_text),
      base::choiceParameter("seam", ToolpathOptions{}.seam, seams, "Tool-paths"_text, "seam"_text,
                            "Where closed walls begin and end. A seam aligned or in a corner is "
                            "less visible; spread seams weaken the part least."_text),
      base::ofRegion(base::choiceParameter(
          "seamHere", ToolpathOptions{}.seamHere,
          {{"auto", "auto"_text}, {"always", "always"_text}, {"never", "never"_text}},
          "Tool-paths"_text, "seam here"_text,
          "In a region: closed beads that pass through it begin there, or never do if they can "
          "begin elsewhere."_text)),
      base::ofRegion(base::numberParameter(
          "speedFactor", "share", ToolpathOptions{}.speedFactor, 0.05, 3.0, "Tool-paths"_text,
          "speed factor"_text,
          "Factor of the speed of the part's beads, within the flow of the extruder and the speed "
          "of bridges."_text)),
      base::ofRegion(base::choiceParameter(
          "thinWalls", ToolpathOptions{}.thinWalls,
          {{"bead", "as the narrowest bead"_text}, {"omit", "leave out"_text}}, "Tool-paths"_text,
          "thin walls"_text,
          "Walls narrower than the narrowest bead: printed as that bead, and so too wide, or left "
          "out. Below half its width they are always left out."_text)),
      base::choiceParameter("islandOrder", "travel",
                            {{"travel", "shortest travel"_text}, {"layers", "as sliced"_text}},
                            "Tool-paths"_text, "order of islands"_text,
                            "Order in which separate islands of a flat layer are printed."_text),
      base::booleanParameter("spiral", ToolpathOptions{}.spiral, "Tool-paths"_text,
                             "spiral vase"_text,
                             "Prints the part as one continuous bead of rising height on its "
                             "bottom layers: one wall, without infill, top layers and supports "
                             "under low overhangs."_text,
                             true),
      base::booleanParameter("spiralOuter", ToolpathOptions{}.spiralOuter, "Tool-paths"_text,
                             "outer contour alone"_text,
                             "The spiral follows the largest contour of each layer; holes and "
                             "other contours are left out."_text),
      base::ofRegion(base::withFile(
          base::textParameter(
              "infillField", "Tool-paths"_text, "field of the infill"_text,
              "For infill along a field: a direction x,y,z, or x,y,z,dx,dy,dz in mm on the plate, "
              "separated by spaces or lines, or a file of them. Empty: along the stress between "
              "regions that hold the part and regions with a force."_text),
          {"*.txt *.csv *.dat", "", tapeText})),
      base::numberParameter(
          "coolingSpeedMmPerS", "mm/s", ToolpathOptions{}.cooling.slowestMmPerS, 0.0, 500.0,
          "Cooling"_text, "slowest speed for cooling"_text,
          "Down to this speed beads are printed slower to keep the minimum layer time, before the robot waits. 0: it only waits."_text),
      base::textParameter("loadDirection", "Strength"_text, "direction of the load"_text,
                          "x,y,z in the part's file, for example 1,0,0: reports the "
                          "strength for a load in this direction. Empty: no load."_text),
      base::integerParameter("fibreLayers", FibreOptions{}.everyLayers, 0, 1000, "Fibre"_text,
                             "tapes after every n-th layer"_text,
                             "Irons tapes of continuous fibre onto every n-th layer but the last; "
                             "needs a tool for tape. 0: no tapes."_text),
      base::integerParameter("fibreFirstLayer", FibreOptions{}.firstLayer, 1, 100000, "Fibre"_text,
                             "first layer with tapes"_text,
                             "Layers are counted from 1, on the platform."_text),
      base::integerParameter(
          "fibreCount", FibreOptions{}.maxPerLayer, 0, 10000, "Fibre"_text, "tapes on a layer"_text,
          "Only the longest tapes of each layer are laid. 0: as many as fit."_text),
      base::choiceParameter("fibrePaths", FibreOptions{}.paths, tapes, "Fibre"_text,
                            "paths of tapes"_text,
                            "Tapes lie beside each other, one width apart."_text),
      base::numberParameter(
          "fibreAngle", "deg", FibreOptions{}.angleDeg, -180.0, 180.0, "Fibre"_text,
          "direction of tapes"_text,
          "Direction of tapes on the first layer with tapes, measured from x to y."_text),
      base::numberParameter("fibreRotation", "deg", FibreOptions{}.rotationDeg, -180.0, 180.0,
                            "Fibre"_text, "rotation of tapes per layer"_text,
                            "Rotation from one layer with tapes to the next."_text),
      base::numberParameter("fibreEndMm", "mm", FibreOptions{}.endMm, 0.0, 10000.0, "Fibre"_text,
                            "distance of tape ends"_text,
                            "Least distance of the ends of tapes from the outline, so that plastic "
                            "encloses them. The sides are inside the outline."_text),
      base::withFile(
          base::textParameter(
              "fibreCurves", "Fibre"_text, "curves for tapes"_text,
              "For tapes along given curves: points x,y or x,y,z in mm on the plate, "
              "separated by spaces, and semicolons between curves; or a file of them."_text),
          {"*.txt *.csv *.dat", "", tapeText}),
      base::withFile(base::textParameter(
                         "fibreField", "Fibre"_text, "field of tape directions"_text,
                         "For tapes along a field: x,y,z,dx,dy,dz in mm on the plate, separated by "
                         "spaces or lines, or a file of them."_text),
                     {"*.txt *.csv *.dat", "", tapeText}),
      base::numberParameter("stitchExcess", "share", StitchOptions{}.excess, -0.5, 1.0,
                            "Stitches"_text, "excess of a shot"_text,
                            "Material of a shot beyond the volume of its pocket, as a share of "
                            "that volume."_text),
      base::numberParameter("stitchDepth", "mm", StitchOptions{}.depthMm, 0.0, 50.0,
                            "Stitches"_text, "nozzle depth of a shot"_text,
                            "Depth of the nozzle in the pocket; 0: it seals the opening."_text),
  });
}

ToolpathOptions toolpathOptions(const base::ParameterValues& values) {
  ToolpathOptions o;
  o.walls = static_cast<int>(values.integer("walls"));
  o.infill = values.text("infill");
  o.infillDensity = values.number("infillDensity");
  o.sparsePattern = values.text("sparsePattern");
  o.topLayers = static_cast<int>(values.integer("topLayers"));
  o.bottomLayers = static_cast<int>(values.integer("bottomLayers"));
  o.skinMm = values.number("skinMm");
  o.infillAngleDeg = values.number("infillAngle");
  o.infillRotationDeg = values.number("infillRotation");
  o.windingAngleDeg = values.number("windingAngle");
  o.rimSupports = values.text("rimSupports") != "none";
  o.prime = values.text("prime");
  o.primeLengthMm = values.number("primeLengthMm");
  o.brimWidthMm = values.number("brimWidthMm");
  o.seam = values.text("seam");
  o.seamHere = values.text("seamHere");
  o.speedFactor = values.number("speedFactor");
  o.thinWalls = values.text("thinWalls");
  o.orderIslands = values.text("islandOrder") == "travel";
  o.spiral = values.boolean("spiral");
  o.spiralOuter = values.boolean("spiralOuter");
  o.cooling.slowestMmPerS = values.number("coolingSpeedMmPerS");
  o.fibre.everyLayers = static_cast<int>(values.integer("fibreLayers"));
  o.fibre.firstLayer = static_cast<int>(values.integer("fibreFirstLayer"));
  o.fibre.maxPerLayer = static_cast<int>(values.integer("fibreCount"));
  o.fibre.paths = values.text("fibrePaths");
  o.fibre.angleDeg = values.number("fibreAngle");
  o.fibre.rotationDeg = values.number("fibreRotation");
  o.fibre.endMm = values.number("fibreEndMm");
  o.infillField = values.text("infillField");
  o.fibre.curves = values.text("fibreCurves");
  o.fibre.field = values.text("fibreField");
  o.stitches.excess = values.number("stitchExcess");
  o.stitches.depthMm = values.number("stitchDepth");
  return o;
}

namespace {
// Returns no text for a value at its default: keys of projects saved before the option existed stay
// the same.
template <typename T> std::string changedKey(const T& value, const T& usual) {
  const std::string key = base::keyText(value);
  return key == base::keyText(usual) ? std::string() : key;
}
} // namespace

std::string optionsKey(const ToolpathOptions& options) {
  // The structured binding forces every new option to be considered here; add it with changedKey().
  const auto& [walls, infill, density, pattern, field, strands, top, bottom, skin, thin, angle,
               infillRotation, winding, step, edge, maxBend, smooth, rims, prime, primeLength, brim,
               seam, seamHere, speed, islands, spiral, spiralOuter, tilts, maySag, cooling, fibre,
               stitches, infillTool, platform] = options;
  static_cast<void>(platform);
  static_cast<void>(strands);
  const std::string noPlatform;
  return base::keyText(walls, infill, density, pattern, top, bottom, skin, thin, angle,
                       infillRotation, winding, step, edge, maxBend, smooth, rims, prime,
                       primeLength, brim, seam, islands, spiral, cooling, fibre, infillTool,
                       noPlatform) +
         (tilts ? "" : "upright\n") + (maySag && density < 1.0 ? "sag\n" : "") +
         changedKey(stitches, StitchOptions{}) + (spiralOuter ? "outer\n" : "") +
         changedKey(seamHere, ToolpathOptions{}.seamHere) + changedKey(speed, 1.0) +
         (infill == kFieldInfill ? base::keyText(field) : "");
}

} // namespace voluta::toolpath
