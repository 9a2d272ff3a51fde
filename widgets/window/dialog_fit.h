// Keeps every dialog of the program on the screen: one that needs more room than there is scrolls,
// with its buttons below. Remembers the sizes that users give to dialogs.
#pragma once

#include <QObject>

class QDialog;

namespace voluta::window {

class DialogFit : public QObject {
  Q_OBJECT

public:
  // Watches the dialogs of the application. Those of Qt (files, messages) fit by themselves.
  explicit DialogFit(QObject* parent);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  static void fit(QDialog& dialog);
  static void letScroll(QDialog& dialog);
};

} // namespace voluta::window
