// A form for a frame: position, rotation, and the edge lengths of a box in it.
#pragma once

#include <Eigen/Geometry>
#include <QWidget>
#include <array>
#include <optional>

class QLabel;

namespace voluta::forms {
class NumberBox;
}

namespace voluta::panels {

class FrameForm : public QWidget {
  Q_OBJECT

public:
  explicit FrameForm(QWidget* parent = nullptr);

  // None of these emits. Rotations about the fixed X, then Y, then Z, as in cell files.
  void setFrame(const Eigen::Isometry3d& frame);
  // Whether the rotation is shown: a point has none.
  void setRotationVisible(bool visible);
  // mm; nullopt: the body is no box, and the numbers are hidden.
  void setSizeMm(const std::optional<Eigen::Vector3d>& sizeMm);

signals:
  void frameChanged(const Eigen::Isometry3d& frame);
  void sizeChanged(const Eigen::Vector3d& sizeMm);

protected:
  void changeEvent(QEvent* event) override;

private:
  using Boxes = std::array<forms::NumberBox*, 3>;
  Boxes addColumn(int column, const QString& name, const QString& unit, double minimum,
                  double maximum);
  void changed();
  void retranslate();

  Eigen::Vector3d angles_ = Eigen::Vector3d::Zero(); // rad, as shown
  Boxes place_{}, rotation_{}, size_{};
  QLabel *placeLabel_ = nullptr, *rotationLabel_ = nullptr, *sizeLabel_ = nullptr;
};

} // namespace voluta::panels
