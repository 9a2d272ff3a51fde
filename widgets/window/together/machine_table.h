// The machines of TogetherDialog as a table: job, cell and place of each.
#pragma once

#include <Eigen/Geometry>
#include <QString>
#include <QTableWidget>
#include <cstddef>

namespace voluta::window {

class MachineTable : public QTableWidget {
  Q_OBJECT

public:
  explicit MachineTable(QWidget* parent = nullptr);

  // The first machine stands at the origin; its numbers cannot be changed.
  void addMachine(const QString& job, const QString& cell, const Eigen::Isometry3d& place);
  void removeMachine(std::size_t machine);
  // Shows a place; placeChanged() is not emitted.
  void setPlace(std::size_t machine, const Eigen::Isometry3d& place);
  // The row that is selected, or the last one.
  std::size_t chosen() const;

signals:
  void placeChanged(std::size_t machine, const Eigen::Isometry3d& place);

private:
  Eigen::Isometry3d placeOf(int row) const;
  void number();
};

} // namespace voluta::window
