#include "window/together/together_dialog.h"

#include "forms/duration_text.h"
#include "forms/icons.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "pipeline/station_findings.h"
#include "plan/marks.h"
#include "timeline/machine_lanes.h"
#include "timeline/player.h"
#include "timeline/timeline_icons.h"
#include "viewer/machines_view.h"
#include "window/picture_area.h"
#include "window/together/machine_table.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace voluta::window {

namespace {
constexpr int kWidth = 1180, kHeight = 720, kSide = 460, kRows = 5;
constexpr int kApartMm = 50;
constexpr double kShownWaitS = 1.0; // shorter waits are not listed
enum Role { TimeRole = Qt::UserRole, PlaceRole };

QString number(double value, int decimals = 0) {
  return QLocale().toString(value, 'f', decimals);
}
QString placeText(const Eigen::Vector3d& place) {
  const auto whole = [](double mm) { return number(std::round(mm) + 0.0); }; // no -0
  return QStringLiteral("(%1, %2, %3)").arg(whole(place.x()), whole(place.y()), whole(place.z()));
}
} // namespace

TogetherDialog::TogetherDialog(const project::Station& station, QWidget* parent)
    : QDialog(parent), machines_(new JoinedMachines(this)),
      view_(new viewer::MachinesView(sceneTheme(palette()), this)),
      player_(new timeline::Player(this)) {
  setObjectName("togetherDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Print together with other machines"));
  resize(kWidth, kHeight);
  auto* picture = new QVBoxLayout;
  picture->addWidget(view_, 1);
  picture->addWidget(timeline_ = buildTimeline());
  auto* row = new QHBoxLayout(this);
  row->addWidget(buildSide());
  row->addLayout(picture, 1);
  listen();
  takeMachines(station);
}

TogetherDialog::~TogetherDialog() = default;

