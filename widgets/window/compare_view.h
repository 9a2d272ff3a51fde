// Comparison of print modes: the table in the middle, the list of modes to compare beside it.
#pragma once

#include "document/comparing.h"
#include "document/document.h"
#include "panels/compare_panel.h"
#include "panels/compare_table.h"

#include <QStringList>
#include <QWidget>

class QLabel;
class QPushButton;
class QStackedLayout;

namespace voluta::window {

class CompareView : public QWidget {
  Q_OBJECT

public:
  // `document` and `comparing` must outlive this; the panel is created here, to be placed beside
  // it.
  CompareView(document::Document& document, document::Comparing& comparing,
              QWidget* parent = nullptr);

  panels::ComparePanel* panel() { return panel_; }
  void setLists(const std::vector<forms::ChoiceItem>& modes,
                const std::vector<forms::ChoiceItem>& growths,
                const std::vector<forms::ChoiceItem>& cells);

signals:
  // The document has adopted a row; `result` is its plan, if it was kept.
  void adopted(const QString& strategy, std::shared_ptr<const pipeline::PlanResult> result);

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  void listen();
  document::ComparedWays ways() const;
  panels::CompareEntry entryOf(std::size_t row) const;
  std::vector<panels::CompareEntry> entries() const;
  void run();
  void adopt(int row);
  void showAll();
  void showRow(int row);
  void showRanking();
  void showState();
  void showModes();
  void showCount();
  void retranslate();

  document::Document& document_;
  document::Comparing& comparing_;
  panels::ComparePanel* panel_ = nullptr;
  panels::CompareTable* table_ = nullptr;
  QStackedLayout* shown_ = nullptr;
  QLabel *empty_ = nullptr, *verdict_ = nullptr;
  QPushButton* adopt_ = nullptr;
  std::vector<forms::ChoiceItem> modes_, growths_; // All existing ones
  QStringList listed_;                             // The modes offered
};

} // namespace voluta::window
