// What the window can do, one row a command: menus, tool bar, keys and the list of keys are made
// from the rows.
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

// Groups of the tool bar; a line stands between two. The pages are between Tools and View.
enum class BarGroup { None, File, Undo, Tools, View, Run };

struct Command {
  QString id;       // of the action: for settings and tests
  const char* menu; // id of the menu it is in
  int group = 0;    // entries of a menu go by group; a line stands between two
  // Source texts of the context "Commands", translated anew with the language.
  const char* text = nullptr;
  const char* tip = nullptr;
  QList<QKeySequence> keys = {}; // where the user has chosen no others
  std::function<void()> does = {};
  std::function<bool()> enabled = {}; // none: always
  std::function<bool()> checked = {}; // none: it has no check mark
  const char* icon = nullptr;
  BarGroup bar = BarGroup::None;
  std::function<QString()> says = {}; // in place of `text`
};

// A menu, or one inside another: `in` is then the other's id and `group` as of a command.
struct CommandMenu {
  const char *id, *text;
  const char* in = nullptr;
  int group = 0;
};

// An action that was made elsewhere and has a place in a menu.
struct PlacedAction {
  QAction* action;
  const char* menu;
  int group = 0;
};

class CommandTable : public QObject {
  Q_OBJECT

public:
  // The window outlives this.
  explicit CommandTable(QMainWindow& window);
  ~CommandTable() override;

  // Rows before build(); ids differ.
  void add(std::vector<Command> commands);
  void add(PlacedAction action);
  // Menus in this order, their entries by group and then as they were added; `middle` stands in
  // the middle of the tool bar.
  void build(const std::vector<CommandMenu>& menus, QWidget* middle);

  // Which commands can be used, and which are on.
  void refresh();
  void retranslate();
  void redrawIcons();

  // Whether commands that run something have their words in the tool bar too; at first they do.
  void setBarWords(bool words);
  QToolBar* toolBar() const { return bar_; } // after build()
  QAction* action(const QString& id) const;
  QMenu* menu(const QString& id) const; // after build()
  // In the order of the menus.
  std::vector<QAction*> actions() const;

private:
  struct Row {
    Command command;
    QAction* action;
  };
  struct Menu {
    CommandMenu row;
    QMenu* menu;
  };
  void makeAction(Row& row);
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
