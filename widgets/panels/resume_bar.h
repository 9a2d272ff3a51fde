// The place where a print would be resumed, and the button for it.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace voluta::panels {

class ResumeBar : public QWidget {
  Q_OBJECT

public:
  explicit ResumeBar(QWidget* parent = nullptr);

  // The place in a few words; empty: not possible here.
  void setPlace(const QString& place);

signals:
  void asked();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  QLabel* place_;
  QPushButton* button_;
};

} // namespace voluta::panels
