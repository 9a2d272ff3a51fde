// The settings of a cut: plane, halves to keep, and the joint between them.
#pragma once

#include "planar/parting/part_cut.h"

#include <Eigen/Core>
#include <QWidget>
#include <array>
#include <functional>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace voluta::forms {
class NumberBox;
}

namespace voluta::panels {

struct CutChoices {
  enum class Keep { Both, Lower, Upper };
  int axis = 2;            // perpendicular to the plane that is not tilted
  double positionMm = 0.0; // of the plane's pivot along the axis, from the part's lowest point
  std::array<double, 2> tiltDeg{}; // about the next two axes
  Keep keep = Keep::Both;
  planar::Joint joint;
  bool laysFlat = false;   // each half on its cut face
  bool showsApart = false; // in the view
};

// Returns the normal of the plane, and the tilts of a normal from an axis.
Eigen::Vector3d cutNormal(const CutChoices& choices);
std::array<double, 2> cutTiltDeg(const Eigen::Vector3d& normal, int axis);

class CutPanel : public QWidget {
  Q_OBJECT

public:
  explicit CutPanel(QWidget* parent = nullptr);

  // None of these emits.
  void setPart(const QString& name, const Eigen::Vector3d& sizeMm);
  void setChoices(const CutChoices& choices);
  void setPickingFace(bool on);
  // A line below the settings; `canCut`: whether Cut is enabled.
  void setState(const QString& text, bool isProblem, bool canCut);
  const CutChoices& choices() const { return choices_; }

signals:
  void changed();
  // Another axis: the plane returns to the part's middle.
  void axisChosen();
  void facePicking(bool on);
  void cutRequested();
  void closeRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  void buildPlane(QGridLayout& grid);
  void buildJoint(QGridLayout& grid);
  void buildButtons(QGridLayout& grid);
  QLabel* addRow(QGridLayout& grid, QWidget* field);
  forms::NumberBox* number(const char* name, const char* unit, double low, double high,
                           std::function<void(double)> takes);
  void showChoices();
  void retranslate();

  CutChoices choices_;
  QString name_;
  Eigen::Vector3d sizeMm_ = Eigen::Vector3d::Ones();
  QLabel *title_, *axisLabel_, *positionLabel_, *keepLabel_, *jointLabel_, *sizeLabel_,
      *depthLabel_, *clearanceLabel_, *countLabel_, *directionLabel_, *icon_, *state_;
  std::array<QLabel*, 2> tiltLabel_{};
  std::array<forms::NumberBox*, 2> tilt_{};
  forms::NumberBox *position_, *size_, *depth_, *clearance_, *direction_;
  QComboBox *axis_, *keep_, *joint_;
  QSpinBox* count_;
  QCheckBox *layFlat_, *apart_;
  QPushButton *face_, *cut_, *close_;
};

} // namespace voluta::panels
