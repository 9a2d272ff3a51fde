// Form for a process or a material of the library: its fields in groups, marks of those that differ
// from the item that it is based on, and a problem beside the field that has one.
#pragma once

#include "process/library_fields.h"

#include <QWidget>
#include <memory>
#include <vector>

class QAction;
class QLineEdit;
class QVBoxLayout;

namespace voluta::forms {
class Fold;
class ParameterRow;
} // namespace voluta::forms

namespace voluta::panels {

class ItemForm : public QWidget {
  Q_OBJECT

public:
  explicit ItemForm(QWidget* parent = nullptr);
  ~ItemForm() override;

  // Shows an item; `reference`: the one that it is compared with and reset to. Emits nothing.
  void setItem(const process::LibraryItem& item, const process::LibraryItem& reference,
               bool readOnly);
  // Shows a problem beside its field; none: the item can be saved.
  void setProblem(const std::optional<process::FieldProblem>& problem);
  // Returns the label of a field, in the language of the window; empty for an unknown key.
  QString labelOf(const std::string& key) const;
  // Number of fields that differ from the reference.
  int changedFields() const;

signals:
  void edited(const voluta::process::LibraryItem& item);

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Row {
    process::LibraryField field;
    forms::ParameterRow* row = nullptr;
  };
  struct Group {
    base::Text name;
    forms::Fold* fold = nullptr;
  };
  void build();
  forms::Fold* foldOf(base::Text group);
  void addRow(const process::LibraryField& field);
  void addSwatch(std::size_t at, QLineEdit& line);
  void change(std::size_t at);
  void mark();
  void retranslate();

  process::LibraryItem item_;
  QWidget* content_ = nullptr;
  QVBoxLayout* column_ = nullptr;
  std::vector<Row> rows_;
  std::vector<Group> groups_;
  QAction* swatch_ = nullptr; // Of the material's colour
};

} // namespace voluta::panels
