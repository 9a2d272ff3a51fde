#include "language/setting_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <span>

namespace voluta::language {

namespace {
struct Row {
  std::string_view key;
  const char* text;
};

// In the words of slicers and of robot programs.
constexpr Row kSynonyms[] = {
    Row{"layerHeightMm",
        QT_TRANSLATE_NOOP("SettingWords", "quality, resolution, thickness, fine, coarse, detail")},
    Row{"beadWidthMm",
        QT_TRANSLATE_NOOP("SettingWords", "line width, extrusion width, nozzle, bead")},
    Row{"firstLayerWidthMm",
        QT_TRANSLATE_NOOP("SettingWords", "first layer, adhesion, line width, extrusion width")},
    Row{"retractMm", QT_TRANSLATE_NOOP("SettingWords", "retract, ooze, stringing, oozing")},
    Row{"stepMm", QT_TRANSLATE_NOOP("SettingWords", "resolution, point distance, segment length")},
    Row{"walls",
        QT_TRANSLATE_NOOP("SettingWords",
                          "perimeter, perimeters, shell, shells, outline, contour, strength")},
    Row{"infill", QT_TRANSLATE_NOOP("SettingWords", "fill, pattern, solid, interior")},
    Row{"infillDensity",
        QT_TRANSLATE_NOOP("SettingWords", "fill, percent, solid, hollow, strength, interior")},
    Row{"sparsePattern",
        QT_TRANSLATE_NOOP("SettingWords", "fill, infill, gyroid, honeycomb, grid")},
    Row{"topLayers", QT_TRANSLATE_NOOP("SettingWords", "roof, skin, top surface, shell")},
    Row{"bottomLayers", QT_TRANSLATE_NOOP("SettingWords", "floor, skin, bottom surface, shell")},
    Row{"skinMm", QT_TRANSLATE_NOOP("SettingWords", "roof, floor, top, bottom, shell")},
    Row{"infillAngle", QT_TRANSLATE_NOOP("SettingWords", "orientation, rotation")},
    Row{"supports",
        QT_TRANSLATE_NOOP("SettingWords", "overhang, support, support material, bridge, hanging")},
    Row{"rimSupports",
        QT_TRANSLATE_NOOP("SettingWords", "overhang, support material, hanging, edge")},
    Row{"overhangAngle", QT_TRANSLATE_NOOP("SettingWords", "support, bridge, hanging, tilt")},
    Row{"prime",
        QT_TRANSLATE_NOOP("SettingWords", "skirt, purge, priming, start line, prime line")},
    Row{"primeLengthMm", QT_TRANSLATE_NOOP("SettingWords", "skirt, purge, start line")},
    Row{"brimWidthMm",
        QT_TRANSLATE_NOOP("SettingWords", "adhesion, skirt, raft, warping, lifting, bed")},
    Row{"seam", QT_TRANSLATE_NOOP("SettingWords", "zipper, start point, z seam, scar")},
    Row{"thinWalls", QT_TRANSLATE_NOOP("SettingWords", "thin, narrow, detail")},
    Row{"spiral", QT_TRANSLATE_NOOP("SettingWords", "vase, spiralize, continuous")},
    Row{"spiralOuter", QT_TRANSLATE_NOOP("SettingWords", "vase")},
    Row{"coolingSpeedMmPerS",
        QT_TRANSLATE_NOOP("SettingWords", "cooling, fan, temperature, overheating")},
    Row{"minLayerTimeS",
        QT_TRANSLATE_NOOP("SettingWords", "cooling, temperature, fan, pause, wait, overheating")},
    Row{"maxLayerTimeS",
        QT_TRANSLATE_NOOP("SettingWords", "temperature, adhesion, cold joint, interlayer")},
    Row{"loadDirection", QT_TRANSLATE_NOOP("SettingWords", "strength, force, stress")},
    Row{"outerWallSpeedMmPerS",
        QT_TRANSLATE_NOOP("SettingWords", "perimeter, feed rate, velocity")},
    Row{"innerWallSpeedMmPerS",
        QT_TRANSLATE_NOOP("SettingWords", "perimeter, feed rate, velocity")},
    Row{"infillSpeedMmPerS", QT_TRANSLATE_NOOP("SettingWords", "fill, feed rate, velocity")},
    Row{"supportSpeedMmPerS", QT_TRANSLATE_NOOP("SettingWords", "overhang, feed rate, velocity")},
    Row{"firstLayerSpeedMmPerS",
        QT_TRANSLATE_NOOP("SettingWords", "adhesion, feed rate, velocity, bed")},
    Row{"liftMm", QT_TRANSLATE_NOOP("SettingWords", "z hop, travel, retract, hop")},
    Row{"wipeMm", QT_TRANSLATE_NOOP("SettingWords", "stringing, ooze, seam")},
    Row{"pauseLayers",
        QT_TRANSLATE_NOOP("SettingWords",
                          "pause, stop, colour change, insert, M600")},
    Row{"nozzleRotation", QT_TRANSLATE_NOOP("SettingWords", "tool orientation, spin")},
    Row{"tiltToleranceDeg", QT_TRANSLATE_NOOP("SettingWords", "tool orientation, angle")},
    Row{"bodyClearanceMm", QT_TRANSLATE_NOOP("SettingWords", "collision, distance, safety, robot")},
    Row{"partClearanceMm",
        QT_TRANSLATE_NOOP("SettingWords", "collision, distance, safety, nozzle")},
    Row{"collisionModel", QT_TRANSLATE_NOOP("SettingWords", "collision, check")},
    Row{"branchChange", QT_TRANSLATE_NOOP("SettingWords", "configuration, flip, elbow, wrist")},
    Row{"maxJerk", QT_TRANSLATE_NOOP("SettingWords", "acceleration, vibration, smooth")},
    Row{"orient", QT_TRANSLATE_NOOP("SettingWords", "rotate, orientation, auto orient, lay flat")},
    Row{"openSurfaces", QT_TRANSLATE_NOOP("SettingWords", "repair, hole, mesh, thin, shell")},
    Row{"adaptiveLayers", QT_TRANSLATE_NOOP("SettingWords", "variable layer height, quality")},
    Row{"cuspMm", QT_TRANSLATE_NOOP("SettingWords", "variable layer height, quality, adaptive")},
    Row{"tool", QT_TRANSLATE_NOOP("SettingWords", "extruder, nozzle, multi material, head")},
    Row{"supportTool", QT_TRANSLATE_NOOP("SettingWords", "extruder, multi material, soluble")},
    Row{"infillTool", QT_TRANSLATE_NOOP("SettingWords", "extruder, multi material, fill")},
    Row{"pieceTools", QT_TRANSLATE_NOOP("SettingWords", "extruder, multi material")},
    Row{"purgeMm3", QT_TRANSLATE_NOOP("SettingWords",
                                      "tool change, wipe tower, multi material, colour change")},
    Row{"fibreLayers",
        QT_TRANSLATE_NOOP("SettingWords", "carbon, continuous fibre, reinforcement, strength")},
    Row{"voxelMm", QT_TRANSLATE_NOOP("SettingWords", "resolution, grid")},
    Row{"motionsPerFile", QT_TRANSLATE_NOOP("SettingWords", "split program, memory")},
    Row{"programResolutionMm", QT_TRANSLATE_NOOP("SettingWords", "simplify, tolerance")},
    Row{"arcFitting", QT_TRANSLATE_NOOP("SettingWords", "G2, G3, circle")},
    Row{"quality", QT_TRANSLATE_NOOP("SettingWords", "tolerance, strict, draft")},
    Row{"mode",
        QT_TRANSLATE_NOOP("SettingWords", "strategy, slicing, non-planar, way of building")},
    Row{"platform", QT_TRANSLATE_NOOP("SettingWords", "plate, bed, build plate, table, rod")},
    Row{"cell", QT_TRANSLATE_NOOP("SettingWords", "robot, arm, machine, printer, nozzle, head")},
    Row{"process",
        QT_TRANSLATE_NOOP("SettingWords",
                          "nozzle, tool, extruder, speed, feed rate, bead, head, temperature")},
    Row{"material",
        QT_TRANSLATE_NOOP("SettingWords", "temperature, filament, plastic, heat, hot end, bed, "
                                          "fan, cooling, price, cost, flow, retraction")},
    Row{"tools",
        QT_TRANSLATE_NOOP("SettingWords",
                          "tool, second nozzle, extruder, multi material, tool change, colour")},
    Row{"growth", QT_TRANSLATE_NOOP("SettingWords", "scheme, curved, algorithm")},
    Row{"seed", QT_TRANSLATE_NOOP("SettingWords", "random, repeatable")},
};

constexpr Row kZeros[] = {
    Row{"firstLayerWidthMm", QT_TRANSLATE_NOOP("SettingWords", "as process")},
    Row{"retractMm", QT_TRANSLATE_NOOP("SettingWords", "none")},
    Row{"outerWallSpeedMmPerS", QT_TRANSLATE_NOOP("SettingWords", "as process")},
    Row{"innerWallSpeedMmPerS", QT_TRANSLATE_NOOP("SettingWords", "as process")},
    Row{"infillSpeedMmPerS", QT_TRANSLATE_NOOP("SettingWords", "as process")},
    Row{"supportSpeedMmPerS", QT_TRANSLATE_NOOP("SettingWords", "as process")},
    Row{"firstLayerSpeedMmPerS", QT_TRANSLATE_NOOP("SettingWords", "as process")},
    Row{"brimWidthMm", QT_TRANSLATE_NOOP("SettingWords", "no brim")},
    Row{"supportTool", QT_TRANSLATE_NOOP("SettingWords", "as the part")},
    Row{"infillTool", QT_TRANSLATE_NOOP("SettingWords", "as the part")},
    Row{"fibreLayers", QT_TRANSLATE_NOOP("SettingWords", "no tapes")},
    Row{"fibreCount", QT_TRANSLATE_NOOP("SettingWords", "all that fit")},
    Row{"coolingSpeedMmPerS", QT_TRANSLATE_NOOP("SettingWords", "only waits")},
    Row{"minLayerTimeS", QT_TRANSLATE_NOOP("SettingWords", "no limit")},
    Row{"maxLayerTimeS", QT_TRANSLATE_NOOP("SettingWords", "no limit")},
    Row{"maxJerk", QT_TRANSLATE_NOOP("SettingWords", "no limit")},
    Row{"wipeMm", QT_TRANSLATE_NOOP("SettingWords", "none")},
    Row{"stitchSpacing", QT_TRANSLATE_NOOP("SettingWords", "none")},
    Row{"stitchFlow", QT_TRANSLATE_NOOP("SettingWords", "as process")},
    Row{"traceSpacing", QT_TRANSLATE_NOOP("SettingWords", "one bead")},
    Row{"pathsTurnBackMm", QT_TRANSLATE_NOOP("SettingWords", "never")},
    Row{"motionsPerFile", QT_TRANSLATE_NOOP("SettingWords", "as format")},
    Row{"infillRotation", QT_TRANSLATE_NOOP("SettingWords", "none")},
    Row{"rodSides", QT_TRANSLATE_NOOP("SettingWords", "round")},
    Row{"pieceClusters", QT_TRANSLATE_NOOP("SettingWords", "automatic")},
};

QString textOf(std::span<const Row> rows, std::string_view key) {
  const auto row = std::ranges::find(rows, key, &Row::key);
  return row == rows.end() ? QString() : QCoreApplication::translate("SettingWords", row->text);
}

std::vector<std::string_view> keysOf(std::span<const Row> rows) {
  std::vector<std::string_view> keys;
  for (const Row& row : rows)
    keys.push_back(row.key);
  return keys;
}
} // namespace

const std::vector<std::string>& firstSettings() {
  static const std::vector<std::string> kKeys{"layerHeightMm", "walls",    "infillDensity",
                                              "infill",        "supports", "rimSupports",
                                              "brimWidthMm",   "seam",     "retractMm"};
  return kKeys;
}

const std::vector<std::string>& researchSettings() {
  static const std::vector<std::string> kKeys{
      "voxelMm",   "frontShape", "fieldRounds",       "planarScheme",      "pieceClusters",
      "pieceRoot", "rodLayers",  "redundancySamples", "rotationSmoothing", "collisionModel"};
  return kKeys;
}

QString synonyms(std::string_view key) {
  return textOf(kSynonyms, key);
}

QString zeroText(std::string_view key) {
  return textOf(kZeros, key);
}

std::vector<std::string_view> keysWithSynonyms() {
  return keysOf(kSynonyms);
}

std::vector<std::string_view> keysWithZeroText() {
  return keysOf(kZeros);
}

} // namespace voluta::language
