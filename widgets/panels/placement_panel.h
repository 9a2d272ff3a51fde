// Placement of the part in numbers: position, rotation, scale.
#pragma once

#include "geometry/placement.h"

#include <Eigen/Geometry>
#include <QWidget>
#include <array>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace voluta::forms {
class NumberBox;
}

namespace voluta::panels {

class PlacementPanel : public QWidget {
  Q_OBJECT

public:
  explicit PlacementPanel(QWidget* parent = nullptr);

  // None of these emits.
  void setPlacement(const geometry::Placement& placement);
  // `text` as in the choices: a number or "fit"; `factor` is the resulting scale (0: not known
  // yet).
  void setScale(const QString& text, double factor);
  // Size of the placed part along the axes of the work frame, mm.
  // With an edge typed, the part is scaled as a whole.
  void setSizeMm(const Eigen::Vector3d& sizeMm);
  // Whether z is limited to 0 and above, as on a plate.
  void setOnPlate(bool onPlate);
  // Whether a click in the viewport is awaited.
  void setLayOnFace(bool waiting);

  const geometry::Placement& placement() const { return placement_; }

signals:
  // `editName` names the edit for undo, in the user's language.
  void placementChanged(const voluta::geometry::Placement& placement, const QString& editName);
  void scaleChanged(const QString& text);
  void layOnFaceToggled(bool waiting);

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  void buildAxis(int axis, QGridLayout& grid);
  void buildScale(QGridLayout& grid);
  void buildButtons(QGridLayout& grid);
  void listenToButtons();
  void showPlacement();
  void showScale();
  void showSize();
  void buildSize(QGridLayout& grid);
  void resizeTo(int axis, double shown);
  double unitMm() const;
  void moved(int axis, double mm);
  void turned(int axis, double degrees);
  void rotateBy(int axis, double degrees);
  void change(const geometry::Placement& placement, const QString& editName);
  void retranslate();

  geometry::Placement placement_;
  Eigen::Vector3d angles_ = Eigen::Vector3d::Zero(); // radians, as shown
  Eigen::Vector3d sizeMm_ = Eigen::Vector3d::Zero();
  QString scaleText_ = QStringLiteral("1");
  double factor_ = 1.0;

  std::array<forms::NumberBox*, 3> move_{}, rotation_{}, size_{};
  std::array<QToolButton*, 3> less_{}, more_{};
  std::array<QLabel*, 3> axis_{};
  QLabel* moveLabel_ = nullptr;
  QLabel* rotationLabel_ = nullptr;
  QLabel* percentLabel_ = nullptr;
  QLabel* sizeLabel_ = nullptr;
  QComboBox* unit_ = nullptr;
  forms::NumberBox* percent_ = nullptr;
  forms::NumberBox* scale_ = nullptr;
  QPushButton* fit_ = nullptr;
  QPushButton* drop_ = nullptr;
  QPushButton* layOnFace_ = nullptr;
  QPushButton* centre_ = nullptr;
  QPushButton* reset_ = nullptr;
};

} // namespace voluta::panels
