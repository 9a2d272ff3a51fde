// The message of the empty viewport, with buttons for opening a part.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace voluta::window {

class Welcome : public QWidget {
  Q_OBJECT

public:
  // Stays centred in its parent.
  explicit Welcome(QWidget* parent);

  // Shows a message instead of the invitation, without buttons; empty: the invitation again.
  void setMessage(const QString& message);
  bool hasMessage() const { return !message_.isEmpty(); }

signals:
  void openRequested();
  void sampleRequested();

protected:
  void paintEvent(QPaintEvent*) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void retranslate();
  void keepToTheMiddle();

  QString message_;
  QLabel *title_, *text_;
  QPushButton *open_, *sample_;
};

} // namespace voluta::window
