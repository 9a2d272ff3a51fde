#include "window/together/joined_machines.h"

#include "forms/duration_text.h"
#include "pipeline/road.h"
#include "robot/shape/arm_look.h"
#include "window/background.h"

#include <algorithm>
#include <cmath>

namespace voluta::window {

JoinedMachines::JoinedMachines(QObject* parent) : QObject(parent) {}
JoinedMachines::~JoinedMachines() = default;

void JoinedMachines::add(project::Machine machine) {
  drawings_.push_back({nullptr, nullptr, machine.shared_T_world});
  machines_.push_back(std::move(machine));
  setResult(nullptr);
  drawNext();
}

void JoinedMachines::remove(std::size_t machine) {
  machines_.erase(machines_.begin() + static_cast<std::ptrdiff_t>(machine));
  drawings_.erase(drawings_.begin() + static_cast<std::ptrdiff_t>(machine));
  setResult(nullptr);
  emit changed();
}

void JoinedMachines::place(std::size_t machine, const Eigen::Isometry3d& shared_T_world) {
  machines_[machine].shared_T_world = shared_T_world;
  drawings_[machine].shared_T_world = shared_T_world;
  setResult(nullptr);
  emit changed();
}

void JoinedMachines::moveApart(double mm) {
  for (std::size_t k = 1; k < machines_.size(); ++k) {
    Eigen::Isometry3d place = machines_[k].shared_T_world;
    Eigen::Vector3d away = place.translation() - machines_.front().shared_T_world.translation();
    away.z() = 0.0;
    place.translation() += mm * (away.norm() > 1.0 ? away.normalized() : Eigen::Vector3d::UnitX());
    machines_[k].shared_T_world = drawings_[k].shared_T_world = place;
  }
  setResult(nullptr);
  emit changed();
}

// Draws one machine after another; machines with the same job share their drawings.
void JoinedMachines::drawNext() {
  const auto next =
      std::ranges::find_if(drawings_, [](const auto& drawing) { return !drawing.cell; });
  if (next == drawings_.end()) {
    emit drawn();
    return;
  }
  const project::Job& job = machines_[static_cast<std::size_t>(next - drawings_.begin())].job;
  inBackground(
      drawer_,
      [job] {
        const pipeline::PlanResult plan = pipeline::resultOf(job);
        return std::pair(scene::drawCell(*plan.cell, robot::lookOf(plan.cell->robot())),
                         scene::drawPaths(*job.toolPlan, job.trajectory.get()));
      },
      [this, motion = job.trajectory](auto&& drawn) {
        for (std::size_t k = 0; k < machines_.size(); ++k)
          if (machines_[k].job.trajectory == motion) {
            drawings_[k].cell = drawn.first;
            drawings_[k].paths = drawn.second;
          }
        drawNext();
      });
}

Eigen::Isometry3d JoinedMachines::placeOpposite() const {
  const pipeline::PlanResult plan = pipeline::resultOf(machines_.front().job);
  std::vector<Eigen::Isometry3d> frames;
  plan.cell->framePoses(plan.cell->home(), frames);
  const Eigen::Isometry3d base_T_world = plan.cell->base_T_world(plan.cell->home());
  const Eigen::Isometry3d world_T_work =
      base_T_world.inverse() * frames[static_cast<std::size_t>(plan.cell->workFrame())];
  const Eigen::Vector2d centre = world_T_work.translation().head<2>();
  const double length = centre.norm();
  const Eigen::Vector2d away =
      length > 1.0 ? Eigen::Vector2d(centre / length) : Eigen::Vector2d::UnitX();
  double border = length; // of the plate, away from the base
  for (const Eigen::Vector2d& corner : project::platformOf(machines_.front().job).polygon) {
    const Eigen::Vector3d inWorld = world_T_work * Eigen::Vector3d(corner.x(), corner.y(), 0.0);
    border = std::max(border, inWorld.head<2>().dot(away));
  }
  const Eigen::Vector2d place = 2.0 * border * away;
  Eigen::Isometry3d opposite = Eigen::Isometry3d::Identity();
  opposite.translation() = Eigen::Vector3d(std::round(place.x()), std::round(place.y()), 0.0);
  opposite.linear() = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
  return opposite;
}

project::Station JoinedMachines::station(double clearanceMm) const {
  project::Station station{machines_, rules_};
  station.rules.clearanceMm = clearanceMm;
  return station;
}

void JoinedMachines::setResult(document::JoinedResult result) {
  result_ = std::move(result);
  clocks_.clear();
  waiting_.clear();
  if (!result_ || !result_->replay)
    return;
  for (std::size_t k = 0; k < machines_.size(); ++k) {
    const project::Job& job = result_->plans[k].job;
    clocks_.emplace_back(job.trajectory, job.toolPlan);
    waiting_.push_back(waitingClockOf(k));
  }
}

timeline::WaitingClock JoinedMachines::waitingClockOf(std::size_t machine) const {
  const replay::MachineClock& common = result_->replay->clock.machines[machine];
  const plan::Trajectory& motion = *result_->plans[machine].job.trajectory;
  const timeline::Clock& own = clocks_[machine];
  std::vector<timeline::OwnWait> waits;
  for (const plan::TrajectoryEvent& event : motion.events)
    if (event.kind == plan::EventKind::Mark && waits.size() < common.marks.size()) {
      const replay::PassedMark& mark = common.marks[waits.size()];
      waits.push_back({own.timeOfPoint(event.point - 1), mark.fromS, mark.toS});
    }
  return {std::move(waits), own.durationS(), common.totalS};
}

double JoinedMachines::endS() const {
  return result_ && result_->replay ? result_->replay->makespanS : 0.0;
}

std::vector<scene::MachineMoment> JoinedMachines::momentsAt(double timeS) const {
  std::vector<scene::MachineMoment> moments;
  for (std::size_t k = 0; k < machines_.size(); ++k) {
    if (clocks_.empty()) {
      moments.push_back({{}, machines_[k].job.toolPlan->waypointCount()});
      continue;
    }
    const double ownS = waiting_[k].ownTimeS(timeS);
    moments.push_back({clocks_[k].jointsAt(ownS), clocks_[k].printedWaypoints(ownS)});
  }
  return moments;
}

std::vector<timeline::Lane> JoinedMachines::lanes() const {
  std::vector<timeline::Lane> lanes;
  for (std::size_t k = 0; k < waiting_.size(); ++k) {
    const scene::Colour c = scene::MachinesScene::colourOf(k);
    timeline::Lane& lane = lanes.emplace_back();
    lane.name = tr("Machine %1").arg(k + 1);
    lane.colour = QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                                   static_cast<float>(c[2]));
    lane.endS = waiting_[k].endS();
    for (const replay::PassedMark& mark : result_->replay->clock.machines[k].marks)
      lane.waits.push_back({mark.fromS, mark.toS,
                            tr("Waits %1 for machine %2")
                                .arg(forms::durationText(mark.toS - mark.fromS))
                                .arg(mark.other + 1)});
  }
  return lanes;
}

} // namespace voluta::window
