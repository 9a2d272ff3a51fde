// Badge in the viewport saying that the view is for other settings than the present ones.
#pragma once

#include <QString>
#include <QWidget>

namespace voluta::window {

class PictureBadge : public QWidget {
  Q_OBJECT

public:
  // Stays at the centre of its parent's lower edge.
  explicit PictureBadge(QWidget* parent);

  // A few words; empty: no badge. `help` is its tool tip.
  void setText(const QString& text, const QString& help);
  const QString& text() const { return text_; }

  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void keepToItsPlace();

  QString text_;
};

} // namespace voluta::window
