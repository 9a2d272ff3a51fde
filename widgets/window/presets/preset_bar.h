// The preset of printing: a list that shows presets below their parents, and the menu of all that
// can be done with one.
#pragma once

#include <QString>
#include <QWidget>
#include <map>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace voluta::window {

enum class PresetDeed { Save, SaveAs, Rename, Delete, Discard, Compare, Export, Import };

struct PresetEntry {
  QString choice;       // As the job stores it; empty: a heading
  QString label, about; // about: its tool tip
  int depth = 0;        // Number of parents shown above it

  bool operator==(const PresetEntry&) const = default;
};

class PresetBar : public QWidget {
  Q_OBJECT

public:
  explicit PresetBar(QWidget* parent = nullptr);

  // Emits nothing. `changed`: settings of the chosen entry were changed, and it is marked.
  void showPresets(const std::vector<PresetEntry>& entries, const QString& chosen, bool changed);
  void setPossible(PresetDeed deed, bool possible);

signals:
  void chosen(const QString& choice);
  void asked(voluta::window::PresetDeed deed);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void fill();

  QLabel* label_;
  QComboBox* combo_;
  QToolButton* button_;
  QMenu* menu_;
  std::map<PresetDeed, QAction*> actions_;
  std::vector<PresetEntry> entries_;
  QString chosen_;
};

} // namespace voluta::window
