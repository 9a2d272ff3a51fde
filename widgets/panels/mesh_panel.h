// State of the mesh: defects found, repairs made, remaining defects.
#pragma once

#include "base/text.h"

#include <Eigen/Core>
#include <QWidget>
#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QLabel;

namespace voluta::panels {

struct MeshSummary {
  std::string name; // file name without folder
  std::size_t triangles = 0;
  double volumeMm3 = 0.0; // of the placed part
  bool watertight = false;
  std::vector<base::Message> found, repaired, remains; // one sentence each
};

class MeshPanel : public QWidget {
  Q_OBJECT

public:
  explicit MeshPanel(QWidget* parent = nullptr);

  // nullopt: no part.
  void setSummary(std::optional<MeshSummary> summary);
  // Emits nothing.
  void setRepair(bool repair);

signals:
  void repairToggled(bool repair);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  std::optional<MeshSummary> summary_;
  QLabel* text_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* stateIcon_ = nullptr;
  QCheckBox* repair_ = nullptr;
};

} // namespace voluta::panels
