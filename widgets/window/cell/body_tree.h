// Tree of the bodies of an edited cell, each below its parent; one of them is selected.
#pragma once

#include "robot/cell_draft.h"

#include <QString>
#include <QTreeWidget>
#include <optional>

namespace voluta::window {

class BodyTree : public QTreeWidget {
  Q_OBJECT

public:
  explicit BodyTree(QWidget* parent = nullptr);

  // Keeps the selection if that body still exists. Does not emit currentItemChanged.
  void setDraft(const robot::CellDraft& draft);
  std::optional<robot::DraftBody> chosen() const;
  void choose(const robot::DraftBody& body);

  static QString nameOf(const robot::DraftBody& body);
  // Returns the parent of its pose as text: "in the flange".
  static QString parentOf(const robot::DraftBody& body, const robot::CellDraft& draft);

private:
  std::vector<robot::DraftBody> bodies_;
};

// Returns the frame in which a body's pose is given, with the cell at home.
Eigen::Isometry3d base_T_parent(const robot::DraftBody& body, const robot::Cell& cell);

} // namespace voluta::window
