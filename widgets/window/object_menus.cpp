#include "window/object_menus.h"

#include "document/document.h"
#include "panels/findings_panel.h"
#include "plan/tool_plan.h"
#include "project/length_unit.h"
#include "timeline/layer_range_slider.h"
#include "viewer/viewport.h"
#include "window/pages/page_stack.h"
#include "window/picture.h"
#include "window/presenters/presenter.h"
#include "window/window_commands.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QListView>
#include <QMenu>

namespace voluta::window {

using panels::SceneItem;

ObjectMenus::ObjectMenus(const Parts& parts, panels::FindingsPanel& findings, QObject* parent)
    : QObject(parent), on_(parts) {
  on_.tree.setContextMenuPolicy(Qt::CustomContextMenu);
  connect(&on_.tree, &QWidget::customContextMenuRequested, this, &ObjectMenus::askInTree);
  connect(&on_.viewport, &viewer::Viewport::menuAsked, this, &ObjectMenus::askInView);
  auto* list = findings.findChild<QListView*>(QStringLiteral("list"));
  list->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(list, &QWidget::customContextMenuRequested, this, [list](const QPoint& place) {
    const QModelIndex index = list->indexAt(place);
    if (!index.isValid())
      return;
    auto* menu = new QMenu(list);
    menu->setObjectName(QStringLiteral("findingMenu"));
    menu->addAction(tr("Show its place"), list, [list, index = QPersistentModelIndex(index)] {
      list->setCurrentIndex(index);
      emit list->clicked(index);
    });
    menu->addAction(tr("Copy text"), list,
                    [text = index.data().toString()] { QApplication::clipboard()->setText(text); });
    open(menu, list->viewport()->mapToGlobal(place));
  });
}

void ObjectMenus::open(QMenu* menu, const QPoint& global) {
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (menu->isEmpty())
    menu->deleteLater();
  else
    menu->popup(global);
}

void ObjectMenus::addCommand(QMenu& menu, const char* id) {
  on_.commands.refresh();
  if (QAction* action = on_.commands.action(QLatin1String(id)); action && action->isEnabled())
    menu.addAction(action);
}

void ObjectMenus::askInTree(const QPoint& place) {
  const std::optional<SceneItem> item = on_.tree.sceneItemAt(place);
  if (!item)
    return;
  auto* menu = new QMenu(&on_.tree);
  menu->setObjectName(QStringLiteral("objectMenu"));
  addItem(*menu, *item);
  open(menu, on_.tree.viewport()->mapToGlobal(place));
}

void ObjectMenus::addItem(QMenu& menu, SceneItem item) {
  panels::ObjectTree* tree = &on_.tree;
  menu.addAction(tree->isShown(item) ? tr("Hide") : tr("Show"), this,
                 [tree, item] { tree->toggle(item); });
  menu.addAction(tree->isIsolated(item) ? tr("Show everything") : tr("Show only this"), this,
                 [tree, item] { tree->isolate(item); });
  menu.addSeparator();
  if (item == SceneItem::Part && !on_.document.source()) {
    addCommand(menu, "open");
  } else if (item == SceneItem::Part) {
    menu.addAction(tr("Settings"), this, [this] { on_.pages.show(*on_.pages.find("prepare")); });
    for (const char* id : {"renamePart", "framePart", "duplicatePart", "copiesOfPart", "toolCut",
                           "splitPart", "addRegion", "removePart"})
      addCommand(menu, id);
    menu.addSeparator();
    addMesh(menu);
    menu.addSeparator();
    menu.addAction(tr("Export…"), this, [this] { on_.pages.show(*on_.pages.find("export")); });
    addCommand(menu, "quote");
  } else if (item == SceneItem::Platform) {
    menu.addAction(tr("Settings"), this, [this] {
      on_.pages.show(*on_.pages.find("prepare"));
      if (auto* editor = on_.pages.find("prepare")->side()->findChild<QWidget*>("platform"))
        editor->setFocus(Qt::TabFocusReason);
    });
  } else {
    addCommand(menu, "editCell");
    addCommand(menu, "showArm");
  }
}

// The unit in which the file's lengths are read, and whether the mesh is repaired.
void ObjectMenus::addMesh(QMenu& menu) {
  const project::ItemChoices& own = on_.document.choices().item();
  if (on_.document.source()->cells)
    return;
  QMenu* units = menu.addMenu(tr("Unit of the file"));
  for (const project::LengthUnit& unit : project::lengthUnits()) {
    const std::string word(unit.word);
    QAction* action = units->addAction(
        word == "in" ? tr("inch")
                     : QString::fromStdString(word).replace(QLatin1Char('u'), QChar(u'µ')),
        this, [this, word] {
          project::Choices choices = on_.document.choices();
          choices.item().units = word;
          on_.document.setChoices(choices, tr("unit of the file"));
        });
    action->setCheckable(true);
    action->setChecked(own.units == word);
  }
  QAction* repair = menu.addAction(tr("Repair the mesh"), this, [this](bool on) {
    project::Choices choices = on_.document.choices();
    choices.item().repair = on;
    on_.document.setChoices(choices, on ? tr("repair the mesh") : tr("mesh as read"));
  });
  repair->setCheckable(true);
  repair->setChecked(own.repair);
}

void ObjectMenus::askInView(const std::optional<scene::Hit>& hit, const QPoint& global) {
  using What = scene::Hit::What;
  auto* menu = new QMenu(&on_.viewport);
  menu->setObjectName(QStringLiteral("viewMenuAtObject"));
  if (hit && hit->what == What::Path)
    addBead(*menu, *hit);
  else if (hit && (hit->what == What::Layer || hit->what == What::Voxel) && hit->layer >= 0)
    addLayer(*menu, hit->layer);
  else if (hit && hit->what == What::OtherPart && hit->item < on_.document.partCount())
    menu->addAction(tr("Select this part"), this,
                    [this, item = hit->item] { on_.document.setActive(item); });
  else if (hit)
    addItem(*menu, hit->what == What::Platform ? SceneItem::Platform
                   : hit->what == What::Cell   ? SceneItem::Cell
                                               : SceneItem::Part);
  if (on_.viewport.view().hiddenKinds != 0)
    menu->addAction(tr("Show all beads"), this, [this] {
      Look look = on_.picture.look();
      look.hiddenKinds = 0;
      on_.picture.setLook(look);
    });
  if (!menu->isEmpty())
    menu->addSeparator();
  addCommand(*menu, "frameAll");
  open(menu, global);
}

void ObjectMenus::addLayer(QMenu& menu, int layer) {
  timeline::LayerRangeSlider* layers = &on_.layers;
  if (layers->isVisible() && layer < layers->layerCount()) {
    menu.addAction(tr("Show only layer %1").arg(layer + 1), this,
                   [layers, layer] { layers->setRange(layer, layer); });
    menu.addAction(tr("Show up to layer %1").arg(layer + 1), this,
                   [layers, layer] { layers->setRange(0, layer); });
    menu.addAction(tr("Show all layers"), this,
                   [layers] { layers->setRange(0, layers->layerCount() - 1); });
  }
}

void ObjectMenus::addBead(QMenu& menu, const scene::Hit& hit) {
  addLayer(menu, hit.layer);
  const auto& clock = on_.presenter.clock();
  if (const auto time =
          clock && !clock->empty() ? clock->timeOfWaypoint(hit.waypoint) : std::nullopt)
    menu.addAction(tr("Go to this moment"), this, [this, time] {
      on_.pages.show(*on_.pages.find("simulate"));
      on_.pages.showTime(*time);
    });
  if (on_.layers.isVisible() && on_.picture.look().colourBy == scene::ColourBy::Kind) {
    const auto& statistics = on_.presenter.statistics();
    if (statistics && statistics->of && hit.path < statistics->of->paths.size()) {
      const auto kind = static_cast<unsigned>(statistics->of->paths[hit.path].kind);
      menu.addAction(tr("Hide beads of this kind"), this, [this, kind] {
        Look look = on_.picture.look();
        look.hiddenKinds |= 1U << kind;
        on_.picture.setLook(look);
      });
    }
  }
}

} // namespace voluta::window
