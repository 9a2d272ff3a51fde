// The choices that are no parameters: mode, growth, platform, cell, process, seed.
#pragma once

#include "forms/platform_editor.h"

#include <QString>
#include <QWidget>
#include <map>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace voluta::forms {

// One entry of a list: what is handed on, what is shown, what its tool tip says (may be empty).
struct ChoiceItem {
  QString id, label, help;
};

struct ChoiceLists {
  std::vector<ChoiceItem> modes, growths, cells, processes;
  std::map<QString, std::vector<project::PlatformUse>> platforms; // that a mode takes
};

struct ChoiceTexts {
  QString mode, growth, platform, cell, process;
  int seed = 1;
  RodProfile rod = {};
};

class ChoicesForm : public QWidget {
  Q_OBJECT

public:
  explicit ChoicesForm(QWidget* parent = nullptr);

  // Keeps what is chosen where the new lists have it. Emits nothing.
  void setLists(const ChoiceLists& lists);
  // Emits nothing. An id that is in no list is added to it as it is.
  void setTexts(const ChoiceTexts& texts);

  // Does the way of building ask for a growth scheme? At first it does.
  void setGrows(bool grows);

  // One line beside the choices with a button that does something about it; both empty: none. A
  // line without a button tells something. `blocking`: nothing can be planned like this.
  void setNotice(const QString& line, const QString& button, bool blocking);
  void choosePlatformFile();

signals:
  void noticePressed();
  void rodProfileChanged(const voluta::forms::RodProfile& profile);
  // `field` is "mode", "growth", "platform", "cell", "process" or "seed".
  void changed(const QString& field, const QString& text);

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Row {
    QLabel* label = nullptr;
    QComboBox* combo = nullptr;
    QString tip; // where the entry that is chosen has none
  };
  void addCombo(Row& row, const QString& field, int at);
  static void showTip(const Row& row);
  void retranslate();

  Row mode_, growth_, cell_, process_;
  QLabel* platformLabel_ = nullptr;
  PlatformEditor* platform_ = nullptr;
  QLabel* seedLabel_ = nullptr;
  QSpinBox* seed_ = nullptr;
  QWidget* noticeRow_ = nullptr;
  QLabel *noticeIcon_ = nullptr, *notice_ = nullptr;
  QPushButton* noticeButton_ = nullptr;
  std::map<QString, std::vector<project::PlatformUse>> platforms_;
};

} // namespace voluta::forms
