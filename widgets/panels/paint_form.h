// How the surface of a part is painted: with a brush, face by face, or within a rectangle.
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;

namespace voluta::forms {
class NumberBox;
}

namespace voluta::panels {

struct PaintChoices {
  enum class With {
    Brush,
    Faces,    // those that continue from the clicked one
    Rectangle // what is seen through it
  };
  With with = With::Brush;
  double radiusMm = 3.0;
  double angleDeg = 20.0;  // of the edges at which faces end
  bool growsLayers = true; // while the brush rests, of regions with layers of their own
};

class PaintForm : public QWidget {
  Q_OBJECT

public:
  explicit PaintForm(QWidget* parent = nullptr);

  const PaintChoices& choices() const { return choices_; }
  // Offers to grow the layers while the brush rests.
  void setHasLayers(bool has);

signals:
  void changed();

protected:
  void changeEvent(QEvent* event) override;

private:
  void showChoices();

  PaintChoices choices_;
  QComboBox* with_;
  QLabel *withLabel_, *sizeLabel_, *hint_;
  forms::NumberBox* size_;
  QCheckBox* grows_;
};

} // namespace voluta::panels
