#include "window/together/machine_table.h"

#include "base/units.h"
#include "forms/value_boxes.h"
#include "pipeline/station_plan.h"
#include "scene/machines_scene.h"

#include <QHeaderView>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

namespace voluta::window {

namespace {
enum Column { Job, Cell, X, Y, Z, Rotation, Columns };
constexpr double kMaxMm = 20000.0;
constexpr int kRows = 4;

// x, y, z [mm] and the rotation [degrees], as the columns.
std::array<double, 4> valuesOf(const Eigen::Isometry3d& place) {
  return {place.translation().x(), place.translation().y(), place.translation().z(),
          pipeline::machineRotationDeg(place)};
}
} // namespace

MachineTable::MachineTable(QWidget* parent) : QTableWidget(0, Columns, parent) {
  setObjectName("machineTable");
  setAccessibleName(tr("Machines"));
  setHorizontalHeaderLabels({tr("Job"), tr("Cell"), QStringLiteral("X"), QStringLiteral("Y"),
                             QStringLiteral("Z"), tr("Turn")});
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  horizontalHeader()->setSectionResizeMode(Job, QHeaderView::Stretch);
  for (int column = Cell; column < Columns; ++column)
    horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  setMinimumHeight((kRows + 1) * (fontMetrics().height() + 14));
}

void MachineTable::addMachine(const QString& job, const QString& cell,
                              const Eigen::Isometry3d& place) {
  const int row = rowCount();
  insertRow(row);
  setItem(row, Job, new QTableWidgetItem(job));
  item(row, Job)->setToolTip(job);
  setItem(row, Cell, new QTableWidgetItem(cell));
  const std::array<double, 4> values = valuesOf(place);
  for (int column = X; column < Columns; ++column) {
    auto* box = new forms::NumberBox(this);
    const bool isAngle = column == Rotation;
    box->setRange(isAngle ? -360.0 : -kMaxMm, isAngle ? 360.0 : kMaxMm);
    box->setDecimals(1);
    box->setSingleStep(isAngle ? 15.0 : 10.0);
    box->setUnit(isAngle ? QStringLiteral("deg") : QStringLiteral("mm"));
    box->setValue(values[static_cast<std::size_t>(column - X)]);
    box->setFrame(false);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons); // all columns fit beside the view
    box->setEnabled(row > 0);
    setCellWidget(row, column, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, box, column] {
      for (int changed = 0; changed < rowCount(); ++changed)
        if (cellWidget(changed, column) == box)
          emit placeChanged(static_cast<std::size_t>(changed), placeOf(changed));
    });
  }
  number();
  selectRow(row);
}

void MachineTable::setPlace(std::size_t machine, const Eigen::Isometry3d& place) {
  const std::array<double, 4> values = valuesOf(place);
  for (int column = X; column < Columns; ++column) {
    auto* box = static_cast<QDoubleSpinBox*>(cellWidget(static_cast<int>(machine), column));
    const QSignalBlocker quiet(box);
    box->setValue(values[static_cast<std::size_t>(column - X)]);
  }
}

void MachineTable::removeMachine(std::size_t machine) {
  removeRow(static_cast<int>(machine));
  number();
}

std::size_t MachineTable::chosen() const {
  return static_cast<std::size_t>(std::max(0, currentRow() >= 0 ? currentRow() : rowCount() - 1));
}

Eigen::Isometry3d MachineTable::placeOf(int row) const {
  const auto value = [&](int column) {
    return static_cast<const QDoubleSpinBox*>(cellWidget(row, column))->value();
  };
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() = Eigen::Vector3d(value(X), value(Y), value(Z));
  place.rotate(
      Eigen::AngleAxisd(base::degreesToRadians(value(Rotation)), Eigen::Vector3d::UnitZ()));
  return place;
}

// Each number has the colour of its machine in the view.
void MachineTable::number() {
  for (int row = 0; row < rowCount(); ++row) {
    const scene::Colour c = scene::MachinesScene::colourOf(static_cast<std::size_t>(row));
    auto* header = new QTableWidgetItem(QString::number(row + 1));
    header->setForeground(QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                                           static_cast<float>(c[2])));
    setVerticalHeaderItem(row, header);
  }
}

} // namespace voluta::window
