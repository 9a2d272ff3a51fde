// A form built from a table of parameters: groups that fold, simple or full view, search (all
// words, in label, key, group or help of any parameter), marks for values that differ from the
// default, reset.
#pragma once

#include "base/parameters.h"

#include <QPointer>
#include <QStringList>
#include <QWidget>
#include <functional>
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

  // Puts a widget above the groups, inside the scrolled area; the form takes ownership. `search`
  // shows only those of its fields that have all words (all fields without any), and returns
  // whether there is one.
  using Search = std::function<bool(const QStringList& words)>;
  void setHeader(QWidget* header, Search search = {});
  // Puts a widget into the group of the settings for research, which is closed at first; the same.
  void setResearch(QWidget* choices, Search search = {});

  // Sets other defaults for the same parameters; setValues must follow. Emits nothing.
  void setDefaults(const base::ParameterTable& table);
  // Sets the texts, by key, of the parameters that were changed; all others show their default.
  // Emits nothing. Ignores unknown keys and texts that the parameter cannot take.
  void setValues(const std::map<std::string, std::string>& changed);

  // Shows one line per key below rows whose values are invalid, in every view; lines of all other
  // rows are removed.
  void setProblems(const std::map<std::string, std::string>& byKey);

  // Sets the keys of the parameters that affect the result; others are not shown in any view.
  // Initially all.
  void setApplying(const std::set<std::string>& keys);

  // false: shows only the parameters that every user needs, and changed ones.
  void setShowAll(bool all);

  // Whether the row's parameter affects the result.
  bool offers(const ParameterRow& row) const;
  bool isSearching() const { return isSearching_; }
  // Ends the search and shows all parameters, if the field of the form is hidden without that.
  void reveal(const QWidget& field);

signals:
  // A value was committed; `text` is accepted by base::parseParameter.
  void changed(const QString& key, const QString& text);
  void resetRequested(const QString& key);
  void resetAllRequested();

protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void leaveSearch(bool toFound);
  // The first settings and those for research have a group each, beside those of the table.
  enum class Section { First, Table, Research };
  struct Group {
    Section section = Section::Table;
    base::Text name;
    Fold* fold = nullptr;
    std::vector<ParameterRow*> rows;
  };
  void build();
  void addRows();
  Group& groupOf(Section section, base::Text name, QWidget* content);
  QString titleOf(const Group& group) const;
  void filter();
  void mark();
  void showSwitch();
  void retranslate();

  bool applies(const std::string& key) const { return !applying_ || applying_->contains(key); }

  base::ParameterTable table_;
  std::optional<std::set<std::string>> applying_; // None: all
  std::vector<Group> groups_;
  Search searchHeader_, searchResearch_;
  bool isSearching_ = false;
  QPointer<QWidget> beforeSearch_; // Had the focus
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
