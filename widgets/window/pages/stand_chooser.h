// The ways to stand of the part on show, found in the background and laid by a click.
#pragma once

#include "jobs/job_runner.h"
#include "panels/ways_list.h"
#include "window/pages/page.h"

#include <Eigen/Core>
#include <QObject>
#include <optional>
#include <string>
#include <vector>

namespace voluta::window {

class PartHandles;

class StandChooser : public QObject {
  Q_OBJECT

public:
  // All outlive this but the list, which is made here to be put somewhere.
  StandChooser(const Workspace& workspace, const PartHandles& handles, QObject* parent);

  panels::WaysList* list() { return list_; }

private:
  struct Found;

  void refresh();
  void look(const std::string& key);
  void take(Found found);
  void showNow();
  // Which of the ways has that direction of the file down; none: none.
  std::optional<std::size_t> wayDown(const Eigen::Vector3d& down) const;
  // What is down now, in the part's file.
  Eigen::Vector3d down() const;
  void lay(std::size_t way);

  const Workspace& work_;
  const PartHandles& handles_;
  panels::WaysList* list_;
  jobs::JobRunner runner_;
  std::string key_;                    // of the ways that were looked for last
  Eigen::Vector3d lookedFrom_;         // what was down then
  std::vector<Eigen::Vector3d> downs_; // of the ways on show
  bool laid_ = false;                  // by a click, and not drawn yet
};

} // namespace voluta::window
