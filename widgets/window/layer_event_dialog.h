// Asks for an event before a layer: a pause, a wait, an output, another tool or an own statement.
#pragma once

#include <QDialog>
#include <cstddef>

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

  // Below the fields; the dialog stays open.
  void showProblem(const base::Error& error);

signals:
  // A text of layerEvents behind its place, for example "wait 60".
  void chosen(const QString& event);

private:
  void build(std::size_t tools);
  void showFields();
  QString event();

  QFormLayout* form_;
  QComboBox *kind_, *format_;
  QLineEdit *text_, *statement_;
  forms::NumberBox* seconds_;
  QSpinBox *output_, *tool_;
  QCheckBox* on_;
  QLabel* problem_;
};

} // namespace voluta::window
