// Orientations of the shown part, computed in the background and applied by a click.
#pragma once

#include "jobs/job_runner.h"
#include "panels/ways_list.h"
#include "placement/ways_to_stand.h"
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
  // All must outlive this except the list, which is created here; the caller places it.
  StandChooser(const Workspace& workspace, const PartHandles& handles, QObject* parent);

  panels::WaysList* list() { return list_; }

private:
  struct Found;

  void refresh();
  void look(const std::string& key);
  void take(Found found);
  // Shows the orientations again if the choices change their times.
  void showTimes();
  void showNow();
  // Returns the orientation in which that direction of the file points down; none if there is none.
  std::optional<std::size_t> orientationWithDown(const Eigen::Vector3d& down) const;
  // Returns the direction that points down at present, in the part's file.
  Eigen::Vector3d down() const;
  void lay(std::size_t orientation);

  const Workspace& work_;
  const PartHandles& handles_;
  panels::WaysList* list_;
  jobs::JobRunner runner_;
  std::string key_;                    // of the orientations computed last
  Eigen::Vector3d lookedFrom_;         // the direction that pointed down then
  std::vector<Eigen::Vector3d> downs_; // of the shown orientations
  std::vector<placement::StandingOrientation> ways_;
  std::vector<panels::ShownOrientation> shown_;
  bool oriented_ = false; // by a click, and not drawn yet
};

} // namespace voluta::window
