// Moves the arm of the simulation by hand: by its joints, or by the nozzle on the platform. Values
// in, wishes out.
#pragma once

#include "forms/icons.h"

#include <QWidget>
#include <array>
#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace voluta::forms {
class NumberBox;
}

namespace voluta::panels {

struct JogJoint {
  QString name;
  double minimum = 0.0, maximum = 0.0; // [deg]; [mm] if it slides
  bool slides = false;
  bool operator==(const JogJoint&) const = default;
};

struct JogState {
  std::vector<double> joints;          // as JogJoint
  std::array<double, 6> coordinates{}; // X, Y, Z [mm], A, B, C [deg]
  forms::Icon sign = forms::Icon::Good;
  QString message;
};

class JogPanel : public QWidget {
  Q_OBJECT

public:
  explicit JogPanel(QWidget* parent = nullptr);

  void setJoints(const std::vector<JogJoint>& joints);
  // Precondition: as many joints as set.
  void setState(const JogState& state);

signals:
  void jointWished(int joint, double value);           // [deg] or [mm]
  void coordinateWished(int coordinate, double value); // [mm] or [deg]
  void stepWished(int coordinate, double amount);      // [mm] or [deg]
  void endWished();

protected:
  void changeEvent(QEvent* event) override;

private:
  struct JointRow {
    QLabel* name;
    QSlider* slider;
    forms::NumberBox* box;
  };
  struct CoordinateRow {
    QLabel* name;
    QToolButton *less, *more;
    forms::NumberBox* box;
  };
  JointRow addJoint(int joint, const JogJoint& from);
  CoordinateRow addCoordinate(int coordinate);
  void retranslate();

  QGridLayout *jointGrid_, *nozzleGrid_;
  std::vector<JogJoint> given_;
  std::vector<JointRow> joints_;
  std::array<CoordinateRow, 6> coordinates_{};
  forms::NumberBox *stepMm_, *stepDeg_;
  QLabel *jointHeading_, *nozzleHeading_, *step_, *sign_, *message_;
  QPushButton* end_;
};

} // namespace voluta::panels
