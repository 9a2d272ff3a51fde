#include "window/pages/layer_event_edits.h"

#include "base/error.h"
#include "document/document.h"
#include "motion/layer_event_text.h"
#include "motion/layer_events.h"
#include "pipeline/item_events.h"
#include "plan/tool_plan.h"
#include "window/layer_event_dialog.h"

#include <QCoreApplication>
#include <algorithm>
#include <memory>
#include <string_view>

namespace voluta::window {

namespace {
// Returns what a setting lists, as typed. A text that is no list yet has nothing.
template <typename One>
std::vector<One> listIn(const project::ItemChoices& item, const char* key,
                        std::vector<One> (*parsed)(std::string_view)) {
  const auto text = item.parameters.find(key);
  if (text == item.parameters.end())
    return {};
  try {
    return parsed(text->second);
  } catch (const base::Error&) {
    return {};
  }
}

// From 1.
std::vector<int> pauseLayersOf(const project::ItemChoices& item) {
  return listIn(item, motion::kPauseLayers, motion::pauseLayersOf);
}

std::shared_ptr<const plan::ToolPlan> planShown(const Workspace& workspace) {
  const auto result = workspace.document.lastResult();
  return result ? result->job.toolPlan : nullptr;
}

// Returns the parts that have a layer of the print, each with its own number.
std::vector<motion::LayerOfItem> partsIn(const Workspace& workspace, int layer) {
  const std::size_t count = workspace.document.partCount();
  if (count < 2)
    return {{0, layer + 1}};
  const auto plan = planShown(workspace);
  auto parts = plan ? motion::itemsInLayer(*plan, layer) : std::vector<motion::LayerOfItem>();
  std::erase_if(
      parts, [&](const motion::LayerOfItem& part) { return part.item >= static_cast<int>(count); });
  return parts;
}

QString words(const char* text) {
  return QCoreApplication::translate("LayerEvents", text);
}
} // namespace

std::vector<int> pausedLayers(const Workspace& workspace) {
  const auto& items = workspace.document.jobChoices().items;
  const auto plan = planShown(workspace);
  std::vector<int> paused;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (const int layer : pauseLayersOf(items[i])) {
      if (items.size() == 1) {
        paused.push_back(layer - 1);
        continue;
      }
      if (!plan)
        continue;
      const auto places =
          motion::eventPlaces(*plan, {{.item = static_cast<int>(i), .layer = layer}});
      if (!places.empty())
        paused.push_back(plan->paths[places.front().path].layer);
    }
  std::ranges::sort(paused);
  paused.erase(std::ranges::unique(paused).begin(), paused.end());
  return paused;
}

std::vector<int> eventLayers(const Workspace& workspace) {
  const auto plan = planShown(workspace);
  if (!plan)
    return {};
  std::vector<int> layers;
  const auto& items = workspace.document.jobChoices().items;
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::vector<plan::LayerEvent> events =
        listIn(items[i], motion::kLayerEvents, motion::layerEventsOf);
    for (plan::LayerEvent& event : events)
      event.item = static_cast<int>(i);
    for (const motion::EventPlace& place : motion::eventPlaces(*plan, events))
      layers.push_back(plan->paths[place.path].layer);
  }
  for (const plan::Insert& insert : plan->inserts)
    layers.push_back(insert.layer);
  std::ranges::sort(layers);
  layers.erase(std::ranges::unique(layers).begin(), layers.end());
  return layers;
}

// The pause is one of the part that has the layer, which becomes the active one.
void setPause(const Workspace& workspace, int layer, bool pause) {
  document::Document& document = workspace.document;
  std::vector<motion::LayerOfItem> parts = partsIn(workspace, layer);
  // The print pauses once, but any of the parts may have asked for it.
  if (pause && parts.size() > 1)
    parts.resize(1);
  if (parts.empty())
    return;
  for (const motion::LayerOfItem& part : parts) {
    const auto item = static_cast<std::size_t>(part.item);
    std::vector<int> layers = pauseLayersOf(document.choices().item(item));
    if (std::erase(layers, part.layer) == 0 && !pause)
      continue;
    if (document.partCount() > 1)
      document.setActive(item);
    if (pause)
      layers.push_back(part.layer);
    std::ranges::sort(layers);
    document.setParameter(QString::fromLatin1(motion::kPauseLayers),
                          QString::fromStdString(motion::pauseLayersText(layers)));
  }
  workspace.shell.say(
      (pause ? words(QT_TRANSLATE_NOOP("LayerEvents", "The next plan pauses before layer %1."))
             : words(QT_TRANSLATE_NOOP("LayerEvents",
                                       "The next plan does not pause before layer %1.")))
          .arg(layer + 1));
}

void addEvent(const Workspace& workspace, int layer, const std::string& event) {
  document::Document& document = workspace.document;
  const std::vector<motion::LayerOfItem> parts = partsIn(workspace, layer);
  base::require(!parts.empty(), "a layer that a part has");
  const std::string own = std::to_string(parts.front().layer) + ' ' + event;
  motion::layerEventsOf(own);
  if (document.partCount() > 1)
    document.setActive(static_cast<std::size_t>(parts.front().item));
  const auto& parameters = document.choices().item().parameters;
  const auto before = parameters.find(motion::kLayerEvents);
  std::string all = before == parameters.end() ? std::string() : before->second;
  if (all.find_first_not_of(" ;\t") != std::string::npos)
    all += "; "; // behind a statement that ends with a semicolon too
  document.setParameter(QString::fromLatin1(motion::kLayerEvents),
                        QString::fromStdString(all + own));
  workspace.shell.say(
      words(QT_TRANSLATE_NOOP("LayerEvents", "The next plan has the event before layer %1."))
          .arg(layer + 1));
}

void askForEvent(const Workspace& workspace, int layer, QWidget* parent) {
  if (layer < 0 || partsIn(workspace, layer).empty())
    return;
  const project::Choices& choices = workspace.document.choices();
  auto* dialog = new LayerEventDialog(layer + 1, choices.tools.size(), parent);
  dialog->setCheck([&document = workspace.document, layer](const QString& event) {
    return pipeline::eventRefusal(document.choices(),
                                  std::to_string(layer + 1) + ' ' + event.toStdString());
  });
  QObject::connect(dialog, &LayerEventDialog::chosen, &workspace.document,
                   [workspace, layer, dialog](const QString& event) {
                     try {
                       addEvent(workspace, layer, event.toStdString());
                       dialog->accept();
                     } catch (const base::Error& error) {
                       dialog->showProblem(error);
                     }
                   });
  dialog->open();
}

} // namespace voluta::window
