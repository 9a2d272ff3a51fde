// The options that a program format brings, each in a row.
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

  // Rows stay where they are the same options. Emits nothing.
  void setOptions(const std::vector<base::ParameterSpec>& options);
  // Texts by key of what was changed; all others show their default. Emits nothing.
  void setValues(const std::map<std::string, std::string>& changed);
  bool isEmpty() const { return rows_.empty(); }

signals:
  // `text` is what base::parseParameter takes.
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
