#include "geometry/formats/threemf_heights.h"

#include "base/error.h"
#include "geometry/formats/text_scanner.h"
#include "geometry/formats/xml_scan.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace voluta::geometry {

namespace {

constexpr std::array<std::string_view, 2> kRangeMembers{
    "Metadata/Prusa_Slicer_layer_config_ranges.xml", "Metadata/layer_config_ranges.xml"};
constexpr std::array<std::string_view, 2> kStopMembers{
    "Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml", "Metadata/custom_gcode_per_layer.xml"};

using Ranges = std::map<long long, std::vector<ThreemfRange>>;

void addOption(ThreemfRange& range, const std::string& key, const std::string& value) {
  if (key != "extruder")
    addSetting(range.settings, key, value);
  else if (value != "0") // that of the object
    range.settings.emplace_back(key, value);
}

void readRanges(const std::string& text, const std::string& member, Ranges& ranges) {
  long long object = 0;
  ThreemfRange range;
  std::string key, value;
  XmlHandler handler;
  handler.begin = [&](XmlName name, const XmlAttributes& attributes) {
    if (name.word == "object")
      object = attributes.integer("id");
    else if (name.word == "range")
      range = {attributes.number("min_z"), attributes.number("max_z"), {}};
    key = name.word == "option" ? std::string(attributes.text("opt_key")) : std::string();
    value.clear();
  };
  handler.text = [&](std::string_view part) { value += part; };
  handler.end = [&](XmlName name) {
    if (name.word == "option")
      addOption(range, key, value);
    else if (name.word == "range")
      ranges[object].push_back(range);
  };
  scanXml(text, member, handler);
}

// Returns the number of the event's type. Older packages have its G-code instead.
long long typeOf(const XmlAttributes& attributes) {
  if (attributes.has("type"))
    return attributes.integer("type");
  constexpr std::array<std::string_view, 3> kWords{"M600", "M601", "tool_change"};
  const auto* word = std::ranges::find(kWords, attributes.text("gcode"));
  return word == kWords.end() ? 4 : word - kWords.begin();
}

base::Message notUsed(base::Message event, double heightMm, const std::string& member) {
  return base::message("not used: {event} at a height of {height} ('{member}')"_text,
                       std::move(event), base::mm(heightMm), member);
}

// Adds the event of an element; nothing, with a note, if it is G-code.
void addEvent(const XmlAttributes& attributes, double heightMm, double layerMm,
              ThreemfHeights& heights, std::size_t& gcodes) {
  constexpr std::size_t kMaxNamed = 20;
  const long long type = typeOf(attributes);
  if (type < 0 || type > 2) {
    if (++gcodes <= kMaxNamed)
      heights.notes.push_back(notUsed(type == 3 ? base::Message("template G-code"_text)
                                                : base::Message("custom G-code"_text),
                                      heightMm, heights.eventsMember));
    return;
  }
  constexpr std::array kKinds{EventOfFileKind::Colour, EventOfFileKind::Pause,
                              EventOfFileKind::Tool};
  EventOfFile event{kKinds[static_cast<std::size_t>(type)],
                    heightMm - std::clamp(layerMm, 0.0, std::max(heightMm, 0.0)),
                    static_cast<int>(std::clamp(attributes.integerOr("extruder", 1), 1ll, 1000ll)),
                    {}};
  if (event.kind != EventOfFileKind::Tool)
    event.text = attributes.text(event.kind == EventOfFileKind::Pause ? "extra" : "color");
  heights.events.push_back(std::move(event));
}

// The heights are those at which layers end; `layerMm`: of the slicer's layers.
void readEvents(const std::string& text, const std::string& member, double layerMm,
                ThreemfHeights& heights) {
  constexpr std::size_t kMaxEvents = 1000;
  ThreemfHeights read;
  read.eventsMember = member;
  std::size_t gcodes = 0, left = 0;
  XmlHandler handler;
  handler.begin = [&](XmlName name, const XmlAttributes& attributes) {
    if (name.word != "code" && name.word != "layer")
      return;
    const double heightMm = attributes.number(name.word == "code" ? "print_z" : "top_z");
    if (read.events.size() < kMaxEvents)
      addEvent(attributes, heightMm, layerMm, read, gcodes);
    else
      ++left;
  };
  scanXml(text, member, handler);
  constexpr std::size_t kMaxNamed = 20;
  left += gcodes > kMaxNamed ? gcodes - kMaxNamed : 0;
  if (left > 0)
    read.notes.push_back(base::message(
        "not used: {count} further events at heights ('{member}')"_text, left, member));
  std::ranges::stable_sort(read.events, {}, &EventOfFile::heightMm);
  heights.events = std::move(read.events);
  heights.eventsMember = member;
  std::ranges::move(read.notes, std::back_inserter(heights.notes));
}

// Returns the height of layers in the slicer's settings; 0 if they do not state it.
double layerHeightMm(const ZipPackage& package) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kPlaces{
      {{"Metadata/Slic3r_PE.config", "; layer_height = "},
       {"Metadata/project_settings.config", "\"layer_height\": \""}}};
  for (const auto& [name, key] : kPlaces) {
    const std::string member(name);
    if (!package.has(member))
      continue;
    const std::string text = package.member(member);
    std::size_t at = text.find(key);
    if (at == std::string::npos)
      continue;
    at += key.size();
    const std::optional<double> height =
        numberOf(std::string_view(text).substr(at, text.find_first_of("\"\r\n", at) - at));
    if (height && *height > 0.0)
      return *height;
  }
  return 0.0;
}

// Calls `read` with the text of each member that there is; names those that are damaged.
template <typename Read>
void readMembers(const ZipPackage& package, const std::array<std::string_view, 2>& members,
                 base::Text what, std::vector<base::Message>& notes, const Read& read) {
  for (const std::string_view name : members) {
    const std::string member(name);
    if (!package.has(member))
      continue;
    try {
      read(package.member(member), member);
    } catch (const base::Error& e) {
      notes.push_back(
          base::message("not used, as they are damaged: {what} ('{member}'): {why}"_text, what,
                        member, e.message()));
    }
  }
}

} // namespace

ThreemfHeights slicerHeights(const ZipPackage& package) {
  ThreemfHeights heights;
  readMembers(package, kRangeMembers, "settings of ranges of height"_text, heights.notes,
              [&](const std::string& text, const std::string& member) {
                Ranges ranges;
                readRanges(text, member, ranges);
                heights.ranges = std::move(ranges);
                heights.rangesMember = member;
              });
  readMembers(package, kStopMembers, "stops, tools and G-code at given heights"_text, heights.notes,
              [&](const std::string& text, const std::string& member) {
                readEvents(text, member, layerHeightMm(package), heights);
              });
  return heights;
}

base::Message eventWords(const EventOfFile& event) {
  switch (event.kind) {
  case EventOfFileKind::Colour:
    return {"a change of colour"_text, {}};
  case EventOfFileKind::Pause:
    return {"a pause"_text, {}};
  case EventOfFileKind::Tool:
    break;
  }
  return base::message("a change to extruder {number}"_text, event.extruder);
}

base::Message unusedEvent(const EventOfFile& event, const std::string& member) {
  return notUsed(eventWords(event), event.heightMm, member);
}

} // namespace voluta::geometry
