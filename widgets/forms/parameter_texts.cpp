#include "forms/parameter_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <array>

namespace voluta::forms {

namespace {
// What the tables of core say: groups, labels, helps, choices.
constexpr auto kTexts = std::to_array<const char*>({
    QT_TRANSLATE_NOOP("Parameters", "Layers"),
    QT_TRANSLATE_NOOP("Parameters", "Beads"),
    QT_TRANSLATE_NOOP("Parameters", "Output"),
    QT_TRANSLATE_NOOP("Parameters", "Tool-paths"),
    QT_TRANSLATE_NOOP("Parameters", "Motion"),
    QT_TRANSLATE_NOOP("Parameters", "layer height"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Wanted height of a layer; the process limits what it may become."),
    QT_TRANSLATE_NOOP("Parameters", "bead width"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Wanted width of a bead; the process limits what it may become."),
    QT_TRANSLATE_NOOP("Parameters", "step"),
    QT_TRANSLATE_NOOP("Parameters", "Longest distance of waypoints along a tool-path."),
    QT_TRANSLATE_NOOP("Parameters", "write what every stage made"),
    QT_TRANSLATE_NOOP("Parameters", "Adds voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, "
                                    "toolpath.vtp and trajectory.csv."),
    QT_TRANSLATE_NOOP("Parameters", "write refused programs"),
    QT_TRANSLATE_NOOP("Parameters", "Also writes programs that the replay refused, as "
                                    "refused-NAME, to be looked at and never to be run."),
    QT_TRANSLATE_NOOP("Parameters", "Voxel width"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Width of the voxels that growth works on; layers are not bound to it."),
    QT_TRANSLATE_NOOP("Parameters", "Front"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Shape of the head that must clear all that is printed earlier: a flat one "
                      "as wide as needed, or the head as it is: where voxels would be lost "
                      "otherwise (nozzle) and under wide roofs (nozzle and auto)."),
    QT_TRANSLATE_NOOP("Parameters", "flat"),
    QT_TRANSLATE_NOOP("Parameters", "nozzle"),
    QT_TRANSLATE_NOOP("Parameters", "Supports"),
    QT_TRANSLATE_NOOP("Parameters",
                      "What carries voxels that growth would miss: nothing, or columns as thin as "
                      "a voxel, to be broken off afterwards."),
    QT_TRANSLATE_NOOP("Parameters", "Placement"),
    QT_TRANSLATE_NOOP("Parameters", "Turn the part"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Looks for a better way for the part to lie, from where it was put: with the "
                      "least overhanging area, or with the fewest voxels missed by growth."),
    QT_TRANSLATE_NOOP("Parameters", "none"),
    QT_TRANSLATE_NOOP("Parameters", "auto"),
    QT_TRANSLATE_NOOP("Parameters", "leastRisky"),
    QT_TRANSLATE_NOOP("Parameters", "fewestMissed"),
    QT_TRANSLATE_NOOP("Parameters", "Field rounds"),
    QT_TRANSLATE_NOOP("Parameters", "How often growth and smooth field are fitted to each other at "
                                    "most. 0: layers from the ranks."),
    QT_TRANSLATE_NOOP("Parameters", "Shadowed per layer"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Growth incremental, adaptive, guided: a layer takes voxels as long as it "
                      "cuts off fewer than this many others. 1: none. 0: fewer than the whole "
                      "layer would."),
    QT_TRANSLATE_NOOP("Parameters", "Order of trying"),
    QT_TRANSLATE_NOOP("Parameters", "flooding"),
    QT_TRANSLATE_NOOP("Parameters", "insertion"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Growth incremental: a layer's voxels are tried outwards from the first one "
                      "(flooding) or in the order they were found (insertion)."),
    QT_TRANSLATE_NOOP("Parameters", "Voxels on the front"),
    QT_TRANSLATE_NOOP("Parameters", "outside"),
    QT_TRANSLATE_NOOP("Parameters", "inside"),
    QT_TRANSLATE_NOOP("Parameters",
                      "The sources' schemes: whether a voxel that lies exactly on the convex front "
                      "can still be laid (outside) or is cut off by it (inside)."),
    QT_TRANSLATE_NOOP("Parameters", "Where nothing is safe"),
    QT_TRANSLATE_NOOP("Parameters", "layer"),
    QT_TRANSLATE_NOOP("Parameters", "least"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Growth incremental, adaptive, guided: where every voxel of a layer would "
                      "cut others off, lay all of it as the source does (layer) or only what cuts "
                      "off fewest (least)."),
    QT_TRANSLATE_NOOP("Parameters", "Pieces"),
    QT_TRANSLATE_NOOP("Parameters", "overhang angle"),
    QT_TRANSLATE_NOOP("Parameters",
                      "How far a face may lean over from the upright without support, in every "
                      "mode but curved."),
    QT_TRANSLATE_NOOP("Parameters", "materials of pieces"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Mode planar: a material or filament for each piece, separated by commas; "
                      "from the first again where there are more pieces. Empty: the process's."),
    QT_TRANSLATE_NOOP("Parameters", "cutting planes"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Mode planar: a JSON file, or its text, with a point and a normal for each "
                      "plane that cuts the part, in turn. Empty: they are searched for."),
    QT_TRANSLATE_NOOP("Parameters", "scheme"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Mode planar: beam keeps several partial results and asks of the head's true "
                      "shape; greedy is the published scheme, by the part's skeleton."),
    QT_TRANSLATE_NOOP("Parameters", "thicknesses"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Scheme greedy: how many thicknesses the part's branches are told apart by. "
                      "0: as many as stand apart."),
    QT_TRANSLATE_NOOP("Parameters", "root"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Scheme greedy: x,y,z (mm) of a place on what is printed first; it must "
                      "stand on the plate. Empty: what stands on it with most area."),
    QT_TRANSLATE_NOOP("Parameters", "adaptive layers"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Modes planar and flat: thinner layers where the surface leans, within the "
                      "process's limits."),
    QT_TRANSLATE_NOOP("Parameters", "step height"),
    QT_TRANSLATE_NOOP("Parameters", "Adaptive layers: how far the edges of layers may stand out "
                                    "of the surface."),
    QT_TRANSLATE_NOOP("Parameters", "planes of layers"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Mode flat: a JSON file, or its text, with the plane or quadrilateral of "
                      "each layer. Empty: layers along z."),
    QT_TRANSLATE_NOOP("Parameters", "walls"),
    QT_TRANSLATE_NOOP("Parameters", "Beads laid along the edge of each layer before it is filled."),
    QT_TRANSLATE_NOOP("Parameters", "infill"),
    QT_TRANSLATE_NOOP("Parameters", "How the inside of each layer is filled."),
    QT_TRANSLATE_NOOP("Parameters", "beam"),
    QT_TRANSLATE_NOOP("Parameters", "greedy"),
    QT_TRANSLATE_NOOP("Parameters", "zigzag"),
    QT_TRANSLATE_NOOP("Parameters", "concentric"),
    QT_TRANSLATE_NOOP("Parameters", "woven"),
    QT_TRANSLATE_NOOP("Parameters", "around"),
    QT_TRANSLATE_NOOP("Parameters", "along"),
    QT_TRANSLATE_NOOP("Parameters", "helical"),
    QT_TRANSLATE_NOOP("Parameters", "infill density"),
    QT_TRANSLATE_NOOP("Parameters", "Share of the inside that is filled; 1 is solid."),
    QT_TRANSLATE_NOOP("Parameters", "winding angle"),
    QT_TRANSLATE_NOOP("Parameters", "infill direction"),
    QT_TRANSLATE_NOOP("Parameters", "Direction of straight lines on the first layer, from x to y."),
    QT_TRANSLATE_NOOP("Parameters", "turn of infill"),
    QT_TRANSLATE_NOOP("Parameters",
                      "How much straight lines turn from layer to layer; 0: all one way."),
    QT_TRANSLATE_NOOP("Parameters",
                      "Of helical infill: 0 winds around the axis, 90 runs along it."),
    QT_TRANSLATE_NOOP("Parameters", "clearance of the arm"),
    QT_TRANSLATE_NOOP("Parameters", "Distance that links, plate, nozzle holder and obstacles keep "
                                    "from each other."),
    QT_TRANSLATE_NOOP("Parameters", "clearance of the part"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Distance that all but the print head keeps from what is printed."),
    QT_TRANSLATE_NOOP("Parameters", "lift"),
    QT_TRANSLATE_NOOP("Parameters",
                      "How far the nozzle leaves the part, at least, before it travels."),
    QT_TRANSLATE_NOOP("Parameters", "turns about the nozzle"),
    QT_TRANSLATE_NOOP("Parameters", "How many turns of the part about the nozzle's axis are tried "
                                    "at each place."),
    QT_TRANSLATE_NOOP("Parameters", "Rod"),
    QT_TRANSLATE_NOOP("Parameters", "axis of the part"),
    QT_TRANSLATE_NOOP(
        "Parameters",
        "Which of the part's own axes is laid on the rod; auto: the one that its sides run along."),
    QT_TRANSLATE_NOOP("Parameters", "x"),
    QT_TRANSLATE_NOOP("Parameters", "y"),
    QT_TRANSLATE_NOOP("Parameters", "z"),
    QT_TRANSLATE_NOOP("Parameters", "sides of the rod"),
    QT_TRANSLATE_NOOP("Parameters",
                      "0: a round rod; 3 or more: a prism, measured over its corners."),
    QT_TRANSLATE_NOOP("Parameters", "profile of the rod"),
    QT_TRANSLATE_NOOP(
        "Parameters",
        "Pairs of x and radius in mm, such as -20,2.5 0,2.5 0,3.5 20,3.5, or a file with them; a "
        "step has two pairs at one x. Beyond them the rod goes on as it is. Empty: straight."),
    QT_TRANSLATE_NOOP("Parameters", "layers around the rod"),
    QT_TRANSLATE_NOOP(
        "Parameters",
        "At constant radius about the axis, or at constant distance from the rod's profile."),
    QT_TRANSLATE_NOOP("Parameters", "radius"),
    QT_TRANSLATE_NOOP("Parameters", "offset"),
    QT_TRANSLATE_NOOP("Parameters", "first layer"),
    QT_TRANSLATE_NOOP(
        "Parameters",
        "Modes lathe and substrate: height of the layer on the ground; 0: as high as the others."),
    QT_TRANSLATE_NOOP("Parameters", "Surface"),
    QT_TRANSLATE_NOOP("Parameters", "shape of layers"),
    QT_TRANSLATE_NOOP(
        "Parameters",
        "Mode substrate: at constant distance from the surface, on spheres, on cylinders along x, "
        "or from the surface to an end surface, thicker where the way is longer."),
    QT_TRANSLATE_NOOP("Parameters", "sphere"),
    QT_TRANSLATE_NOOP("Parameters", "cylinder"),
    QT_TRANSLATE_NOOP("Parameters", "flatten"),
    QT_TRANSLATE_NOOP("Parameters", "centre of layers"),
    QT_TRANSLATE_NOOP("Parameters", "Of spheres and cylinders: x,y,z in mm. Empty: of the ball or "
                                    "cylinder that the part stands on, or below the part."),
    QT_TRANSLATE_NOOP("Parameters", "end surface"),
    QT_TRANSLATE_NOOP("Parameters",
                      "Layers that flatten end on it: flat (at the part's top), flat:Z, radius:R "
                      "(a wider cylinder) or mesh:FILE, placed with the platform's."),
});

// Names of choices are written as one word: "fewestMissed" is shown as "fewest missed".
QString apart(const QString& name) {
  if (name.contains(' ') || !name.front().isLower())
    return name;
  QString shown;
  for (const QChar c : name)
    shown += c.isUpper() ? QStringLiteral(" ") + c.toLower() : QString(c);
  return shown;
}
} // namespace

QString parameterText(const std::string& text) {
  if (text.empty())
    return {};
  const QString source = QString::fromStdString(text);
  QString shown = QCoreApplication::translate("Parameters", text.c_str());
  if (shown == source)
    shown = apart(source);
  shown[0] = shown[0].toUpper();
  return shown;
}

QString unitText(const std::string& unit) {
  return unit == "deg" ? QStringLiteral("°") : QString::fromStdString(unit);
}

QString valueText(const base::ParameterSpec& spec, const base::ParameterValue& value) {
  const QString unit = unitText(spec.unit);
  const QLocale locale;
  const QString space = unit.isEmpty() || unit == QStringLiteral("°") ? QString() : QString(' ');
  if (const auto* number = std::get_if<double>(&value))
    return locale.toString(*number, 'g', 6) + space + unit;
  if (const auto* whole = std::get_if<long long>(&value))
    return locale.toString(static_cast<qlonglong>(*whole)) + space + unit;
  if (const auto* yes = std::get_if<bool>(&value))
    return *yes ? QCoreApplication::translate("Parameters", "on")
                : QCoreApplication::translate("Parameters", "off");
  const std::string& text = std::get<std::string>(value);
  return spec.type == base::ParameterType::Choice ? parameterText(text)
                                                  : QString::fromStdString(text);
}

QString parameterToolTip(const base::ParameterSpec& spec) {
  const auto line = [](const QString& text) { return QStringLiteral("<br>") + text; };
  QString tip = parameterText(spec.help).toHtmlEscaped();
  tip += QStringLiteral("<br>");
  if (spec.type == base::ParameterType::Number)
    tip += line(QCoreApplication::translate("Parameters", "Range: %1 to %2")
                    .arg(valueText(spec, spec.minimum), valueText(spec, spec.maximum)));
  if (spec.type == base::ParameterType::Integer)
    tip += line(QCoreApplication::translate("Parameters", "Range: %1 to %2")
                    .arg(valueText(spec, static_cast<long long>(spec.minimum)),
                         valueText(spec, static_cast<long long>(spec.maximum))));
  tip += line(QCoreApplication::translate("Parameters", "Default: %1")
                  .arg(valueText(spec, spec.defaultValue).toHtmlEscaped()));
  tip += line(QCoreApplication::translate("Parameters", "Key: %1")
                  .arg(QString::fromStdString(spec.key).toHtmlEscaped()));
  return QStringLiteral("<qt>%1</qt>").arg(tip);
}

std::vector<const char*> listedParameterTexts() {
  return {kTexts.begin(), kTexts.end()};
}

} // namespace voluta::forms
