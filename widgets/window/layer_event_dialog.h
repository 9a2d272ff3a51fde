// Asks for an event before a layer: a pause, a change of filament, a wait, an output, a photo,
// another tool or an own statement.
#pragma once

#include <QDialog>
#include <QStringList>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace voluta::base {
class Error;
}
namespace voluta::forms {
class NumberBox;
}

namespace voluta::window {

class LayerEventDialog : public QDialog {
  Q_OBJECT

public:
  // `layer`: shown, from 1. `tools`: of the job.
  LayerEventDialog(int layer, std::size_t tools, QWidget* parent);

  // Returns the problem of an event, in the form of `chosen`; nullopt: none.
  using Check = std::function<std::optional<base::Error>(const QString& event)>;
  // Checks whatever is typed from now on.
  void setCheck(Check check);
  // Below the fields; the dialog stays open.
  void showProblem(const base::Error& error);

signals:
  // A text of layerEvents behind its place, for example "wait 60".
  void chosen(const QString& event);

private:
  // A row of the form: its box, the kinds that have it, and its part of the event's text.
  struct Field {
    QWidget* box;
    QStringList kinds;
    std::function<QString()> text;
  };

  void build(std::size_t tools);
  void addField(const QString& label, const Field& field);
  void showFields();
  void check();
  QString event() const;
  bool isEmpty() const;

  QFormLayout* form_;
  QComboBox *kind_, *format_;
  QLineEdit *text_, *statement_;
  forms::NumberBox *seconds_, *pulse_;
  QSpinBox *output_, *tool_;
  QCheckBox* on_;
  QLabel* problem_;
  std::vector<Field> fields_;
  Check check_;
};

} // namespace voluta::window