QWidget* TogetherDialog::buildSide() {
  auto* side = new QWidget(this);
  side->setFixedWidth(kSide);
  table_ = new MachineTable(side);
  const auto button = [&](const QString& text, const char* id) {
    auto* made = new QPushButton(text, side);
    made->setObjectName(QLatin1String(id));
    made->setAutoDefault(false);
    return made;
  };
  addFile_ = button(tr("Add project…"), "togetherAddFile");
  addAgain_ = button(tr("Add this job again"), "togetherAddAgain");
  remove_ = button(tr("Remove"), "togetherRemove");
  find_ = button(tr("Schedule"), "togetherFind");
  find_->setDefault(true);
  cancel_ = button(tr("Cancel"), "togetherCancel");
  save_ = button(tr("Save programs…"), "togetherSave");
  apart_ = button(tr("Move %1 mm further apart").arg(kApartMm), "togetherApart");
  clearance_ = new forms::NumberBox(side);
  clearance_->setObjectName("togetherClearance");
  clearance_->setRange(0.0, 500.0);
  static_cast<forms::NumberBox*>(clearance_)->setUnit(QStringLiteral("mm"));
  auto* clearanceText = new QLabel(tr("Minimum clearance between arms"), side);
  clearanceText->setBuddy(clearance_);
  progress_ = new QProgressBar(side);
  progress_->setRange(0, 100);
  progress_->hide();
  sign_ = new QLabel(side);
  sign_->setAlignment(Qt::AlignTop);
  figures_ = new QLabel(side);
  figures_->setObjectName("togetherFigures");
  figures_->setWordWrap(true);
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  placesTitle_ = new QLabel(tr("Waits, and what they keep apart"), side);
  places_ = new QListWidget(side);
  places_->setObjectName("togetherPlaces");
  places_->setWordWrap(true);
  places_->setMinimumHeight(kRows * (fontMetrics().height() + 6));
  placesTitle_->setBuddy(places_);
  places_->setAccessibleName(placesTitle_->text());

  auto* added = new QHBoxLayout;
  for (QPushButton* one : {addFile_, addAgain_, remove_})
    added->addWidget(one);
  added->addStretch();
  auto* distance = new QHBoxLayout;
  distance->addWidget(clearanceText);
  distance->addWidget(clearance_);
  distance->addStretch();
  auto* found = new QHBoxLayout;
  found->addWidget(find_);
  found->addWidget(progress_, 1);
  found->addWidget(cancel_);
  found->addStretch();
  auto* verdict = new QHBoxLayout;
  verdict->addWidget(sign_);
  verdict->addWidget(figures_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, side);
  buttons->addButton(save_, QDialogButtonBox::ActionRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(table_);
  column->addLayout(added);
  column->addLayout(distance);
  column->addLayout(found);
  column->addLayout(verdict);
  auto* remedy = new QHBoxLayout;
  remedy->addWidget(apart_);
  remedy->addStretch();
  column->addLayout(remedy);
  column->addWidget(placesTitle_);
  column->addWidget(places_, 1);
  column->addWidget(buttons);
  return side;
}

QWidget* TogetherDialog::buildTimeline() {
  auto* bar = new QWidget(this);
  play_ = new QToolButton(bar);
  play_->setObjectName("togetherPlay");
  play_->setToolTip(tr("Play or pause"));
  lanes_ = new timeline::MachineLanes(bar);
  lanes_->setObjectName("togetherLanes");
  time_ = new QLabel(bar);
  auto* speed = forms::makeCombo(bar);
  for (const int factor : {1, 5, 10, 20, 50, 100})
    speed->addItem(QStringLiteral("%1×").arg(factor), factor);
  speed->setCurrentIndex(2);
  player_->setSpeed(speed->currentData().toDouble());
  connect(speed, &QComboBox::currentIndexChanged, this,
          [this, speed] { player_->setSpeed(speed->currentData().toDouble()); });
  auto* controls = new QHBoxLayout;
  controls->addWidget(play_);
  controls->addWidget(speed);
  auto* left = new QVBoxLayout;
  left->addLayout(controls);
  left->addWidget(time_);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->addLayout(left);
  row->addWidget(lanes_, 1);
  bar->hide();
  return bar;
}

void TogetherDialog::listen() {
  connect(addFile_, &QPushButton::clicked, this, &TogetherDialog::askForFile);
  connect(addAgain_, &QPushButton::clicked, this, &TogetherDialog::addAgain);
  connect(remove_, &QPushButton::clicked, this, &TogetherDialog::removeChosen);
  connect(find_, &QPushButton::clicked, this, &TogetherDialog::findOrder);
  connect(apart_, &QPushButton::clicked, this, &TogetherDialog::moveApart);
  connect(cancel_, &QPushButton::clicked, &joining_, &document::Joining::cancel);
  connect(save_, &QPushButton::clicked, this, &TogetherDialog::askForFolder);
  connect(table_, &MachineTable::placeChanged, machines_, &JoinedMachines::place);
  connect(clearance_, &QDoubleSpinBox::valueChanged, this, [this] {
    machines_->setResult(nullptr);
    showResult();
  });
  connect(machines_, &JoinedMachines::changed, this, [this] {
    showMachines();
    showResult();
  });
  // Leaves a message about a file as it is.
  connect(machines_, &JoinedMachines::drawn, this, &TogetherDialog::showMachines);
  connect(places_, &QListWidget::currentItemChanged, this, &TogetherDialog::goTo);
  connect(&joining_, &document::Joining::stationRead, this,
          [this](const QString& file, const std::shared_ptr<const project::Station>& station) {
            takeStation(file, *station);
          });
  connect(&joining_, &document::Joining::progressed, this,
          [this](double fraction, const QString& stage) {
            progress_->setValue(static_cast<int>(100.0 * fraction));
            figures_->setText(stage);
          });
  connect(&joining_, &document::Joining::planned, this,
          [this](const document::JoinedResult& result) {
            machines_->setResult(result);
            showResult();
          });
  connect(&joining_, &document::Joining::cancelled, this, &TogetherDialog::showResult);
  connect(&joining_, &document::Joining::failed, this,
          [this](const QString& message) { conclude(message, forms::Icon::Blocked); });
  connect(&joining_, &document::Joining::written, this, [this](const QString& folder) {
    conclude(tr("The programs were saved in %1.").arg(folder), forms::Icon::Good);
  });
  connect(player_, &timeline::Player::positionChanged, this, &TogetherDialog::setTimeS);
  connect(player_, &timeline::Player::playingChanged, this, &TogetherDialog::refresh);
  connect(play_, &QToolButton::clicked, player_, &timeline::Player::toggle);
  connect(lanes_, &timeline::MachineLanes::moved, player_, &timeline::Player::setPosition);
  lanes_->setTextOf([this](double timeS) { return forms::clockText(timeS, machines_->endS()); });
}

void TogetherDialog::add(project::Machine machine) {
  table_->addMachine(QString::fromStdString(machine.name),
                     QString::fromStdString(machine.job.choices.cell), machine.shared_T_world);
  machines_->add(std::move(machine));
}

void TogetherDialog::addOpposite(project::Machine machine) {
  machine.shared_T_world =
      machines_->all().empty() ? Eigen::Isometry3d::Identity() : machines_->placeOpposite();
  add(std::move(machine));
  showResult();
}

void TogetherDialog::takeStation(const QString& file, const project::Station& station) {
  if (station.machines.size() == 1) {
    project::Machine machine = station.machines.front();
    machine.name = QFileInfo(file).absoluteDir().dirName().toStdString();
    addOpposite(std::move(machine));
    return;
  }
  while (!machines_->all().empty()) {
    table_->removeMachine(machines_->all().size() - 1);
    machines_->remove(machines_->all().size() - 1);
  }
  takeMachines(station);
}

void TogetherDialog::takeMachines(const project::Station& station) {
  machines_->setRules(station.rules);
  clearance_->setValue(station.rules.clearanceMm);
  for (const project::Machine& machine : station.machines)
    add(machine);
  showResult();
}

void TogetherDialog::addFile(const QString& file) {
  joining_.read(file);
}

void TogetherDialog::addAgain() {
  addOpposite(machines_->all().front());
}

void TogetherDialog::moveApart() {
  machines_->moveApart(kApartMm);
  for (std::size_t k = 0; k < machines_->all().size(); ++k)
    table_->setPlace(k, machines_->all()[k].shared_T_world);
  findOrder();
}

void TogetherDialog::askForFile() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Project of another machine"), {},
                                                    tr("Voluta projects (*.voluta)"));
  if (!file.isEmpty())
    addFile(file);
}

