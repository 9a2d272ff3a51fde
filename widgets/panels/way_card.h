// An orientation of the part: its picture with the figures below.
#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QString>
#include <array>
#include <cstddef>

namespace voluta::panels {

struct ShownOrientation {
  QImage picture; // at least twice the display resolution
  double contactMm2 = 0.0, overhangMm2 = 0.0, heightMm = 0.0;
  std::size_t missed = 0, voxels = 0;
  QString time; // "2 h 5 min"
};

class WayCard : public QAbstractButton {
  Q_OBJECT

public:
  static constexpr QSize kPicture{132, 88}; // maximum size on the screen

  explicit WayCard(QWidget* parent = nullptr);

  void setOrientation(const ShownOrientation& orientation);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void paintTick(QPainter& painter) const;

  ShownOrientation orientation_;
  std::array<QString, 3> lines_;
};

} // namespace voluta::panels
