// The choices that are no parameters: mode, growth, platform, cell, process, seed.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QSpinBox;

namespace voluta::forms {

class PlatformEditor;

// One entry of a list: what is handed on, what is shown, what its tool tip says (may be empty).
struct ChoiceItem {
  QString id, label, help;
};

struct ChoiceLists {
  std::vector<ChoiceItem> modes, growths, cells, processes;
};

struct ChoiceTexts {
  QString mode, growth, platform, cell, process;
  int seed = 1;
};

class ChoicesForm : public QWidget {
  Q_OBJECT

public:
  explicit ChoicesForm(QWidget* parent = nullptr);

  // Keeps what is chosen where the new lists have it. Emits nothing.
  void setLists(const ChoiceLists& lists);
  // Emits nothing. An id that is in no list is added to it as it is.
  void setTexts(const ChoiceTexts& texts);

signals:
  // `field` is "mode", "growth", "platform", "cell", "process" or "seed".
  void changed(const QString& field, const QString& text);

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Row {
    QLabel* label = nullptr;
    QComboBox* combo = nullptr;
  };
  Row addCombo(const QString& field, int at);
  void retranslate();

  Row mode_, growth_, cell_, process_;
  QLabel* platformLabel_ = nullptr;
  PlatformEditor* platform_ = nullptr;
  QLabel* seedLabel_ = nullptr;
  QSpinBox* seed_ = nullptr;
};

} // namespace voluta::forms