void TogetherDialog::removeChosen() {
  const std::size_t machine = table_->chosen();
  if (machine == 0)
    return; // the project shown
  table_->removeMachine(machine);
  machines_->remove(machine);
  showResult();
}

void TogetherDialog::findOrder() {
  machines_->setResult(nullptr);
  joining_.plan(machines_->station(clearance_->value()));
  showResult();
}

void TogetherDialog::showMachines() {
  std::vector<scene::MachineDrawing> drawings;
  for (const scene::MachineDrawing& drawing : machines_->drawings())
    if (drawing.cell)
      drawings.push_back(drawing);
  const bool isMore = drawings.size() != view_->scene().machineCount();
  view_->scene().setMachines(std::move(drawings));
  if (isMore)
    view_->frameAll();
  view_->requestFrame();
}

void TogetherDialog::refresh() {
  const bool isBusy = joining_.planning();
  const std::size_t count = machines_->all().size();
  const auto& result = machines_->result();
  addFile_->setEnabled(!isBusy && count < plan::kMaxMachines);
  addAgain_->setEnabled(!isBusy && count > 0 && count < plan::kMaxMachines);
  remove_->setEnabled(!isBusy && count > 1);
  table_->setEnabled(!isBusy);
  clearance_->setEnabled(!isBusy);
  find_->setVisible(!isBusy);
  find_->setEnabled(count > 1);
  progress_->setVisible(isBusy);
  cancel_->setVisible(isBusy);
  save_->setEnabled(!isBusy && result &&
                    pipeline::verdictOf(*result) != pipeline::PlanVerdict::Refused);
  const plan::Finding* blocking = result ? pipeline::firstBlocking(result->findings) : nullptr;
  apart_->setVisible(!isBusy && blocking && pipeline::isOfPlaces(*blocking));
  timeline_->setVisible(machines_->endS() > 0.0);
  play_->setIcon(
      timeline::icon(player_->playing() ? timeline::BarIcon::Pause : timeline::BarIcon::Play));
}

void TogetherDialog::conclude(const QString& text, forms::Icon sign) {
  refresh();
  figures_->setText(text);
  sign_->setPixmap(forms::iconBeside(*figures_, sign));
}

