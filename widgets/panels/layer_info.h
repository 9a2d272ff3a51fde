// Measures of one layer: the one shown, or the one under the cursor.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

class QLabel;

namespace voluta::panels {

struct LayerMeasures {
  int index = 0;  // 0 is on the platform
  int layers = 0; // number of layers
  std::size_t patches = 0, waypoints = 0;
  double areaMm2 = 0.0;
  double thicknessMinMm = 0.0, thicknessMeanMm = 0.0, thicknessMaxMm = 0.0;
  double lengthMm = 0.0; // of its beads
  double timeS = 0.0;    // duration; 0: motion is not planned yet
};

class LayerInfo : public QWidget {
  Q_OBJECT

public:
  explicit LayerInfo(QWidget* parent = nullptr);

  // nullopt: no layer.
  void setMeasures(const std::optional<LayerMeasures>& measures);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  static constexpr int kRows = 7;
  std::optional<LayerMeasures> measures_;
  std::array<QLabel*, kRows> names_{}, values_{};
};

} // namespace voluta::panels
