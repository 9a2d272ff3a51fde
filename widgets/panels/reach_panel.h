// Whether the head reaches the part at its position, a reach map, and a better position.
#pragma once

#include <QWidget>
#include <optional>

class QCheckBox;
class QLabel;
class QPushButton;

namespace voluta::panels {

// Shares in [0, 1] of the poses over the part.
struct ShownReach {
  double upright = 0.0, tilted = 0.0;
  double tiltDeg = 0.0; // maximum tilt
  bool onPlate = false; // the part is on the mapped plate
  bool better = false;  // another position has a better reach
  double betterUpright = 0.0, betterTilted = 0.0;
};

class ReachPanel : public QWidget {
  Q_OBJECT

public:
  explicit ReachPanel(QWidget* parent = nullptr);

  // None of these emits. nullopt: no part, or not known yet.
  void setReach(const std::optional<ShownReach>& reach);
  void setLooking(bool looking);
  bool isLooking() const { return looking_; }

signals:
  void mapToggled(bool shown);
  void moveRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void showState();

  std::optional<ShownReach> reach_;
  bool looking_ = false;
  QLabel* title_ = nullptr;
  QLabel* icon_ = nullptr;
  QLabel* state_ = nullptr;
  QCheckBox* map_ = nullptr;
  QPushButton* move_ = nullptr;
};

} // namespace voluta::panels
