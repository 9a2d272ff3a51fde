// From where a print would be taken up again, and the button that does.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace voluta::panels {

class ResumeBar : public QWidget {
  Q_OBJECT

public:
  explicit ResumeBar(QWidget* parent = nullptr);

  // Where, in a few words; empty: from nowhere here.
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
