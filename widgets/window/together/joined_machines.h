// The machines of TogetherDialog as the view draws them: at their homes before a plan, at a moment
// of the common time after it.
#pragma once

#include "document/joining.h"
#include "jobs/job_runner.h"
#include "scene/machines_scene.h"
#include "timeline/clock.h"
#include "timeline/machine_lanes.h"
#include "timeline/waiting_clock.h"

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

namespace voluta::window {

class JoinedMachines : public QObject {
  Q_OBJECT

public:
  explicit JoinedMachines(QObject* parent = nullptr);
  ~JoinedMachines() override;

  const std::vector<project::Machine>& all() const { return machines_; }
  // Per machine; a drawing without a cell is not made yet.
  const std::vector<scene::MachineDrawing>& drawings() const { return drawings_; }
  // Adds a machine with a motion; drawn() follows once it is drawn. The first stands at the origin.
  void add(project::Machine machine);
  void remove(std::size_t machine);
  void place(std::size_t machine, const Eigen::Isometry3d& shared_T_world);
  // Moves every machine but the first away from it, level, by that distance [mm].
  void moveApart(double mm);
  // Returns the place at which the plate of another machine with this job lies beside the first
  // one's, turned by 180 degrees. Precondition: there is a machine.
  Eigen::Isometry3d placeOpposite() const;

  // The rules of the station that station() returns, but the clearance.
  void setRules(const project::StationRules& rules) { rules_ = rules; }
  project::Station station(double clearanceMm) const;
  // The result of the machines as they are; null: none. Precondition: one plan per machine.
  void setResult(document::JoinedResult result);
  const document::JoinedResult& result() const { return result_; }

  // Of the common time; 0 without a replay.
  double endS() const;
  std::vector<scene::MachineMoment> momentsAt(double timeS) const;
  std::vector<timeline::Lane> lanes() const;

signals:
  void changed(); // machines or places
  void drawn();   // all machines have a drawing

private:
  void drawNext();
  timeline::WaitingClock waitingClockOf(std::size_t machine) const;

  std::vector<project::Machine> machines_;
  project::StationRules rules_;
  std::vector<scene::MachineDrawing> drawings_;
  document::JoinedResult result_;
  std::vector<timeline::Clock> clocks_; // with a replay: per machine
  std::vector<timeline::WaitingClock> waiting_;
  jobs::JobRunner drawer_;
};

} // namespace voluta::window
