// A number typed for the handles: an axis (x, y, z), digits, Enter, as in "x 10 Enter". Move takes
// mm, Rotate degrees, Scale percent of the present size.
#pragma once

#include "viewer/gizmo.h"

#include <QString>
#include <optional>

class QKeyEvent;

namespace voluta::viewer {

class TypedChange {
  Q_DECLARE_TR_FUNCTIONS(TypedChange)

public:
  enum class Step { Edited, Done, Cancelled };

  bool isActive() const { return active_; }
  // Returns whether the key is one of the number's. A number begins with its axis, or with a digit
  // while a handle is dragged or a part is scaled.
  bool takes(const QKeyEvent& key, Tool tool, bool dragging) const;
  // `axis`: of the handle being dragged.
  void begin(std::optional<int> axis);
  // Precondition: takes(key), and begin() was called.
  Step press(const QKeyEvent& key, Tool tool);
  // The effect of the present number; without one, none. `axes`: unit vectors in columns.
  GizmoChange change(Tool tool, const Eigen::Matrix3d& axes) const;

private:
  std::optional<double> number() const;

  bool active_ = false;
  std::optional<int> axis_;
  QString digits_;
};

} // namespace voluta::viewer
