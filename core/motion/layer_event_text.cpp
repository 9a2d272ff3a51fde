#include "motion/layer_event_text.h"

#include "base/error.h"
#include "base/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <utility>

namespace voluta::motion {

namespace {
using plan::LayerEvent, plan::LayerEventKind;

constexpr std::string_view kFilament = "filament"; // a pause, behind which the nozzle is purged
constexpr std::array kWords{std::pair(std::string_view("pause"), LayerEventKind::Pause),
                            std::pair(kFilament, LayerEventKind::Pause),
                            std::pair(std::string_view("wait"), LayerEventKind::Wait),
                            std::pair(std::string_view("output"), LayerEventKind::Output),
                            std::pair(std::string_view("tool"), LayerEventKind::Tool),
                            std::pair(std::string_view("statement"), LayerEventKind::Statement),
                            std::pair(std::string_view("photo"), LayerEventKind::Photo)};
constexpr double kLongestS = 36000.0, kHighestMm = 10000.0;
// A check of a program tells such a pulse from a shorter one.
constexpr double kShortestPulseS = 0.2, kLongestPulseS = 60.0, kUsualPulseS = 0.5;
constexpr int kMaxOutput = 4095, kMaxTool = 99;

std::string_view withoutBlanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

// Removes the first word of a text.
std::string_view takeWord(std::string_view& text) {
  text = withoutBlanks(text);
  const std::string_view word = text.substr(0, text.find_first_of(" \t"));
  text = withoutBlanks(text.substr(word.size()));
  return word;
}

template <typename Number> std::optional<Number> numberIn(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                  : std::nullopt;
}

template <typename Number>
std::optional<Number> numberIn(std::string_view text, Number minimum, Number maximum) {
  const auto value = numberIn<Number>(text);
  return value && *value >= minimum && *value <= maximum ? value : std::nullopt;
}

// Takes the place and the kind from the beginning of a text.
std::optional<LayerEvent> takeHead(std::string_view& text) {
  LayerEvent event;
  std::string_view place = takeWord(text);
  if (place.starts_with('z')) {
    place.remove_prefix(1);
    const auto height = numberIn(place, 0.0, kHighestMm);
    if (!height || !(*height > 0.0))
      return std::nullopt;
    event.heightMm = *height;
  } else {
    const auto layer = numberIn<int>(place);
    if (!layer || *layer < 1)
      return std::nullopt;
    event.layer = *layer;
  }
  const std::string_view word = takeWord(text);
  const auto* const kind =
      std::ranges::find(kWords, word, [](const auto& row) { return row.first; });
  if (kind == kWords.end())
    return std::nullopt;
  event.kind = kind->second;
  event.changesFilament = word == kFilament;
  return event;
}

// Takes what follows the kind; returns whether that is complete.
bool takeValue(LayerEvent& event, std::string_view text) {
  switch (event.kind) {
  case LayerEventKind::Pause:
    event.text = text;
    return true;
  case LayerEventKind::Wait: {
    const auto seconds = numberIn(text, 0.0, kLongestS);
    event.seconds = seconds.value_or(0.0);
    return event.seconds > 0.0;
  }
  case LayerEventKind::Output: {
    const auto output = numberIn(takeWord(text), 0, kMaxOutput);
    event.number = output.value_or(0);
    event.on = text == "on";
    return output && (text == "on" || text == "off");
  }
  case LayerEventKind::Photo: {
    const auto output = numberIn(takeWord(text), 0, kMaxOutput);
    const auto pulse = text.empty() ? std::optional(kUsualPulseS)
                                    : numberIn(text, kShortestPulseS, kLongestPulseS);
    event.number = output.value_or(0);
    event.seconds = pulse.value_or(0.0);
    return output && pulse;
  }
  case LayerEventKind::Tool: {
    const auto tool = numberIn(text, 1, kMaxTool);
    event.number = tool.value_or(1);
    return tool.has_value();
  }
  case LayerEventKind::Statement:
    event.format = takeWord(text);
    event.text = text;
    return !event.format.empty() && !event.text.empty() &&
           event.text.find_first_of("\r\n") == std::string::npos;
  }
  return false;
}
// Throws Error{Usage} if a pause's text is too long, or if a controller cannot show the text or
// read the statement.
void requireShown(const LayerEvent& event, std::string_view text, std::string_view whole) {
  const bool isPause = event.kind == LayerEventKind::Pause;
  if (!isPause && event.kind != LayerEventKind::Statement)
    return;
  if (isPause && text.size() > kOwnTextLength)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("'{text}': a pause's text has at most {limit} characters"_text,
                                    std::string(whole), kOwnTextLength),
                      std::string(kLayerEvents), "shorten the text"_text);
  const bool isKnown = std::ranges::all_of(
      text, [&](char c) { return c >= ' ' && c <= '~' && !(isPause && (c == '"' || c == '\\')); });
  if (!isKnown)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("'{text}' has characters that controllers do not know"_text,
                                    std::string(whole)),
                      std::string(kLayerEvents),
                      "write English letters, digits and signs; in a pause's text no quotes"_text);
}

