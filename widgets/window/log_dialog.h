// Shows the log in the program itself: files opened, plans and findings, scrolled to the newest
// lines.
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