void TogetherDialog::showResult() {
  const auto& result = machines_->result();
  places_->clear();
  view_->scene().setMarker(std::nullopt);
  player_->pause();
  player_->setEnd(machines_->endS());
  lanes_->setLanes(machines_->lanes(), machines_->endS());
  sign_->clear();
  refresh();
  if (!result) {
    figures_->setText(joining_.planning() ? QString()
                      : machines_->all().size() < 2
                          ? tr("Add the project of a machine that works beside this one.")
                          : tr("Place the machines, then find an order of work."));
    setTimeS(0.0);
    return;
  }
  listPlaces();
  const plan::Finding* refusal = pipeline::firstBlocking(result->findings);
  const pipeline::PlanVerdict verdict = pipeline::verdictOf(*result);
  const bool isSafe = verdict != pipeline::PlanVerdict::Refused;
  QStringList lines;
  if (refusal)
    lines << tr("%1: %2").arg(language::words(plan::reasonOf(*refusal)),
                              language::words(plan::remedyOf(*refusal)));
  for (const plan::Finding& finding : result->findings)
    if (!finding.blocking)
      lines << tr("Note: %1").arg(language::words(plan::reasonOf(finding)));
  if (result->replay) {
    double aloneS = 0.0, sumS = 0.0;
    for (const std::vector<double>& seconds : result->work.seconds) {
      double own = 0.0;
      for (const double s : seconds)
        own += s;
      aloneS = std::max(aloneS, own);
      sumS += own;
    }
    lines << tr("Together %1; one after the other %2; the longest alone %3")
                 .arg(forms::durationText(result->replay->makespanS), forms::durationText(sumS),
                      forms::durationText(aloneS));
    const auto& clocks = result->replay->clock.machines;
    for (std::size_t k = 0; k < clocks.size(); ++k)
      lines << tr("Machine %1: marks %2, waits %3, ends after %4")
                   .arg(k + 1)
                   .arg(clocks[k].meetings().size())
                   .arg(forms::durationText(clocks[k].waitS()),
                        forms::durationText(clocks[k].totalS));
    lines << tr("Minimum distance %1 mm; collisions: %2")
                 .arg(number(result->replay->minDistanceMm, 1))
                 .arg(result->replay->collisions);
    if (isSafe && !result->work.order->meetings.empty())
      lines << tr("Start the programs in any order: each waits at its first point for the others, "
                  "whatever their signals are, and ends with its signals off. If one is stopped, "
                  "stop all, and start all again.");
    std::vector<double> collisions;
    for (const replay::Meeting& meeting : result->replay->meetings)
      collisions.push_back(meeting.whenS);
    lanes_->setCollisions(std::move(collisions));
  }
  if (refusal)
    view_->scene().setMarker(refusal->where);
  conclude(lines.join(QLatin1Char('\n')), !refusal ? forms::Icon::Good
                                          : isSafe ? forms::Icon::Warning
                                                   : forms::Icon::Blocked);
  setTimeS(0.0);
}

// Lists collisions, then waits with the place at which the machines would meet without them.
void TogetherDialog::listPlaces() {
  const auto& result = machines_->result();
  const bool hasRun = result && result->replay;
  const auto add = [&](double timeS, const QString& text,
                       const std::optional<Eigen::Vector3d>& place) {
    auto* item = new QListWidgetItem(
        QStringLiteral("%1   %2").arg(forms::clockText(timeS, machines_->endS()), text), places_);
    item->setData(TimeRole, timeS);
    if (place)
      item->setData(PlaceRole, QVariantList{place->x(), place->y(), place->z()});
  };
  if (!hasRun)
    return;
  for (const replay::Meeting& m : result->replay->meetings)
    add(m.whenS,
        tr("Collision: %1 of machine %2 with %3 of machine %4")
            .arg(language::words(m.bodies[0]))
            .arg(m.machines[0] + 1)
            .arg(language::words(m.bodies[1]))
            .arg(m.machines[1] + 1),
        m.where);
  const auto& meetings = result->work.order->meetings;
  std::vector<std::size_t> passed(result->plans.size(), 0);
  for (std::size_t r = 0; r < meetings.size(); ++r)
    for (const std::size_t machine : {meetings[r].first, meetings[r].second}) {
      const auto marks = result->replay->clock.machines[machine].meetings();
      const std::size_t own = passed[machine]++;
      if (own >= marks.size() || marks[own].toS - marks[own].fromS < kShownWaitS)
        continue;
      const auto& place = result->work.conflictPlaces[r];
      const QString wait = tr("Machine %1 waits %2 for machine %3")
                               .arg(machine + 1)
                               .arg(forms::durationText(marks[own].toS - marks[own].fromS))
                               .arg(marks[own].other + 1);
      add(marks[own].fromS, place ? tr("%1 at %2").arg(wait, placeText(*place)) : wait, place);
    }
}

void TogetherDialog::goTo(const QListWidgetItem* item) {
  if (!item)
    return;
  const QVariantList place = item->data(PlaceRole).toList();
  view_->scene().setMarker(place.size() == 3
                               ? std::optional(Eigen::Vector3d(
                                     place[0].toDouble(), place[1].toDouble(), place[2].toDouble()))
                               : std::nullopt);
  player_->setPosition(item->data(TimeRole).toDouble());
  setTimeS(item->data(TimeRole).toDouble());
}

void TogetherDialog::setTimeS(double timeS) {
  lanes_->setTimeS(timeS);
  time_->setText(
      QStringLiteral("%1 / %2").arg(forms::clockText(timeS, machines_->endS()),
                                    forms::clockText(machines_->endS(), machines_->endS())));
  if (view_->scene().machineCount() == machines_->all().size())
    view_->scene().setMoments(machines_->momentsAt(timeS));
  view_->requestFrame();
}

void TogetherDialog::askForFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for all programs"));
  if (!folder.isEmpty())
    save(folder);
}

void TogetherDialog::save(const QString& folder) {
  if (machines_->result())
    joining_.write(folder, machines_->result());
}

} // namespace voluta::window
