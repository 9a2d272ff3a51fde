#include "window/window_commands.h"

#include "window/shortcuts_dialog.h"
#include "window/window_icons.h"

#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr int kBarIcon = 20;

QString translated(const char* text) {
  return text ? QCoreApplication::translate("Commands", text) : QString();
}
} // namespace

CommandTable::CommandTable(QMainWindow& window) : QObject(&window), window_(window) {}

CommandTable::~CommandTable() = default;

void CommandTable::add(std::vector<Command> commands) {
  for (Command& command : commands) {
    rows_.push_back({std::move(command), nullptr});
    makeAction(rows_.back());
  }
}

void CommandTable::add(PlacedAction action) {
  placed_.push_back(action);
}

void CommandTable::makeAction(Row& row) {
  const Command& command = row.command;
  auto* action = new QAction(&window_);
  row.action = action;
  action->setObjectName(command.id);
  const QKeySequence standard = command.keys.isEmpty() ? QKeySequence() : command.keys.first();
  const QKeySequence chosen = shortcutOf(command.id, standard);
  action->setShortcuts(chosen == standard ? command.keys : QList<QKeySequence>{chosen});
  action->setProperty("defaultShortcut", standard);
  action->setCheckable(static_cast<bool>(command.checked));
  window_.addAction(action); // Makes its shortcut work while the menu is closed
  connect(action, &QAction::triggered, this, [this, does = command.does] {
    does();
    refresh();
  });
}

void CommandTable::build(const std::vector<CommandMenu>& menus, QWidget* middle) {
  for (const CommandMenu& row : menus) {
    QMenu* made = row.in ? new QMenu(&window_) : window_.menuBar()->addMenu(QString());
    made->setObjectName(row.id);
    made->setToolTipsVisible(true);
    menus_.push_back({row, made});
  }
  for (const Menu& menu : menus_)
    fill(menu);
  buildToolBar(middle);
  retranslate();
  redrawIcons();
}

void CommandTable::fill(const Menu& menu) {
  std::vector<std::pair<int, QAction*>> entries;
  const auto isHere = [&](const char* id) { return id && QLatin1String(id) == menu.row.id; };
  for (const Row& row : rows_)
    if (isHere(row.command.menu))
      entries.emplace_back(row.command.group, row.action);
  for (const Menu& inner : menus_)
    if (isHere(inner.row.in))
      entries.emplace_back(inner.row.group, inner.menu->menuAction());
  for (const PlacedAction& placed : placed_)
    if (isHere(placed.menu))
      entries.emplace_back(placed.group, placed.action);
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i > 0 && entries[i].first != entries[i - 1].first)
      menu.menu->addSeparator();
    menu.menu->addAction(entries[i].second);
  }
}

void CommandTable::buildToolBar(QWidget* middle) {
  auto* bar = new QToolBar(&window_);
  bar_ = bar;
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  bar->setIconSize({kBarIcon, kBarIcon});
  window_.addToolBar(bar);
  const auto space = [&] {
    auto* filler = new QWidget(bar);
    filler->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(filler);
  };
  addToBar(*bar, BarGroup::File, BarGroup::Undo);
  space();
  bar->addWidget(middle);
  space();
  addToBar(*bar, BarGroup::View, BarGroup::Run);
  setBarWords(true);
  // Without a context menu the tool bar cannot be hidden by mistake, which would be hard to undo.
  window_.setContextMenuPolicy(Qt::NoContextMenu);
}

void CommandTable::addToBar(QToolBar& bar, BarGroup first, BarGroup last) {
  for (int group = static_cast<int>(first); group <= static_cast<int>(last); ++group) {
    if (group > static_cast<int>(first))
      bar.addSeparator();
    for (const Row& row : rows_) {
      if (static_cast<int>(row.command.bar) != group)
        continue;
      bar.addAction(row.action);
    }
  }
}

void CommandTable::setBarWords(bool words) {
  for (const Row& row : rows_)
    if (auto* button = qobject_cast<QToolButton*>(bar_->widgetForAction(row.action));
        button && row.command.bar == BarGroup::Run)
      button->setToolButtonStyle(words ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
}

void CommandTable::refresh() {
  for (Row& row : rows_) {
    if (row.command.enabled)
      row.action->setEnabled(row.command.enabled());
    if (row.command.checked)
      row.action->setChecked(row.command.checked());
    if (row.command.says)
      row.action->setText(row.command.says());
    if (row.command.draws)
      drawIcon(row);
  }
}

void CommandTable::retranslate() {
  for (const Menu& menu : menus_)
    menu.menu->setTitle(translated(menu.row.text));
  for (const Row& row : rows_) {
    if (row.command.text)
      row.action->setText(translated(row.command.text));
    const QString tip = translated(row.command.tip);
    const QString keys = row.action->shortcut().toString(QKeySequence::NativeText);
    if (!tip.isEmpty())
      row.action->setToolTip(keys.isEmpty() ? tip : QString("%1 (%2)").arg(tip, keys));
  }
  refresh();
}

void CommandTable::redrawIcons() {
  for (Row& row : rows_) {
    row.drawn.clear();
    drawIcon(row);
  }
}

void CommandTable::drawIcon(Row& row) {
  const QString name = QLatin1String(row.command.draws ? row.command.draws() : row.command.icon);
  if (name.isEmpty() || name == row.drawn)
    return;
  row.drawn = name;
  row.action->setIcon(icon(name, window_.palette()));
}

std::vector<QAction*> CommandTable::actionsOf(BarGroup group) const {
  std::vector<QAction*> actions;
  for (const Row& row : rows_)
    if (row.command.bar == group)
      actions.push_back(row.action);
  return actions;
}

QAction* CommandTable::action(const QString& id) const {
  const auto at = std::find_if(rows_.begin(), rows_.end(),
                               [&](const Row& row) { return row.command.id == id; });
  return at == rows_.end() ? nullptr : at->action;
}

QMenu* CommandTable::menu(const QString& id) const {
  const auto at = std::find_if(menus_.begin(), menus_.end(),
                               [&](const Menu& menu) { return menu.row.id == id; });
  return at == menus_.end() ? nullptr : at->menu;
}

std::vector<QMenu*> CommandTable::menus() const {
  std::vector<QMenu*> all;
  for (const Menu& menu : menus_)
    all.push_back(menu.menu);
  return all;
}

std::vector<QAction*> CommandTable::actions() const {
  std::vector<QAction*> all;
  for (const Menu& menu : menus_)
    for (QAction* entry : menu.menu->actions())
      if (action(entry->objectName()) == entry)
        all.push_back(entry);
  return all;
}

} // namespace voluta::window
