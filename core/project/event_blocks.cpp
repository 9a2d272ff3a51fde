#include "project/event_blocks.h"

#include "project/block_file.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace voluta::project {

namespace {
using Json = nlohmann::ordered_json;

constexpr const char* kOwn = "trajectory.events.own"; // values of outputs, and texts

void addOwn(BlockWriter& out, const std::vector<plan::TrajectoryEvent>& events) {
  Json rows = Json::array();
  for (std::size_t e = 0; e < events.size(); ++e)
    if (events[e].on || !events[e].text.empty() || !events[e].format.empty())
      rows.push_back({e, events[e].on, events[e].text, events[e].format});
  if (!rows.empty())
    out.addText(kOwn, rows.dump(-1, ' ', false, Json::error_handler_t::replace));
}

bool getOwn(const BlockReader& in, std::vector<plan::TrajectoryEvent>& events) {
  if (!in.has(kOwn))
    return true;
  for (const Json& row : Json::parse(in.text(kOwn))) {
    const auto at = row.at(0).get<std::size_t>();
    if (at >= events.size())
      return false;
    events[at].on = row.at(1).get<bool>();
    events[at].text = row.at(2).get<std::string>();
    events[at].format = row.at(3).get<std::string>();
  }
  return true;
}
} // namespace

void addEvents(BlockWriter& out, const std::vector<plan::TrajectoryEvent>& events) {
  if (events.empty())
    return;
  std::vector<std::uint64_t> points;
  std::vector<std::uint8_t> kinds;
  std::vector<std::int32_t> tools;
  std::vector<double> feeds, seconds, volumes;
  for (const plan::TrajectoryEvent& e : events) {
    points.push_back(e.point);
    kinds.push_back(static_cast<std::uint8_t>(e.kind));
    tools.push_back(e.tool);
    feeds.push_back(e.feedMm);
    seconds.push_back(e.seconds);
    volumes.push_back(e.volumeMm3);
  }
  out.addOwned("trajectory.events.point", points);
  out.addOwned("trajectory.events.kind", kinds);
  out.addOwned("trajectory.events.tool", tools);
  out.addOwned("trajectory.events.feed", feeds);
  out.addOwned("trajectory.events.seconds", seconds);
  out.addOwned("trajectory.events.volume", volumes);
  addOwn(out, events);
}

std::optional<std::vector<plan::TrajectoryEvent>> getEvents(const BlockReader& in) {
  std::vector<plan::TrajectoryEvent> events;
  if (!in.has("trajectory.events.point"))
    return events;
  const auto points = in.get<std::uint64_t>("trajectory.events.point");
  const auto kinds = in.get<std::uint8_t>("trajectory.events.kind");
  const auto tools = in.get<std::int32_t>("trajectory.events.tool");
  const auto feeds = in.get<double>("trajectory.events.feed");
  // Older projects have no waits and purges.
  const auto orZeros = [&](const char* name) {
    return in.has(name) ? in.get<double>(name) : std::vector<double>(points.size(), 0.0);
  };
  const auto seconds = orZeros("trajectory.events.seconds");
  const auto volumes = orZeros("trajectory.events.volume");
  if (kinds.size() != points.size() || tools.size() != points.size() ||
      feeds.size() != points.size() || seconds.size() != points.size() ||
      volumes.size() != points.size())
    return std::nullopt;
  for (std::size_t i = 0; i < points.size(); ++i)
    events.push_back({.point = static_cast<std::size_t>(points[i]),
                      .kind = static_cast<plan::EventKind>(kinds[i]),
                      .tool = tools[i],
                      .feedMm = feeds[i],
                      .seconds = seconds[i],
                      .volumeMm3 = volumes[i]});
  if (!getOwn(in, events))
    return std::nullopt;
  return events;
}

} // namespace voluta::project
