// All keys in one list, each to be changed.
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

// The key kept in the settings for an action, else its default.
QKeySequence shortcutOf(const QString& id, const QKeySequence& standard);

class ShortcutsDialog : public QDialog {
  Q_OBJECT

public:
  // Actions have an object name and the property "defaultShortcut". They are changed, and the
  // settings with them, when the dialog is accepted.
  ShortcutsDialog(std::vector<QAction*> actions, QWidget* parent);

  void accept() override;

private:
  void fill();
  void chosen();
  void edited(const QKeySequence& keys);
  void filter(const QString& text);

  std::vector<QAction*> actions_;
  std::vector<QKeySequence> keys_; // as edited, in the order of actions_
  QLineEdit* search_;
  QTableWidget* table_;
  QKeySequenceEdit* edit_;
  QLabel* clash_;
};

} // namespace voluta::window
