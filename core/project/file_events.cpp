#include "project/file_events.h"

#include "base/ascii_text.h"
#include "geometry/formats/threemf_heights.h"
#include "plan/layer_event.h"

#include <algorithm>
#include <fmt/format.h>

namespace voluta::project {

namespace {
using geometry::EventOfFile, geometry::EventOfFileKind;

constexpr double kFarMm = 1e5;     // the end of a range of heights
constexpr double kHighestMm = 1e4; // of an event

// Returns the text as controllers can show it, without the separator of events.
std::string shownText(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  std::string shown = base::asciiText(text);
  std::ranges::replace(shown, ';', ',');
  std::ranges::replace(shown, '"', '\'');
  std::ranges::replace(shown, '\\', '/');
  shown.resize(std::min(shown.size(), plan::kPauseTextLength));
  return shown;
}

std::string stopOf(const EventOfFile& event) {
  const bool isColour = event.kind == EventOfFileKind::Colour;
  std::string text = shownText(event.text);
  if (isColour)
    text = text.empty() ? "Change the colour" : shownText("Change to colour " + text);
  const std::string place =
      event.heightMm > 0.0 ? fmt::format("z{:.6g}", event.heightMm) : std::string("1");
  return fmt::format("{} {}{}{}", place, isColour ? "filament" : "pause", text.empty() ? "" : " ",
                     text);
}
} // namespace

FileEvents eventsOfFile(const std::vector<EventOfFile>& events, double topMm,
                        std::vector<base::Message>& notes) {
  FileEvents made;
  for (const EventOfFile& event : events) {
    if (!(event.heightMm < std::min(topMm, kHighestMm))) {
      notes.push_back(base::message("not used: {event} at a height of {height} in the file: the "
                                    "part ends at {top}"_text,
                                    geometry::eventWords(event), base::mm(event.heightMm),
                                    base::mm(topMm)));
      continue;
    }
    notes.push_back(base::message("from the file: {event} at a height of {height}"_text,
                                  geometry::eventWords(event), base::mm(event.heightMm)));
    if (event.kind != EventOfFileKind::Tool) {
      made.layerEvents += (made.layerEvents.empty() ? "" : "; ") + stopOf(event);
      continue;
    }
    if (!made.tools.empty())
      made.tools.back().shape = fmt::format("{},{:.9g}", made.tools.back().shape, event.heightMm);
    Region region;
    region.shape = fmt::format("height:{:.9g}", event.heightMm);
    region.parameters = {{"tool", std::to_string(event.extruder)}};
    made.tools.push_back(std::move(region));
  }
  if (!made.tools.empty())
    made.tools.back().shape += fmt::format(",{}", kFarMm);
  return made;
}

} // namespace voluta::project
