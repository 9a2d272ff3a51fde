#include "pipeline/choices.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/number_list.h"
#include "curved/decompose.h"
#include "curved/forward_growth.h"
#include "curved/platform.h"
#include "motion/motion_options.h"
#include "pipeline/lathe_mode.h"
#include "pipeline/modes.h"
#include "pipeline/planar_modes.h"
#include "pipeline/platform_choice.h"
#include "pipeline/road.h"
#include "pipeline/rod_profile.h"
#include "pipeline/substrate_mode.h"
#include "placement/orient.h"
#include "program/dialect.h"
#include "robot/cell.h"
#include "support/supports.h"
#include "toolpath/options.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace voluta::pipeline {

namespace {
using base::Error;
using base::ErrorCode;

void checkName(const std::string& what, const std::string& name,
               const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw Error(ErrorCode::Usage, fmt::format("unknown {} '{}'", what, name), {},
                fmt::format("did you mean {}?", base::nearestName(name, known)));
}
} // namespace

base::ParameterTable allParameters() {
  base::ParameterTable table({
      base::numberParameter("layerHeightMm", "mm", 0.8, 0.05, 10.0, "Layers", "layer height",
                            "Wanted height of a layer; the process limits what it may become.",
                            true),
      base::numberParameter("beadWidthMm", "mm", 1.2, 0.1, 20.0, "Beads", "bead width",
                            "Wanted width of a bead; the process limits what it may become.", true),
      base::numberParameter("stepMm", "mm", 1.0, 0.1, 10.0, "Beads", "step",
                            "Longest distance of waypoints along a tool-path."),
      base::booleanParameter("output.debug", false, "Output", "write what every stage made",
                             "Adds voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, "
                             "toolpath.vtp and trajectory.csv."),
      base::booleanParameter("output.refused", false, "Output", "write refused programs",
                             "Also writes programs that the replay refused, as refused-NAME, to "
                             "be looked at and never to be run."),
  });
  table.append(curved::curvedParameters());
  table.append(curved::forwardParameters());
  table.append(planarModeParameters());
  table.append(latheParameters());
  table.append(substrateParameters());
  table.append(support::supportParameters());
  table.append(placement::orientParameters());
  table.append(toolpath::toolpathParameters());
  table.append(motion::motionParameters());
  return table;
}

void setParameters(Choices& choices, const std::vector<std::string>& assignments) {
  base::ParameterValues values(allParameters());
  for (const std::string& assignment : assignments)
    values.setAssignment(assignment);
  for (const auto& [key, value] : values.changes())
    choices.parameters[key] = base::formatParameter(value);
  // Planes and profile go with the choices, wherever a project is opened again.
  for (const char* key : {"layerPlanes", "cutPlanes"})
    if (const auto planes = choices.parameters.find(key);
        planes != choices.parameters.end() && !planes->second.empty())
      planes->second = planesText(planes->second);
  if (const auto profile = choices.parameters.find("rodProfile");
      profile != choices.parameters.end())
    profile->second = rodProfileText(profile->second);
}

base::ParameterValues parameterValues(const Choices& choices) {
  base::ParameterValues values(parametersOf(choices.mode));
  for (const auto& [key, text] : choices.parameters)
    values.set(key, text);
  return values;
}

namespace {

// Defaults are those of the values: a mode may have its own.
std::string parameterLine(std::string_view key, const base::ParameterValues& values) {
  const base::ParameterSpec& spec = *values.table().find(key);
  const auto changed = values.changes().find(key);
  return fmt::format("{}={}\n", spec.key,
                     base::formatParameter(changed == values.changes().end() ? spec.defaultValue
                                                                             : changed->second));
}

} // namespace

std::string parameterText(const base::ParameterTable& table, const base::ParameterValues& values) {
  std::string text;
  for (const base::ParameterSpec& spec : table.specs())
    text += parameterLine(spec.key, values);
  return text;
}

std::string parameterText(std::initializer_list<const char*> keys,
                          const base::ParameterValues& values) {
  std::string text;
  for (const char* key : keys)
    text += parameterLine(key, values);
  return text;
}

std::vector<std::string> chosenFormats(const Choices& choices, const robot::Cell& cell) {
  if (!choices.formats.empty())
    return choices.formats;
  return {cell.robot().controller, "gcode-extended", "csv"};
}

