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

struct JoinedMachine {
  QString name; // of the job
  std::shared_ptr<const project::Job> job;
  scene::MachineDrawing drawing; // cell null: not drawn yet
};

class JoinedMachines : public QObject {
  Q_OBJECT

public:
  explicit JoinedMachines(QObject* parent = nullptr);
  ~JoinedMachines() override;

  const std::vector<JoinedMachine>& all() const { return machines_; }
  // Adds a machine; drawn() follows once it is drawn. The first stands at the origin; `shared`
  // places the others.
  void add(const QString& name, std::shared_ptr<const project::Job> job,
           const Eigen::Isometry3d& shared_T_world);
  void remove(std::size_t machine);
  void place(std::size_t machine, const Eigen::Isometry3d& shared_T_world);
  // Returns the place at which the plate of another machine with this job lies beside the first
  // one's, turned by 180 degrees. Precondition: there is a machine.
  Eigen::Isometry3d placeOpposite() const;

  pipeline::TogetherRequest request(double clearanceMm) const;
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

  std::vector<JoinedMachine> machines_;
  document::JoinedResult result_;
  std::vector<timeline::Clock> clocks_; // with a replay: per machine
  std::vector<timeline::WaitingClock> waiting_;
  jobs::JobRunner drawer_;
};

} // namespace voluta::window
