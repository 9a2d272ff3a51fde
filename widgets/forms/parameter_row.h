// One parameter in a form: label, editor for its type, reset.
#pragma once

#include "base/parameters.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace voluta::forms {

class ParameterRow : public QWidget {
  Q_OBJECT

public:
  ParameterRow(const base::ParameterSpec& spec, QWidget* parent);

  const base::ParameterSpec& spec() const { return spec_; }
  // Keeps the value; emits nothing.
  void setDefault(const base::ParameterValue& value);
  QWidget* editor() const { return editor_; }
  QString key() const { return QString::fromStdString(spec_.key); }

  // Shows a value without a signal. Precondition: of the parameter's type.
  void setValue(const base::ParameterValue& value);
  base::ParameterValue value() const { return value_; }
  bool isChanged() const;

  // Sets the line below the row that explains why the value is invalid; empty: it is valid.
  void setProblem(const QString& problem);
  bool hasProblem() const;

  // Returns whether every word occurs in label, key, group or help, ignoring case.
  bool matches(const QStringList& words) const;
  // Highlights the words in the label.
  void highlight(const QStringList& words);
  void retranslate();

signals:
  void committed(const QString& key, const QString& text);
  void resetRequested(const QString& key);

private:
  void buildEditor();
  void chooseFile();
  void commit(const base::ParameterValue& value);
  void showValue();
  void showLabel();

  base::ParameterSpec spec_;
  base::ParameterValue value_;
  QStringList words_;
  QLabel* label_ = nullptr;
  QWidget* editor_ = nullptr;
  QToolButton* browse_ = nullptr;
  QToolButton* reset_ = nullptr;
  QWidget* problem_ = nullptr;
  QLabel* problemIcon_ = nullptr;
  QLabel* problemText_ = nullptr;
};

} // namespace voluta::forms
