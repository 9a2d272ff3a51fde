// The log in a box of its own: what was opened, planned and found, the newest lines in sight. It
// needs no other program to be read.
#pragma once

#include <QDialog>
#include <QString>

namespace voluta::window {

class LogDialog : public QDialog {
  Q_OBJECT

public:
  LogDialog(const QString& file, QWidget* parent);
};

} // namespace voluta::window
