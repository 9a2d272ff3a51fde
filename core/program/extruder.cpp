#include "program/extruder.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "program/common/program_text.h"
#include "program/filament.h"
#include "program/gcode/castelli_serial.h"
#include "program/gcode/extruder_axis.h"

#include <algorithm>

namespace voluta::program {

namespace {
constexpr std::string_view kAsCell = "cell";

std::string_view chosenId(const robot::Cell& cell, const ProgramOptions& options) {
  const auto chosen = options.own.find(kExtruderOption);
  const std::string* id =
      chosen == options.own.end() ? nullptr : std::get_if<std::string>(&chosen->second);
  return id && *id != kAsCell ? std::string_view(*id) : std::string_view(cell.extruder());
}
} // namespace

const std::vector<Extruder>& extruders() {
  static const std::vector<Extruder> table = {
      {.id = kOutputsExtruder, .label = "outputs"_text},
      {.id = kCastelliExtruder,
       .label = "Castelli serial"_text,
       .text = castelliFlowText,
       .fan = castelliFanText,
       .written = castelliWritten,
       .filamentMm = kCastelliFilamentMm,
       .lagS = 0.01,
       .note = "extruder castelli-serial: G is half the period of a step in us, 1674.18 steps/mm "
               "of 3 mm filament, G0 stops it"},
      {.id = kStreamExtruder,
       .label = "E stream"_text,
       .streams = true,
       .filamentMm = kFilamentDiameterMm,
       .lagS = 0.01},
      {.id = kAxisExtruder,
       .label = "external axis"_text,
       .byAxis = true,
       .filamentMm = kFilamentDiameterMm},
  };
  return table;
}

const Extruder& findExtruder(std::string_view id) {
  std::vector<std::string> ids;
  for (const Extruder& row : extruders()) {
    if (row.id == id)
      return row;
    ids.emplace_back(row.id);
  }
  throw base::Error(base::ErrorCode::Usage, base::message("unknown extruder '{id}'"_text, id), {},
                    base::message("did you mean '{name}'?"_text, base::nearestName(id, ids)));
}

base::ParameterSpec extruderOption(std::span<const std::string_view> ids) {
  std::vector<base::Choice> choices = {{std::string(kAsCell), "the cell's"_text}};
  for (const std::string_view id : ids)
    choices.push_back({std::string(id), findExtruder(id).label});
  return base::choiceParameter(
      std::string(kExtruderOption), std::string(kAsCell), std::move(choices), "Programs"_text,
      "extruder"_text,
      "How the program controls the extruder. Outputs: one for on/off, one for the flow. "
      "Castelli serial: texts over a socket. E stream: a file of amounts over time. "
      "External axis: mm of filament in each motion."_text);
}

const Extruder& extruderOf(const ProgramInput& input) {
  return findExtruder(chosenId(input.cell, input.options));
}

void requireExtruder(std::string_view format, std::span<const std::string_view> ids,
                     const robot::Cell& cell, const ProgramOptions& options) {
  if (ids.empty())
    return;
  const Extruder& wanted = findExtruder(chosenId(cell, options));
  if (std::ranges::find(ids, wanted.id) != ids.end())
    return;
  std::string own;
  for (const std::string_view id : ids)
    own += joined({own.empty() ? "" : ", ", id});
  throw base::Error(
      base::ErrorCode::Usage,
      base::message("format {format} cannot control extruder {extruder} in step with the "
                    "motion"_text,
                    format, wanted.id),
      {}, base::message("use extruder {extruders}"_text, own));
}

void requireEventsSaid(const ProgramInput& input) {
  const Extruder& extruder = extruderOf(input);
  const bool isFed = extruder.byAxis || extruder.streams;
  const auto isLag = [](const plan::TrajectoryEvent& event) {
    return event.kind == plan::EventKind::StartLag || event.kind == plan::EventKind::StopLag;
  };
  const auto refuse = [](base::Message reason) {
    throw base::Error(base::ErrorCode::Usage, std::move(reason), {},
                      base::message("use extruder {extruders}"_text, kOutputsExtruder));
  };
  const bool changes = input.trajectory.changesTool() || input.trajectory.firstTool != 0;
  if (changes && (isFed || extruder.text))
    refuse(base::message("the extruder {extruder} prints with one tool"_text, extruder.id));
  if (isFed && std::ranges::any_of(input.trajectory.events, isLag))
    refuse(base::message("extruder {extruder} cannot keep the start and stop lag of process "
                         "{process}"_text,
                         extruder.id, input.process().id));
}

double writtenBy(const Extruder& extruder, const process::Process& process, double share,
                 double (*outputs)(double share)) {
  const double full = process.maxFlowMm3PerS;
  return extruder.written ? extruder.written(share * full) / full : outputs(share);
}

std::string extruderNote(const ProgramInput& input, std::string_view outputs) {
  const Extruder& row = extruderOf(input);
  if (!row.text)
    return std::string(outputs);
  return joined(
      {row.note, "; it is assumed to follow within ", fixedText(1000.0 * row.lagS, 0), " ms"});
}

} // namespace voluta::program
