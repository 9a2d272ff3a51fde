// The bodies of a cell that is edited, each below what it stands on; one of them is chosen.
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

  // What is chosen stays so where it is still there. Does not emit currentItemChanged.
  void setDraft(const robot::CellDraft& draft);
  std::optional<robot::DraftBody> chosen() const;
  void choose(const robot::DraftBody& body);

  static QString nameOf(const robot::DraftBody& body);
  // What its pose is told in: "in the flange".
  static QString parentOf(const robot::DraftBody& body, const robot::CellDraft& draft);

private:
  std::vector<robot::DraftBody> bodies_;
};

// The frame that a body's pose is told in, with the cell at rest.
Eigen::Isometry3d base_T_parent(const robot::DraftBody& body, const robot::Cell& cell);

} // namespace voluta::window
