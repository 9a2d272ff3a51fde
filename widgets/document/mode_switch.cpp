#include "document/mode_switch.h"

#include "base/error.h"
#include "modes/mode_table.h"
#include "modes/platform_choice.h"
#include "pipeline/choices.h"
#include "process/process.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <utility>

namespace voluta::document {

namespace {
using modes::PlatformKind;
using project::Choices;

struct Usual {
  const char *cell, *process, *platform;
};
// Castelli 2020, 5.3.1: a rod of 5 mm, 200 mm long, and a nozzle that lays 0.25 mm on it.
constexpr Usual kAroundRod{"lathe", "fdm-0.35", "rod:5x200"};

Usual usual(bool aroundRod) {
  static const Choices plate;
  return aroundRod ? kAroundRod
                   : Usual{plate.cell.c_str(), plate.process.c_str(), plate.platform.c_str()};
}

PlatformKind kindOf(const std::string& platform) {
  return modes::platformChoice(platform).kind;
}

bool takes(const modes::Mode& mode, const std::string& platform) {
  try {
    return std::find(mode.platforms.begin(), mode.platforms.end(), kindOf(platform)) !=
           mode.platforms.end();
  } catch (const base::Error&) {
    return false;
  }
}

bool cellFits(const Choices& choices) {
  try {
    const base::ParameterValues values = pipeline::parameterValues(choices);
    pipeline::fittingCell(choices, pipeline::chosenProcess(choices, values));
    return true;
  } catch (const base::Error&) {
    return false;
  }
}
} // namespace

Choices ModeSwitch::switched(const Choices& now, const std::string& mode) {
  const modes::Mode& from = modes::findMode(now.mode);
  const modes::Mode& to = modes::findMode(mode);
  Choices next = now;
  next.mode = mode;
  platforms_[now.mode] = now.platform;
  if (from.aroundRod != to.aroundRod) {
    companions_[from.aroundRod] = {now.cell, now.process, now.placement};
    const Usual other = usual(to.aroundRod);
    const auto kept = companions_.find(to.aroundRod);
    const Companions with =
        kept == companions_.end() ? Companions{other.cell, other.process, {}} : kept->second;
    next.cell = with.cell;
    next.process = with.process;
    next.placement = with.placement;
    if (!platforms_.contains(mode))
      next.platform = other.platform;
  }
  const auto platform = platforms_.find(mode);
  const bool plate = takes(to, next.platform) && from.aroundRod == to.aroundRod;
  if (platform != platforms_.end() &&
      (!plate || (takes(to, platform->second) && kindOf(platform->second) == PlatformKind::Mesh)))
    next.platform = platform->second;
  if (!takes(to, next.platform))
    next.platform = usual(to.aroundRod).platform;
  return next;
}

Choices fitting(Choices choices) {
  const modes::Mode& mode = modes::findMode(choices.mode);
  const Usual with = usual(mode.aroundRod);
  if (!takes(mode, choices.platform))
    choices.platform = with.platform;
  if (mode.place) {
    choices.parameters.erase("orient");
    if (choices.scale == "fit")
      choices.scale = "1";
  }
  if (!cellFits(choices)) {
    choices.cell = with.cell;
    if (!cellFits(choices))
      choices.process = with.process;
  }
  return choices;
}

base::ParameterTable parametersFor(const Choices& choices) {
  std::vector<base::ParameterSpec> specs = pipeline::parametersOf(choices.mode).specs();
  try {
    const process::Process process = process::loadProcess(choices.process);
    const auto put = [&](std::string_view key, double value) {
      for (base::ParameterSpec& spec : specs)
        if (spec.key == key)
          spec.defaultValue = value;
    };
    put("layerHeightMm", process.layerHeightMm);
    put("beadWidthMm", process.beadWidthMm);
    put("stepMm", process.stepMm);
  } catch (const base::Error&) {
    // The run that meets the process says what is wrong with it.
  }
  return base::ParameterTable(std::move(specs));
}

QString obstacle(const Choices& choices) {
  const auto say = [](const char* text) { return QCoreApplication::translate("ModeSwitch", text); };
  const modes::Mode& mode = modes::findMode(choices.mode);
  if (!takes(mode, choices.platform))
    return say(
        QT_TRANSLATE_NOOP("ModeSwitch", "This way of building does not print on that platform."));
  const auto orient = choices.parameters.find("orient");
  if (mode.place && orient != choices.parameters.end() && orient->second != "none")
    return say(QT_TRANSLATE_NOOP("ModeSwitch", "This way of building lays the part itself: it is "
                                               "not turned by the search for a way to lie."));
  if (mode.place && choices.scale == "fit")
    return say(
        QT_TRANSLATE_NOOP("ModeSwitch", "This way of building needs a scale that is a number."));
  try {
    if (const auto platform = modes::platformChoice(choices.platform);
        platform.kind == PlatformKind::Mesh &&
        !QFileInfo(QString::fromStdString(platform.file)).isFile())
      return say(QT_TRANSLATE_NOOP("ModeSwitch", "The platform's file %1 is not there."))
          .arg(QString::fromStdString(platform.file));
    pipeline::checkChoices(choices);
    const base::ParameterValues values = pipeline::parameterValues(choices);
    pipeline::chosenProcess(choices, values);
    if (!cellFits(choices))
      return mode.aroundRod
                 ? say(QT_TRANSLATE_NOOP("ModeSwitch",
                                         "This way of building needs a cell that turns a rod."))
                 : say(QT_TRANSLATE_NOOP("ModeSwitch", "This cell turns a rod: the way of building "
                                                       "needs one with a plate."));
    return {};
  } catch (const base::Error& error) {
    return QString::fromUtf8(error.what());
  }
}

} // namespace voluta::document
