// Form for the choices that are not parameters: mode, growth, platform, cell, process, material,
// seed.
#pragma once

#include "forms/choice_combo.h"
#include "forms/platform_editor.h"
#include "forms/tool_rows.h"

#include <QString>
#include <QStringList>
#include <QWidget>
#include <map>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace voluta::forms {

struct ChoiceLists {
  std::vector<ChoiceItem> modes, growths, cells, processes, materials;
  std::map<QString, std::vector<project::PlatformUse>> platforms; // Supported by a mode
};

struct ChoiceTexts {
  QString mode, growth, platform, cell, process;
  int seed = 1;
  RodProfile rod = {};
  QString material = {}, materialFacts = {};
  QString materialColour = {};               // #RRGGBB
  QString cellLabel = {}, processLabel = {}; // of those that are in no list
  std::vector<ToolTexts> moreTools = {};     // beside the first, which has the process above
};

class ChoicesForm : public QWidget {
  Q_OBJECT

public:
  explicit ChoicesForm(QWidget* parent = nullptr);

  // Keeps the selection if the new lists contain it. Emits nothing.
  void setLists(const ChoiceLists& lists);
  // Emits nothing. An id that is in no list is added to it unchanged.
  void setTexts(const ChoiceTexts& texts);

  // Whether the way of building needs a growth scheme; true initially.
  void setGrows(bool grows);

  // One line beside the choices with a button that acts on it; both empty: none. A line without a
  // button is a message. `blocking`: planning is not possible in this state.
  void setNotice(const QString& line, const QString& button, bool blocking);
  void choosePlatformFile();
  ToolRows* tools() { return tools_; }
  // Growth scheme and seed: in this form, unless they are placed elsewhere.
  QWidget* research() { return research_; }
  // Shows only the fields that have all words in their label, their tool tip or their synonyms; all
  // fields without a word. Returns whether there is one, without or within research().
  bool showMatching(const QStringList& words);
  bool showMatchingResearch(const QStringList& words);

signals:
  void noticePressed();
  // `field` is "process" or "material": its library is wanted.
  void libraryRequested(const QString& field);
  void rodProfileChanged(const voluta::forms::RodProfile& profile);
  // `field` is "mode", "growth", "platform", "cell", "process", "material" or
  // "seed".
  void changed(const QString& field, const QString& text);

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Row {
    QLabel* label = nullptr;
    QComboBox* combo = nullptr;
    QToolButton* library = nullptr; // Only of processes and materials
    QString tip;                    // Used if the selected entry has none
  };
  void addCombo(Row& row, const QString& field, QGridLayout& grid, int at);
  void addLibrary(Row& row, const QString& field, int at);
  static void showTip(const Row& row);
  void retranslate();

  void showMaterial(const ChoiceTexts& texts);

  Row mode_, growth_, cell_, process_, material_;
  QLabel* materialFacts_ = nullptr;
  ToolRows* tools_ = nullptr;
  QLabel* platformLabel_ = nullptr;
  PlatformEditor* platform_ = nullptr;
  QWidget* research_ = nullptr;
  bool grows_ = true;
  QLabel* seedLabel_ = nullptr;
  QSpinBox* seed_ = nullptr;
  QWidget* noticeRow_ = nullptr;
  QLabel *noticeIcon_ = nullptr, *notice_ = nullptr;
  QPushButton* noticeButton_ = nullptr;
  std::map<QString, std::vector<project::PlatformUse>> platforms_;
};

} // namespace voluta::forms
