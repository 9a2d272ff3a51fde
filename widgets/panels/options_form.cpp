#include "panels/options_form.h"

#include "base/error.h"
#include "forms/discard.h"
#include "forms/parameter_row.h"

#include <QEvent>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::panels {

OptionsForm::OptionsForm(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(0);
}

bool OptionsForm::shows(const std::vector<base::ParameterSpec>& options) const {
  return std::ranges::equal(
      rows_, options, {}, [](const auto* row) { return row->spec().key; },
      &base::ParameterSpec::key);
}

void OptionsForm::setOptions(const std::vector<base::ParameterSpec>& options) {
  if (shows(options))
    return;
  for (forms::ParameterRow* row : rows_)
    forms::discard(row);
  rows_.clear();
  for (const base::ParameterSpec& option : options) {
    auto* row = new forms::ParameterRow(option, this);
    connect(row, &forms::ParameterRow::committed, this, &OptionsForm::changed);
    connect(row, &forms::ParameterRow::resetRequested, this, &OptionsForm::resetRequested);
    column_->addWidget(row);
    rows_.push_back(row);
  }
}

void OptionsForm::setValues(const std::map<std::string, std::string>& changed) {
  for (forms::ParameterRow* row : rows_) {
    base::ParameterValue value = row->spec().defaultValue;
    if (const auto at = changed.find(row->spec().key); at != changed.end())
      try {
        value = base::parseParameter(row->spec(), at->second);
      } catch (const base::Error&) {
        // Shows the default; planning reports the invalid value.
      }
    if (row->value() != value)
      row->setValue(value);
  }
}

void OptionsForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    for (forms::ParameterRow* row : rows_)
      row->retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