// Returns the texts of the events that a value of layerEvents lists.
std::vector<std::string_view> textsOfEvents(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= text.size();) {
    std::size_t to = std::min(text.find(';', from), text.size());
    // A semicolon belongs to a statement unless an event follows.
    while (to < text.size()) {
      std::string_view next = text.substr(to + 1);
      next = next.substr(0, next.find(';'));
      if (takeHead(next) || withoutBlanks(text.substr(from, to - from)).empty())
        break;
      to = std::min(text.find(';', to + 1), text.size());
    }
    parts.push_back(withoutBlanks(text.substr(from, to - from)));
    from = to + 1;
  }
  return parts;
}

} // namespace

std::vector<int> pauseLayersOf(std::string_view text) {
  std::vector<int> layers;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string_view item = withoutBlanks(text.substr(from, to - from));
    from = to + 1;
    if (item.empty())
      continue;
    const auto layer = numberIn<int>(item);
    if (!layer || *layer < 1)
      throw base::Error(base::ErrorCode::Usage,
                        base::message("'{text}' is not a list of layers"_text, std::string(text)),
                        std::string(kPauseLayers), "give numbers, such as 12, 40"_text);
    layers.push_back(*layer);
  }
  std::ranges::sort(layers);
  layers.erase(std::ranges::unique(layers).begin(), layers.end());
  return layers;
}

std::string pauseLayersText(const std::vector<int>& layers) {
  return fmt::format("{}", fmt::join(layers, ", "));
}

std::vector<LayerEvent> layerEventsOf(std::string_view text) {
  std::vector<LayerEvent> events;
  for (std::string_view part : textsOfEvents(text)) {
    if (part.empty())
      continue;
    const std::string_view whole = part;
    auto event = takeHead(part);
    // Statements of some languages end with a semicolon.
    if (event && event->kind != LayerEventKind::Statement && part.ends_with(';'))
      part = withoutBlanks(part.substr(0, part.size() - 1));
    if (event)
      requireShown(*event, part, whole);
    if (!event || !takeValue(*event, part))
      throw base::Error(
          base::ErrorCode::Usage,
          base::message("'{text}' is not an event of a layer"_text, std::string(whole)),
          std::string(kLayerEvents),
          "give, for example, 12 pause; 20 pause Put in the nut; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2; 50 statement urscript LINE"_text);
    events.push_back(std::move(*event));
  }
  return events;
}

std::string eventsWithoutTool(std::string_view text, int number) {
  std::string out;
  std::size_t copied = 0;
  for (const std::string_view part : textsOfEvents(text)) {
    std::string_view rest = part;
    auto event = takeHead(rest);
    if (!event || event->kind != LayerEventKind::Tool)
      continue;
    if (rest.ends_with(';'))
      rest = withoutBlanks(rest.substr(0, rest.size() - 1));
    if (!takeValue(*event, rest) || event->number < number)
      continue;
    const auto at = static_cast<std::size_t>(rest.data() - text.data());
    out += text.substr(copied, at - copied);
    out += std::to_string(event->number == number ? 1 : event->number - 1);
    copied = at + rest.size();
  }
  return out.append(text.substr(copied));
}

std::vector<LayerEvent> eventsAsked(const base::ParameterValues& values) {
  std::vector<LayerEvent> events;
  for (const int layer : pauseLayersOf(values.text(kPauseLayers)))
    events.push_back({.layer = layer, .isListed = true});
  std::ranges::move(layerEventsOf(values.text(kLayerEvents)), std::back_inserter(events));
  return events;
}

} // namespace voluta::motion
