#include "motion/layer_events.h"

#include "plan/tool_plan.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace voluta::motion {

namespace {
bool isOneItem(const plan::ToolPlan& plan) {
  return std::ranges::all_of(
      plan.paths, [&](const plan::ToolPath& path) { return path.item == plan.paths.front().item; });
}

// The layers of an item: their numbers from 1, and the heights at which they end.
class ItemLayers {
public:
  ItemLayers(const plan::ToolPlan& plan, int item) {
    for (const plan::ToolPath& path : plan.paths) {
      if (path.item != item)
        continue;
      double& top =
          tops_.try_emplace(path.layer, -std::numeric_limits<double>::infinity()).first->second;
      // A prime may be in the air.
      for (std::size_t i = path.first; i < path.first + path.count && !plan::isWaste(path.kind);
           ++i)
        top = std::max(top, plan.position[i].z());
    }
    isWhole_ = isOneItem(plan);
  }

  int count() const { return tops_.empty() ? 0 : numberOf(tops_.rbegin()->first); }
  int numberOf(int layer) const {
    return isWhole_ ? layer + 1
                    : static_cast<int>(std::distance(tops_.begin(), tops_.find(layer))) + 1;
  }
  double topOf(int layer) const { return tops_.at(layer); }

private:
  std::map<int, double> tops_; // by the plan's layer
  bool isWhole_ = true;
};

bool begins(const plan::LayerEvent& event, const ItemLayers& layers, const plan::ToolPath& path,
            int bead) {
  constexpr double kSameMm = 1e-6;
  if (event.layer > 0)
    return layers.numberOf(path.layer) >= event.layer;
  if (event.heightMm > 0.0)
    return !plan::isWaste(path.kind) && layers.topOf(path.layer) > event.heightMm + kSameMm;
  return bead >= event.bead;
}

// The texts of the pauses of a stop, each once.
std::string textsOf(const std::vector<plan::LayerEvent>& events, const EventPlace& place) {
  std::vector<std::string_view> texts;
  const auto add = [&](std::size_t event) {
    const std::string& text = events[event].text;
    if (!text.empty() && std::ranges::find(texts, text) == texts.end())
      texts.push_back(text);
  };
  add(place.event);
  std::ranges::for_each(place.also, add);
  return fmt::format("{}", fmt::join(texts, " / "));
}

std::string pauseText(const plan::ToolPlan& plan, const std::vector<plan::LayerEvent>& events,
                      const EventPlace& place) {
  const plan::LayerEvent& event = events[place.event];
  const std::string own = textsOf(events, place);
  const std::string part = isOneItem(plan) ? "" : fmt::format(" of part {}", event.item + 1);
  const std::string where = fmt::format("layer {} of {}{}", place.layer, place.layers, part);
  if (!own.empty())
    return fmt::format("{} ({}, z {:.2f} mm)", own, where, place.heightMm);
  return fmt::format("Paused before {} (z {:.2f} mm)", where, place.heightMm);
}

std::vector<EventPlace> withJoinedPauses(const plan::ToolPlan& plan,
                                         const std::vector<plan::LayerEvent>& events,
                                         std::vector<EventPlace> places) {
  std::vector<EventPlace> joined;
  for (EventPlace& place : places) {
    const auto isPause = [&](const EventPlace& one) {
      return events[one.event].kind == plan::LayerEventKind::Pause;
    };
    if (!joined.empty() && joined.back().path == place.path && isPause(joined.back()) &&
        isPause(place)) {
      EventPlace both = joined.back();
      both.also.push_back(place.event);
      if (pauseText(plan, events, both).size() <= kStopTextLength) {
        joined.back() = std::move(both);
        continue;
      }
    }
    joined.push_back(std::move(place));
  }
  return joined;
}
} // namespace

std::vector<EventPlace> eventPlaces(const plan::ToolPlan& plan,
                                    const std::vector<plan::LayerEvent>& events) {
  std::vector<EventPlace> places;
  std::map<int, ItemLayers> layersOf;
  for (std::size_t e = 0; e < events.size(); ++e) {
    const plan::LayerEvent& event = events[e];
    const ItemLayers& layers = layersOf.try_emplace(event.item, plan, event.item).first->second;
    int bead = 0;
    for (std::size_t p = 0; p < plan.paths.size(); ++p) {
      const plan::ToolPath& path = plan.paths[p];
      if (path.item != event.item || !begins(event, layers, path, ++bead))
        continue;
      places.push_back(
          {p, e, {}, layers.numberOf(path.layer), layers.count(), plan.position[path.first].z()});
      break;
    }
  }
  std::ranges::stable_sort(places, {}, &EventPlace::path);
  return withJoinedPauses(plan, events, std::move(places));
}

int layersOfItem(const plan::ToolPlan& plan, int item) {
  return ItemLayers(plan, item).count();
}

std::optional<LayerOfItem> layerOfItem(const plan::ToolPlan& plan, int layer) {
  const auto path = std::ranges::find(plan.paths, layer, &plan::ToolPath::layer);
  if (path == plan.paths.end())
    return std::nullopt;
  return LayerOfItem{path->item, ItemLayers(plan, path->item).numberOf(layer)};
}

std::vector<LayerOfItem> itemsInLayer(const plan::ToolPlan& plan, int layer) {
  std::vector<LayerOfItem> items;
  for (const plan::ToolPath& path : plan.paths)
    if (path.layer == layer &&
        std::ranges::find(items, path.item, &LayerOfItem::item) == items.end())
      items.push_back({path.item, ItemLayers(plan, path.item).numberOf(layer)});
  return items;
}

bool waitsAside(plan::LayerEventKind kind) {
  using enum plan::LayerEventKind;
  return kind == Pause || kind == Wait || kind == Photo;
}

std::vector<plan::TrajectoryEvent> trajectoryEvents(const plan::ToolPlan& plan,
                                                    const std::vector<plan::LayerEvent>& events,
                                                    const EventPlace& place) {
  using plan::EventKind;
  const plan::LayerEvent& event = events[place.event];
  switch (event.kind) {
  case plan::LayerEventKind::Wait:
    return {{.kind = EventKind::Wait, .seconds = event.seconds}};
  case plan::LayerEventKind::Output:
    return {{.kind = EventKind::Output, .tool = event.number, .on = event.on}};
  case plan::LayerEventKind::Statement:
    return {{.kind = EventKind::Statement, .text = event.text, .format = event.format}};
  case plan::LayerEventKind::Photo:
    return {{.kind = EventKind::Output, .tool = event.number, .on = true},
            {.kind = EventKind::Wait, .seconds = event.seconds},
            {.kind = EventKind::Output, .tool = event.number, .on = false}};
  case plan::LayerEventKind::Pause:
  case plan::LayerEventKind::Tool:
    break;
  }
  return {{.kind = EventKind::Pause, .text = pauseText(plan, events, place)}};
}

} // namespace voluta::motion
