#include "geometry/formats/threemf_heights.h"

#include "base/error.h"
#include "geometry/formats/text_scanner.h"
#include "geometry/formats/xml_scan.h"

#include <algorithm>
#include <array>
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

base::Message eventOf(const XmlAttributes& attributes) {
  switch (typeOf(attributes)) {
  case 0:
    return {"a change of colour"_text, {}};
  case 1:
    return {"a pause"_text, {}};
  case 2:
    return base::message("a change to extruder {number}"_text, attributes.integerOr("extruder", 1));
  case 3:
    return {"template G-code"_text, {}};
  default:
    return {"custom G-code"_text, {}};
  }
}

void readStops(const std::string& text, const std::string& member,
               std::vector<base::Message>& notes) {
  constexpr std::size_t kMaxNamed = 20;
  std::size_t stops = 0;
  XmlHandler handler;
  handler.begin = [&](XmlName name, const XmlAttributes& attributes) {
    if (name.word != "code" && name.word != "layer")
      return;
    const double heightMm = attributes.number(name.word == "code" ? "print_z" : "top_z");
    if (++stops <= kMaxNamed)
      notes.push_back(base::message("not used: {event} at a height of {height} ('{member}')"_text,
                                    eventOf(attributes), base::mm(heightMm), member));
  };
  scanXml(text, member, handler);
  if (stops > kMaxNamed)
    notes.push_back(base::message("not used: {count} further events at heights ('{member}')"_text,
                                  stops - kMaxNamed, member));
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
                readStops(text, member, heights.notes);
              });
  return heights;
}

} // namespace voluta::geometry
