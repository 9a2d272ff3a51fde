// The further tools of a job: process and material of each; add and remove.
#pragma once

#include "forms/choice_combo.h"

#include <QString>
#include <QWidget>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace voluta::forms {

struct ToolTexts {
  QString process, material;
  QString colour = {}; // #RRGGBB
};

class ToolRows : public QWidget {
  Q_OBJECT

public:
  explicit ToolRows(QWidget* parent = nullptr);

  // Emits nothing.
  void setLists(const std::vector<ChoiceItem>& processes, const std::vector<ChoiceItem>& materials);
  // The tools from the second on. Emits nothing.
  void setTools(const std::vector<ToolTexts>& tools);

signals:
  void addRequested();
  // `tool`: index in the job's tools, from 1.
  void removeRequested(int tool);
  void processChosen(int tool, const QString& id);
  void materialChosen(int tool, const QString& id);

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Row {
    QLabel* label = nullptr;
    QComboBox *process = nullptr, *material = nullptr;
    QToolButton* remove = nullptr;
  };
  void addRow();
  void retranslate();

  QGridLayout* grid_;
  std::vector<ChoiceItem> processes_, materials_;
  std::vector<Row> rows_;
  QToolButton* add_;
};

} // namespace voluta::forms
