#include "document/mode_switch.h"

#include "base/error.h"
#include "language/words.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "program/dialect.h"
#include "project/loaded_part.h"
#include "robot/cell.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <utility>

namespace voluta::document {

namespace {
using project::Choices;

bool cellFits(const Choices& choices) {
  try {
    pipeline::fittingCell(choices, pipeline::resolve(choices).process());
    return true;
  } catch (const base::Error&) {
    return false;
  }
}

QString automaticObstacle(const Choices& choices) {
  try {
    pipeline::checkChoices(choices);
    return {};
  } catch (const base::Error& error) {
    return language::words(error.whole());
  }
}
} // namespace

Choices ModeSwitch::switched(const Choices& now, const std::string& mode) {
  const modes::Mode& from = modes::findMode(now.item().mode);
  const modes::Mode& to = modes::findMode(mode);
  Choices next = now;
  next.item().automatic = next.item().platformStays = false;
  next.item().mode = mode;
  platforms_[now.item().mode] = now.item().platform;
  if (from.aroundRod != to.aroundRod) {
    companions_[from.aroundRod] = {now.cell, now.tool().process, now.item().placement};
    const auto kept = companions_.find(to.aroundRod);
    const Companions with =
        kept == companions_.end() ? Companions{to.usual.cell, to.usual.process, {}} : kept->second;
    next.cell = with.cell;
    next.tool().process = with.process;
    next.item().placement = with.placement;
    if (!platforms_.contains(mode))
      next.item().platform = to.usual.platform;
  }
  const auto platform = platforms_.find(mode);
  const bool plate =
      next.item().platform.isForAnyOf(to.platforms) && from.aroundRod == to.aroundRod;
  if (platform != platforms_.end() &&
      (!plate || (platform->second.isBody() && platform->second.isForAnyOf(to.platforms))))
    next.item().platform = platform->second;
  if (!next.item().platform.isForAnyOf(to.platforms))
    next.item().platform = to.usual.platform;
  return next;
}

Choices fitting(Choices choices) {
  const modes::Mode& mode = modes::findMode(choices.item().mode);
  if (!choices.item().platform.isForAnyOf(mode.platforms))
    choices.item().platform = mode.usual.platform;
  if (mode.place) {
    choices.item().parameters.erase("orient");
    if (choices.item().scale == "fit")
      choices.item().scale = "1";
  }
  if (!cellFits(choices)) {
    choices.cell = mode.usual.cell;
    if (!cellFits(choices))
      choices.tool().process = mode.usual.process;
  }
  return choices;
}

Choices ModeSwitch::automatic(const Choices& now) {
  platforms_[now.item().mode] = now.item().platform;
  Choices next = now;
  next.item().automatic = true;
  next.item().platformStays = false;
  return next;
}

std::vector<std::string> writableFormats(const Choices& choices) {
  std::vector<std::string> formats = choices.formats;
  if (formats.empty())
    return formats;
  try {
    const robot::Cell cell = pipeline::fittingCell(choices, pipeline::resolve(choices).process());
    std::erase_if(formats, [&](const std::string& id) {
      return program::refusal(program::findDialect(id), cell, {}, nullptr).has_value();
    });
  } catch (const base::Error&) {
    // Planning reports the error.
  }
  return formats;
}

bool bodyIsMissing(const Choices& choices) {
  if (!choices.item().platform.isBody())
    return false;
  const std::string file = choices.item().platform.file();
  const auto isSample = [&](const std::string& name) { return file == "sample:" + name; };
  return std::ranges::none_of(project::sampleNames(), isSample) &&
         !QFileInfo(QString::fromStdString(file)).isFile();
}

base::ParameterTable parametersFor(const Choices& choices) {
  std::vector<base::ParameterSpec> specs = pipeline::parametersOf(choices).specs();
  const base::ParameterTable offered = pipeline::allParameters();
  std::erase_if(specs, [&](const base::ParameterSpec& spec) { return !offered.find(spec.key); });
  try {
    const std::map<std::string, std::string> ofStrategy = pipeline::parametersOfStrategy(choices);
    for (base::ParameterSpec& spec : specs)
      if (const auto found = ofStrategy.find(spec.key); found != ofStrategy.end())
        spec.defaultValue = base::parseParameter(spec, found->second);
  } catch (const base::Error&) {
    // Planning reports an unreadable process.
  }
  return base::ParameterTable(std::move(specs));
}

QString obstacle(const Choices& given) {
  if (given.item().automatic)
    return automaticObstacle(given);
  const Choices& choices = given;
  const auto say = [](const char* text) { return QCoreApplication::translate("ModeSwitch", text); };
  const modes::Mode& mode = modes::findMode(choices.item().mode);
  if (!choices.item().platform.isForAnyOf(mode.platforms))
    return say(
        QT_TRANSLATE_NOOP("ModeSwitch", "This way of building does not support that platform."));
  const auto orient = choices.item().parameters.find("orient");
  if (mode.place && orient != choices.item().parameters.end() && orient->second != "none")
    return say(QT_TRANSLATE_NOOP(
        "ModeSwitch", "This way of building places the part itself: the search for an orientation "
                      "does not apply."));
  if (mode.place && choices.item().scale == "fit")
    return say(
        QT_TRANSLATE_NOOP("ModeSwitch", "This way of building needs the scale as a number."));
  try {
    if (bodyIsMissing(choices))
      return say(QT_TRANSLATE_NOOP("ModeSwitch", "The platform file %1 is missing."))
          .arg(QString::fromStdString(choices.item().platform.file()));
    pipeline::checkChoices(choices);
    pipeline::resolve(choices);
    if (!cellFits(choices))
      return mode.aroundRod
                 ? say(QT_TRANSLATE_NOOP("ModeSwitch",
                                         "This way of building needs a cell with a rotating rod."))
                 : say(QT_TRANSLATE_NOOP(
                       "ModeSwitch",
                       "This cell rotates a rod: this way of building needs one with a plate."));
    return {};
  } catch (const base::Error& error) {
    // Errors of a parameter are shown at its field.
    const auto* key = std::get_if<std::string>(&error.context().data());
    const bool isField = key && pipeline::parametersOf(choices.item().mode).find(*key) != nullptr;
    return isField ? QString() : language::words(error.whole());
  }
}

} // namespace voluta::document
