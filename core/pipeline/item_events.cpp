#include "pipeline/item_events.h"

#include "base/error.h"
#include "base/key_text.h"
#include "base/parameters.h"
#include "modes/cell_choice.h"
#include "motion/layer_event_text.h"
#include "motion/layer_events.h"
#include "pipeline/given_paths.h"
#include "pipeline/stage_options.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "program/dialect.h"
#include "program/refused_statements.h"
#include "project/choices.h"
#include "project/loaded_part.h"
#include "robot/cell.h"
#include "sliced/sliced_reader.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace voluta::pipeline {

namespace {
constexpr std::string_view kEvents = "events of layers\n";

const std::string* textIn(const base::Value& value) {
  return std::get_if<std::string>(&value.data());
}

std::vector<plan::LayerEvent> stopsOf(const project::LoadedPart& loaded) {
  std::vector<plan::LayerEvent> stops;
  for (const base::Message& note : loaded.readNotes) {
    if (note.text.english() != sliced::kStopNote.english())
      continue;
    const auto* const bead = std::get_if<long long>(&note.values.at(1).data());
    const std::string *const shown = textIn(note.values.at(3)), *const command =
                                                                    textIn(note.values.at(4));
    if (!bead || !shown || !command)
      continue;
    plan::LayerEvent stop;
    stop.bead = static_cast<int>(*bead);
    stop.text = *shown;
    stop.changesFilament = sliced::changesFilament(*command);
    stops.push_back(std::move(stop));
  }
  return stops;
}

base::Message nameOf(const plan::LayerEvent& event) {
  return event.layer > 0 ? base::message("layer {layer}"_text, event.layer)
                         : base::message("height {height}"_text, base::mm(event.heightMm));
}

void requireHarmless(const plan::LayerEvent& event) {
  if (event.kind != plan::LayerEventKind::Statement)
    return;
  program::findDialect(event.format);
  if (const auto refused = program::refusedWord(event.format, event.text))
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("'{word}' in the statement before {place}, '{text}', {effect}"_text,
                      refused->word, nameOf(event), event.text, refused->effect),
        std::string(motion::kLayerEvents), refused->instead);
}

// Of the formats to be written, those that must have the event: a statement is of one format.
std::vector<std::string> formatsFor(const plan::LayerEvent& event,
                                    const std::vector<std::string>& written) {
  const bool isOwn = event.kind == plan::LayerEventKind::Statement &&
                     std::ranges::find(written, event.format) != written.end();
  return isOwn ? std::vector{event.format} : written;
}
} // namespace

std::vector<plan::LayerEvent> eventsOfItem(const project::LoadedPart& loaded,
                                           const base::ParameterValues& values, int item) {
  std::vector<plan::LayerEvent> events;
  const bool isGiven = takesGivenPaths(loaded, values);
  if (isGiven)
    events = stopsOf(loaded);
  for (plan::LayerEvent& event : motion::eventsAsked(values)) {
    const bool isTool = event.kind == plan::LayerEventKind::Tool; // said by the tool-paths
    if (isTool && isGiven)
      throw base::Error(
          base::ErrorCode::Usage,
          "the tools of a file's tool-paths are its own: none changes before a layer"_text,
          std::string(motion::kLayerEvents), "change the tool where the file was made"_text);
    requireHarmless(event);
    if (!isTool)
      events.push_back(std::move(event));
  }
  for (plan::LayerEvent& event : events)
    event.item = item;
  return events;
}

std::optional<base::Error> eventRefusal(const project::Choices& choices, std::string_view text) {
  try {
    const std::vector<plan::LayerEvent> events = motion::layerEventsOf(text);
    const std::vector<std::string> written = chosenFormats(
        choices,
        modes::cellOnAnyPlatform(choices, chosenProcess(choices, parameterValues(choices))));
    for (const plan::LayerEvent& event : events) {
      requireHarmless(event);
      if (event.kind == plan::LayerEventKind::Tool)
        continue;
      plan::Trajectory trajectory;
      trajectory.events = motion::trajectoryEvents({}, {event}, {});
      for (const std::string& format : formatsFor(event, written))
        program::requireEvents(program::findDialect(format), trajectory);
    }
  } catch (const base::Error& error) {
    return error;
  }
  return std::nullopt;
}

std::string eventsKey(const std::vector<plan::LayerEvent>& events) {
  return events.empty() ? std::string() : std::string(kEvents) + base::keyText(events);
}

std::string_view eventsIn(std::string_view key) {
  const std::size_t at = key.rfind(kEvents);
  return at == std::string_view::npos ? std::string_view() : key.substr(at);
}

void requireEventPlaces(const plan::ToolPlan& plan, const std::vector<plan::LayerEvent>& events) {
  const std::vector<motion::EventPlace> places = motion::eventPlaces(plan, events);
  const auto severalItems = std::ranges::any_of(
      plan.paths, [&](const plan::ToolPath& path) { return path.item != plan.paths.front().item; });
  for (std::size_t e = 0; e < events.size(); ++e) {
    const auto has = [&](const motion::EventPlace& place) {
      return place.event == e || std::ranges::find(place.also, e) != place.also.end();
    };
    if (std::ranges::any_of(places, has))
      continue;
    const plan::LayerEvent& event = events[e];
    const int layers = motion::layersOfItem(plan, event.item);
    const bool isPause = event.kind == plan::LayerEventKind::Pause;
    base::Message what = isPause ? base::Message("pause"_text) : base::Message("event"_text);
    throw base::Error(
        base::ErrorCode::Usage,
        severalItems
            ? base::message(
                  "no {what} before {place} of part {part}: the part has {layers} layers"_text,
                  std::move(what), nameOf(event), event.item + 1, layers)
            : base::message("no {what} before {place}: the print ends with layer {layers}"_text,
                            std::move(what), nameOf(event), layers),
        std::string(event.isListed ? motion::kPauseLayers : motion::kLayerEvents),
        "correct the setting; layers are counted for each part"_text);
  }
}

} // namespace voluta::pipeline
