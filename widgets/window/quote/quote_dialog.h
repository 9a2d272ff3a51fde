// The cost of the planned print, and its page for a customer as PDF or HTML.
#pragma once

#include "jobs/job_runner.h"
#include "window/quote/quote.h"

#include <QDialog>
#include <memory>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace voluta::forms {
class NumberBox;
}

namespace voluta::window {

class QuoteDialog : public QDialog {
  Q_OBJECT

public:
  // `plan` has a motion; null: nothing is planned. `size`: of the part, as shown.
  QuoteDialog(std::shared_ptr<const pipeline::PlanResult> plan, QString name, QString size,
              QWidget* parent);

  const PrintQuote& quote() const { return quote_; }

private:
  void build();
  void show();
  void save();

  std::shared_ptr<const pipeline::PlanResult> plan_;
  QString name_, size_;
  std::string cell_; // of the print
  PrintQuote quote_;
  jobs::JobRunner runner_;
  forms::NumberBox *machine_, *fixed_, *margin_;
  QLabel *total_, *state_;
  QTreeWidget* rows_;
  QPushButton* save_;
};

} // namespace voluta::window
