#include "plan/marks.h"

#include "plan/trajectory.h"

#include <algorithm>
#include <array>

namespace voluta::plan {

namespace {
constexpr bool kSets = true, kAwaits = false, kOn = true, kOff = false;
// clang-format off
constexpr std::array<MarkStep, 9> kStartLeading = {{
    {kSets, 1, kOff}, {kAwaits, 1, kOff}, {kSets, 1, kOn}, {kSets, 0, kOn}, {kAwaits, 1, kOn},
    {kSets, 1, kOff}, {kAwaits, 0, kOn}, {kSets, 0, kOff}, {kAwaits, 0, kOff}}};
constexpr std::array<MarkStep, 10> kStartFollowing = {{
    {kSets, 1, kOff}, {kAwaits, 1, kOn}, {kSets, 1, kOn}, {kAwaits, 1, kOff}, {kSets, 1, kOff},
    {kAwaits, 0, kOn}, {kSets, 1, kOn}, {kSets, 0, kOn}, {kAwaits, 0, kOff}, {kSets, 0, kOff}}};
constexpr std::array<MarkStep, 4> kLeading = {{
    {kSets, 0, kOn}, {kAwaits, 0, kOn}, {kSets, 0, kOff}, {kAwaits, 0, kOff}}};
constexpr std::array<MarkStep, 4> kFollowing = {{
    {kAwaits, 0, kOn}, {kSets, 0, kOn}, {kAwaits, 0, kOff}, {kSets, 0, kOff}}};
// clang-format on
} // namespace

std::span<const MarkStep> markSteps(bool leads, bool isFirst) {
  if (isFirst)
    return leads ? std::span<const MarkStep>(kStartLeading) : kStartFollowing;
  return leads ? std::span<const MarkStep>(kLeading) : kFollowing;
}

std::vector<int> markLinksOf(const Trajectory& trajectory) {
  std::vector<int> links;
  for (const TrajectoryEvent& event : trajectory.events)
    if (event.kind == EventKind::Mark && std::ranges::find(links, event.tool) == links.end())
      links.push_back(event.tool);
  std::ranges::sort(links, {}, markChannelOf);
  return links;
}

std::vector<int> markSignalsOf(const Trajectory& trajectory) {
  std::vector<int> signals;
  for (const int link : markLinksOf(trajectory))
    for (int signal = 0; signal < 2; ++signal)
      signals.push_back(2 * markChannelOf(link) + signal);
  return signals;
}

std::vector<MarkStatement> markStatements(const Trajectory& trajectory) {
  const std::vector<int> links = markLinksOf(trajectory);
  std::vector<MarkStatement> all;
  for (const int link : links)
    all.push_back({0, kNoEvent, kSets, 2 * markChannelOf(link), kOff});
  std::array<bool, kMarkLinks> hasBegun{};
  for (std::size_t e = 0; e < trajectory.events.size(); ++e) {
    const TrajectoryEvent& event = trajectory.events[e];
    if (event.kind != EventKind::Mark)
      continue;
    bool& begun = hasBegun.at(static_cast<std::size_t>(event.tool));
    for (const MarkStep& step : markSteps(markLeads(event.tool), !begun))
      all.push_back(
          {event.point, e, step.sets, 2 * markChannelOf(event.tool) + step.signal, step.on});
    begun = true;
  }
  for (const int signal : markSignalsOf(trajectory))
    all.push_back({trajectory.pointCount(), kNoEvent, kSets, signal, kOff});
  return all;
}

} // namespace voluta::plan
