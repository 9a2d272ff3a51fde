// The window's commands, one row each: menus, tool bar, shortcuts and the list of shortcuts are
// built from the rows.
#pragma once

#include <QIcon>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <functional>
#include <vector>

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;
class QWidget;

namespace voluta::window {

// Groups of the tool bar, with a separator between them; the pages are between Undo and View.
// Parts, Tools and Place are groups of the tools in the view instead.
enum class BarGroup { None, File, Undo, View, Run, Parts, Tools, Place };

struct Command {
  QString id;       // Of the action: for settings and tests
  const char* menu; // Id of the menu that contains it
  int group = 0;    // Entries of a menu are sorted by group, with a separator between groups
  // Source texts of the context "Commands", translated again when the language changes.
  const char* text = nullptr;
  const char* tip = nullptr;
  QList<QKeySequence> keys = {}; // Default shortcuts, if the user has chosen no others
  std::function<void()> does = {};
  std::function<bool()> enabled = {}; // None: always
  std::function<bool()> checked = {}; // None: not checkable
  const char* icon = nullptr;
  BarGroup bar = BarGroup::None;
  std::function<QString()> says = {};      // Replaces `text`
  std::function<const char*()> draws = {}; // Replaces `icon`
};

// A menu, or a submenu: `in` is then the parent's id and `group` as for a command.
struct CommandMenu {
  const char *id, *text;
  const char* in = nullptr;
  int group = 0;
};

// An existing action to be placed in a menu.
struct PlacedAction {
  QAction* action;
  const char* menu;
  int group = 0;
};

class CommandTable : public QObject {
  Q_OBJECT

public:
  // The window must outlive this.
  explicit CommandTable(QMainWindow& window);
  ~CommandTable() override;

  // Add rows before build(); ids must be unique.
  void add(std::vector<Command> commands);
  void add(PlacedAction action);
  // Builds the menus in this order, with their entries sorted by group and then in the order added;
  // `middle` is placed in the middle of the tool bar.
  void build(const std::vector<CommandMenu>& menus, QWidget* middle);

  // Updates which commands are enabled and which are checked.
  void refresh();
  void retranslate();
  void redrawIcons();

  // Whether commands that run something also show their names in the tool bar; true initially.
  void setBarWords(bool words);
  QToolBar* toolBar() const { return bar_; } // Valid after build()
  // In the order added.
  std::vector<QAction*> actionsOf(BarGroup group) const;
  QAction* action(const QString& id) const;
  QMenu* menu(const QString& id) const; // Valid after build()
  std::vector<QMenu*> menus() const;    // Valid after build()
  // In the order of the menus.
  std::vector<QAction*> actions() const;

private:
  struct Row {
    Command command;
    QAction* action;
    QString drawn = {}; // Name of the icon on show
  };
  struct Menu {
    CommandMenu row;
    QMenu* menu;
  };
  void makeAction(Row& row);
  void drawIcon(Row& row);
  void fill(const Menu& menu);
  void buildToolBar(QWidget* middle);
  void addToBar(QToolBar& bar, BarGroup first, BarGroup last);

  QMainWindow& window_;
  QToolBar* bar_ = nullptr;
  std::vector<Row> rows_;
  std::vector<PlacedAction> placed_;
  std::vector<Menu> menus_;
};

} // namespace voluta::window
