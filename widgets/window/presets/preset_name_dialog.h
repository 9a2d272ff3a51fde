// Asks for the name of a preset, and states why a typed one is not possible.
#pragma once

#include <QDialog>
#include <string>

class QLabel;
class QLineEdit;
class QPushButton;

namespace voluta::window {

class PresetNameDialog : public QDialog {
  Q_OBJECT

public:
  // `id`: of the preset that is renamed; empty: a new one.
  PresetNameDialog(const QString& title, const QString& name, const std::string& id,
                   QWidget* parent);

  QString name() const;

private:
  void check();

  std::string id_;
  QLineEdit* name_;
  QLabel* problem_;
  QPushButton* accept_;
};

} // namespace voluta::window
