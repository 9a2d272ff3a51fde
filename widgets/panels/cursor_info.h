// The machine at the cursor of the time-line: the line of the program, the nozzle and the joints.
#pragma once

#include <Eigen/Core>
#include <QString>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

class QLabel;

namespace voluta::panels {

struct CursorFacts {
  QString line; // Of the program; empty: there is no program
  std::size_t lineNumber = 0;
  Eigen::Vector3d tipMm = Eigen::Vector3d::Zero();     // On the platform
  Eigen::Vector3d anglesDeg = Eigen::Vector3d::Zero(); // About x, y and z, from upright
  double tiltDeg = 0.0;                                // Of the nozzle, from upright
  double speedMmPerS = 0.0;                            // Of the nozzle along the part
  struct Joint {
    double value; // [deg]; [mm] if it slides
    bool slides;
  };
  std::vector<Joint> joints;
  double printedShare = 0.0; // Of the material
  double printedG = 0.0;     // 0: not known
};

class CursorInfo : public QWidget {
  Q_OBJECT

public:
  explicit CursorInfo(QWidget* parent = nullptr);

  // nullopt: there is no motion.
  void setFacts(const std::optional<CursorFacts>& facts);
  // As shown, by row: line, position, rotation, tilt, speed, joints, printed.
  QString shown(int row) const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  static constexpr int kRows = 7;
  std::optional<CursorFacts> facts_;
  std::array<QLabel*, kRows> names_{}, values_{};
};

} // namespace voluta::panels