process::Process chosenProcess(const Choices& choices, const base::ParameterValues& values) {
  process::Process p = process::loadProcess(choices.process);
  const auto put = [&](const char* key, double& field, double least, double most) {
    if (!values.changed(key))
      return;
    field = values.number(key);
    if (field < least || field > most)
      throw Error(ErrorCode::Usage, fmt::format("{:g} mm is beyond process {}", field, p.id), key,
                  fmt::format("give {:g} to {:g} mm", least, most));
  };
  put("layerHeightMm", p.layerHeightMm, p.layerHeightMinMm, p.layerHeightMaxMm);
  put("beadWidthMm", p.beadWidthMm, p.beadWidthMinMm, p.beadWidthMaxMm);
  put("stepMm", p.stepMm, 0.1, 10.0);
  return p;
}

double unitMm(const LoadedPart& loaded, const Choices& choices) {
  return loaded.cells ? parameterValues(choices).number("voxelMm") : 1.0;
}

robot::Cell cellOnAnyPlatform(const Choices& choices, const process::Process& process) {
  robot::Cell cell = robot::loadCell(choices.cell, process, curved::platformDisc(80.0));
  const bool winds = findMode(choices.mode).aroundRod;
  if (winds == cell.rod().has_value())
    return cell;
  std::vector<std::string_view> modesThere;
  for (const Mode& mode : modes())
    if (mode.aroundRod == !winds)
      modesThere.emplace_back(mode.id);
  throw Error(ErrorCode::Usage,
              winds ? fmt::format("mode {} prints around a rod, and cell {} holds none",
                                  choices.mode, choices.cell)
                    : fmt::format("cell {} holds a rod, and mode {} prints on a plate",
                                  choices.cell, choices.mode),
              {},
              winds ? std::string("give --cell lathe")
                    : fmt::format("give --mode {}, or another cell", fmt::join(modesThere, ", ")));
}

double parsedScale(const std::string& scale) {
  if (scale == "fit")
    return 0.0;
  double value = 0.0;
  if (!base::readNumbers(scale, ',', {&value}) || value < 1e-4 || value > 1e4)
    throw Error(ErrorCode::Usage, fmt::format("scale '{}' is not a usable factor", scale), {},
                "give a number from 0.0001 to 10000, or fit");
  return value;
}

void checkChoices(const Choices& choices) {
  std::vector<std::string> modeIds, formatIds;
  for (const Mode& mode : modes())
    modeIds.emplace_back(mode.id);
  for (const program::Dialect& dialect : program::dialects())
    formatIds.emplace_back(dialect.id);
  checkName("mode", choices.mode, modeIds);
  checkName("growth", choices.growth, curved::growthSchemes());
  checkName("cell", choices.cell, robot::cellIds());
  checkName("process", choices.process, process::processIds());
  for (const std::string& format : choices.formats)
    checkName("format", format, formatIds);
  const PlatformKind kind = platformChoice(choices.platform).kind;
  const std::vector<PlatformKind>& taken = findMode(choices.mode).platforms;
  if (std::find(taken.begin(), taken.end(), kind) == taken.end()) {
    std::vector<std::string_view> words;
    for (const PlatformKind one : taken)
      words.push_back(kPlatformWords[static_cast<std::size_t>(one)]);
    throw Error(ErrorCode::Usage,
                fmt::format("mode {} does not print on platform {}", choices.mode,
                            kPlatformWords[static_cast<std::size_t>(kind)]),
                {}, fmt::format("give --platform {}", fmt::join(words, ", ")));
  }
  const bool laysItself = findMode(choices.mode).place != nullptr;
  if (const auto orient = choices.parameters.find("orient");
      laysItself && orient != choices.parameters.end() && orient->second != "none")
    throw Error(ErrorCode::Usage,
                fmt::format("orient={} turns parts on a plate; mode {} lays them itself",
                            orient->second, choices.mode),
                {}, "give orient=none");
  if (parsedScale(choices.scale) == 0.0 && kind == PlatformKind::Mesh)
    throw Error(ErrorCode::Usage, "scale fit would scale the platform's mesh with the part", {},
                "give a number");
  const geometry::Placement& place = choices.placement;
  if (!place.rotation.coeffs().allFinite() || !(place.rotation.norm() > 0.0) ||
      !place.centreMm.allFinite() || !std::isfinite(place.liftMm))
    throw Error(ErrorCode::Usage, "the placement is not a turn and a place in mm");
}

} // namespace voluta::pipeline
