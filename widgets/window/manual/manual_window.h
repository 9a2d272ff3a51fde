// The manual in the window: contents, search and pages.
#pragma once

#include <QDialog>
#include <QUrl>

class QLineEdit;
class QTextBrowser;
class QTreeWidget;

namespace voluta::window {

class ManualWindow : public QDialog {
  Q_OBJECT

public:
  explicit ManualWindow(QWidget* parent);

  void show(const QUrl& page);

protected:
  void changeEvent(QEvent* event) override;

private:
  void fill();
  void filter(const QString& words);
  void highlight();

  QLineEdit* search_;
  QTreeWidget* contents_;
  QTextBrowser* text_;
};

// Opens the manual at the page about what has the focus: in front of `window`, or of a dialog that
// blocks it. `pageId`: of the page of the window that is shown.
void openManual(QWidget& window, const QString& pageId);

// Opens the manual in dialogs that block the window and with it its keys.
class ManualKey : public QObject {
  Q_OBJECT

public:
  // Watches the application.
  explicit ManualKey(QWidget& window);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QWidget& window_;
};

} // namespace voluta::window
