// A list of all keys, each of which can be changed.
#pragma once

#include <QDialog>
#include <QKeySequence>
#include <vector>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QTableWidget;

namespace voluta::window {

// Returns the key stored in the settings for an action, else its default.
QKeySequence shortcutOf(const QString& id, const QKeySequence& standard);

class ShortcutsDialog : public QDialog {
  Q_OBJECT

public:
  // Actions need an object name and the property "defaultShortcut". Accepting the dialog changes
  // them and the settings.
  ShortcutsDialog(std::vector<QAction*> actions, QWidget* parent);

  void accept() override;

private:
  void fill();
  void chosen();
  void edited(const QKeySequence& keys);
  void filter(const QString& text);

  std::vector<QAction*> actions_;
  std::vector<QKeySequence> keys_; // As edited, in the order of actions_
  QLineEdit* search_;
  QTableWidget* table_;
  QKeySequenceEdit* edit_;
  QLabel* clash_;
};

} // namespace voluta::window
