// A form made from a table of parameters: groups that fold, simple or all, search (all words, in
// label, key, group or help of any parameter), marks where a value is not the default, reset.
#pragma once

#include "base/parameters.h"

#include <QWidget>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

class QLabel;
class QLineEdit;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace voluta::forms {

class Fold;
class ParameterRow;

class ParameterForm : public QWidget {
  Q_OBJECT

public:
  explicit ParameterForm(base::ParameterTable table, QWidget* parent = nullptr);
  ~ParameterForm() override;

  // Puts a widget above the groups, inside the scrolled area; the form takes it over.
  void setHeader(QWidget* header);

  // Other defaults for the same parameters; setValues is to follow. Emits nothing.
  void setDefaults(const base::ParameterTable& table);
  // Texts by key of the parameters that were changed; all others show their default. Emits
  // nothing. A text that its parameter cannot take, or an unknown key, is left out.
  void setValues(const std::map<std::string, std::string>& changed);

  // The text of that parameter may name a file. `patterns` of names, separated by blanks; `prefix`
  // stands before the name.
  void offerFiles(const std::string& key, const QString& patterns, const QString& prefix);

  // One line by key under the rows whose values can't be used, whatever view is on; those of all
  // other rows go.
  void setProblems(const std::map<std::string, std::string>& byKey);

  // Keys of the parameters that have a say in what is made; the others are not shown in any view.
  // At first: all.
  void setApplying(const std::set<std::string>& keys);

  // false: only what every user needs, and whatever was changed.
  void setShowAll(bool all);

signals:
  // A value was committed; `text` is what base::parseParameter takes.
  void changed(const QString& key, const QString& text);
  void resetRequested(const QString& key);
  void resetAllRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Group {
    base::Text name;
    Fold* fold = nullptr;
    std::vector<ParameterRow*> rows;
  };
  void build();
  void filter();
  void mark();
  void showSwitch();
  void retranslate();

  bool applies(const std::string& key) const { return !applying_ || applying_->contains(key); }

  base::ParameterTable table_;
  std::optional<std::set<std::string>> applying_; // none: all
  std::vector<Group> groups_;
  QLineEdit* search_ = nullptr;
  QToolButton* simple_ = nullptr;
  QToolButton* all_ = nullptr;
  QToolButton* resetAll_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QVBoxLayout* column_ = nullptr;
  QLabel* nothingFound_ = nullptr;
  bool showsAll_ = false;
};

} // namespace voluta::forms
