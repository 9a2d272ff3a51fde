#include "pipeline/stage_keys.h"

#include "base/data_files.h"
#include "base/files.h"
#include "curved/platform.h"
#include "modes/mode_table.h"
#include "modes/parameter_text.h"
#include "motion/motion_options.h"
#include "pipeline/choices.h"
#include "pipeline/turned_part.h"
#include "project/content_hash.h"
#include "robot/cell.h"
#include "toolpath/options.h"

#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

std::string fileHash(const std::string& folder, const std::string& id, base::Text unknown) {
  return project::contentHash(base::readFile(base::dataFile(folder, id, unknown)));
}

std::string cellText(const robot::Cell& cell) {
  const std::string& robot = cell.robot().id;
  return fmt::format("cell {} {}\nrobot {} {}\n", cell.id(),
                     fileHash("cells", cell.id(), "unknown cell '{id}'"_text), robot,
                     fileHash("robots", robot, "unknown robot '{id}'"_text));
}

std::string headText(const process::Process& p) {
  std::string text = fmt::format("head tolerance {}", p.contactToleranceMm);
  for (const process::HeadSection& section : p.head.sections)
    text += fmt::format(" {}:{}", section.zMm, section.radiusMm);
  return text + "\n";
}

std::string beadText(const process::Process& p) {
  return fmt::format("height {} in [{}, {}]\nwidth {} in [{}, {}]\nstep {}\nspeed {}\nflow {}\n",
                     p.layerHeightMm, p.layerHeightMinMm, p.layerHeightMaxMm, p.beadWidthMm,
                     p.beadWidthMinMm, p.beadWidthMaxMm, p.stepMm, p.speedMmPerS, p.maxFlowMm3PerS);
}

std::string travelText(const process::Process& p) {
  return fmt::format("travel {}\nacceleration {}\n", p.travelSpeedMmPerS, p.accelerationMmPerS2);
}

std::string loadText(const project::LoadedPart& loaded, const project::Choices& c,
                     const base::ParameterValues& values, const process::Process& process,
                     const std::string& cell) {
  const geometry::Placement& p = c.placement;
  const Eigen::Vector4d q = p.rotation.coeffs();
  const bool mended = c.repair && !loaded.found.clean(); // a clean mesh stays as it is
  std::string text =
      fmt::format("mesh {}\nmended {}\nrotation {} {} {} {}\ncentre {} {}\nlift {}\n", loaded.hash,
                  mended, q[3], q[0], q[1], q[2], p.centreMm.x(), p.centreMm.y(), p.liftMm);
  if (loaded.cells)
    text += fmt::format("cells of {} mm\n", unitMm(loaded, c));
  text += turnText(c, values);
  if (const modes::Mode& mode = modes::findMode(c.mode); mode.placeKey)
    text += fmt::format("placed by mode {}\n", c.mode) + mode.placeKey({c, values, process});
  const double scale = project::parsedScale(c.scale);
  if (scale > 0.0)
    return text + fmt::format("scale {}\n", scale);
  return text + "scale to fit\n" + cell + headText(process);
}

std::string programText(const std::string& partName, const process::Process& p) {
  return fmt::format("name {}\nprocess {}\nmaterial {} {}\nprime {}\nnozzle {}\n", partName, p.id,
                     p.material, p.densityGPerCm3, p.primeS, p.nozzleDiameterMm) +
         beadText(p) + headText(p) + travelText(p);
}

std::string next(const std::string& before, project::Stage stage, const std::string& own) {
  return fmt::format("{}[{}]\n{}", before, project::stageName(stage), own);
}

} // namespace

project::StageKeys keysOf(const project::LoadedPart& loaded, const project::Choices& choices,
                          const base::ParameterValues& values, const process::Process& process) {
  const robot::Cell cell = fittingCell(choices, process); // the platform has its own text
  const modes::Mode& mode = modes::findMode(choices.mode);
  const modes::ModeChoices in{choices, values, process};
  const std::string cellKey = cellText(cell);

  project::StageKeys keys;
  const auto put = [&](project::Stage stage, const std::string& own) {
    const std::string before =
        stage == project::Stage::Load ? "" : keys[project::indexOf(stage) - 1];
    keys[project::indexOf(stage)] = next(before, stage, own);
  };
  put(project::Stage::Load, loadText(loaded, choices, values, process, cellKey));
  put(project::Stage::Decompose, fmt::format("mode {}\n", mode.id) + mode.decomposeKey(in));
  put(project::Stage::Layers, mode.layersKey(in));
  put(project::Stage::Toolpath, modes::parameterText(toolpath::toolpathParameters(), values) +
                                    beadText(process) + headText(process));
  put(project::Stage::Motion, cellKey + travelText(process) + headText(process) +
                                  modes::parameterText(motion::motionParameters(), values) +
                                  fmt::format("seed {}\n", choices.seed));
  std::string formats;
  for (const std::string& format : chosenFormats(choices, cell))
    formats += " " + format;
  put(project::Stage::Replay, programText(loaded.name, process) + "formats" + formats + "\n");
  return keys;
}

std::string programKey(const project::StageKeys& keys, const std::string& partName,
                       const process::Process& process, const std::string& format) {
  return next(keys[project::indexOf(project::Stage::Motion)], project::Stage::Replay,
              programText(partName, process) + "format " + format + "\n");
}

} // namespace voluta::pipeline
