// Ways of building compared: the table in the middle, what is compared beside it.
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
  // `document` and `comparing` outlive this; the panel is made here, to be put beside it.
  CompareView(document::Document& document, document::Comparing& comparing,
              QWidget* parent = nullptr);

  panels::ComparePanel* panel() { return panel_; }
  void setLists(const std::vector<forms::ChoiceItem>& modes,
                const std::vector<forms::ChoiceItem>& growths);

signals:
  // The document has taken over a row; its plan, where it is kept.
  void adopted(const QString& way, std::shared_ptr<const pipeline::PlanResult> result);

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
  std::vector<forms::ChoiceItem> modes_, growths_; // all there are
  QStringList listed_;                             // modes that are offered
};

} // namespace voluta::window
