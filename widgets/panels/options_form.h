// The options of a program format, one per row.
#pragma once

#include "base/parameters.h"

#include <QWidget>
#include <map>
#include <string>
#include <vector>

class QVBoxLayout;

namespace voluta::forms {
class ParameterRow;
}

namespace voluta::panels {

class OptionsForm : public QWidget {
  Q_OBJECT

public:
  explicit OptionsForm(QWidget* parent = nullptr);

  // Keeps the rows if the options are the same. Emits nothing.
  void setOptions(const std::vector<base::ParameterSpec>& options);
  // Changed values as texts by key; all others show their default. Emits nothing.
  void setValues(const std::map<std::string, std::string>& changed);
  bool isEmpty() const { return rows_.empty(); }

signals:
  // `text` is parsed by base::parseParameter.
  void changed(const QString& key, const QString& text);
  void resetRequested(const QString& key);

protected:
  void changeEvent(QEvent* event) override;

private:
  bool shows(const std::vector<base::ParameterSpec>& options) const;

  std::vector<forms::ParameterRow*> rows_;
  QVBoxLayout* column_;
};

} // namespace voluta::panels
