#include "window/pages/simulate_page.h"

#include "base/error.h"
#include "base/units.h"
#include "document/document.h"
#include "forms/value_boxes.h"
#include "jobs/job_runner.h"
#include "motion/layer_event_text.h"
#include "motion/resumed_motion.h"
#include "panels/cursor_info.h"
#include "panels/jog_panel.h"
#include "panels/resume_bar.h"
#include "pipeline/checked_program.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "robot/cell.h"
#include "timeline/joint_plots.h"
#include "timeline/layer_range_slider.h"
#include "window/background.h"
#include "window/pages/cell_view.h"
#include "window/pages/event_marks.h"
#include "window/pages/jogging.h"
#include "window/pages/layer_event_edits.h"
#include "window/pages/resumable.h"
#include "window/picture_area.h"
#include "window/presenters/presenter.h"
#include "window/program_preview.h"
#include "window/run_dialog.h"
#include "window/together/together_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::window {

using project::Stage;

namespace {
// Entries of the choice of the trace.
enum TraceOf { kNoTrace, kLastSeconds, kLastMinute, kWholeTrace };
constexpr double kShortTraceS = 10.0, kLongTraceS = 60.0;
} // namespace

SimulatePage::SimulatePage(const Workspace& workspace)
    : Page({"simulate", QT_TRANSLATE_NOOP("Commands", "&Simulate")}, workspace),
      plots_(new timeline::JointPlots), side_(new QWidget) {
  solids_ = new QCheckBox(side_);
  solids_->setObjectName("simulateSolids");
  follow_ = new QCheckBox(side_);
  follow_->setObjectName("followNozzle");
  kinds_ = new QCheckBox(side_);
  kinds_->setObjectName("simulateKinds");
  jog_ = new QCheckBox(side_);
  jog_->setObjectName("jogArm");
  traceName_ = new QLabel(side_);
  traces_ = forms::makeCombo(side_);
  traces_->setObjectName("tipTrace");
  traceName_->setBuddy(traces_);
  traces_->addItems({{}, {}, {}, {}}); // named by retranslate()
  cursor_ = new panels::CursorInfo(side_);
  cursor_->setObjectName("cursorInfo");
  addEvent_ = new QPushButton(side_);
  addEvent_->setObjectName("simulateAddEvent");
  resume_ = new panels::ResumeBar(side_);
  resume_->setContentsMargins(6, 0, 6, 4);
  lines_ = new ProgramPreview(this);
  jogging_ = std::make_unique<Jogging>(work(), side_);
  tracing_ = std::make_unique<jobs::JobRunner>();
  build();
  listen();
}

SimulatePage::~SimulatePage() = default;

void SimulatePage::build() {
  plots_->setObjectName("plots");
  plots_->setMinimumWidth(1); // on a narrow screen they are drawn narrower
  plotsArea_ = scrolled(plots_);
  plotsArea_->setObjectName("plotsArea"); // may be narrow, as it scrolls
  jogArea_ = scrolled(jogging_->panel());
  jogArea_->setObjectName("jogArea");
  jogArea_->hide();
  auto* boxes = new QVBoxLayout; // side by side they are too wide in some languages
  boxes->setContentsMargins(6, 4, 6, 0);
  boxes->setSpacing(2);
  for (QCheckBox* box : {solids_, follow_, kinds_, jog_})
    boxes->addWidget(box);
  auto* tracing = new QHBoxLayout;
  tracing->addWidget(traceName_);
  tracing->addWidget(traces_, 1);
  boxes->addLayout(tracing);
  auto* column = new QVBoxLayout(side_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(boxes);
  column->addWidget(cursor_);
  column->addWidget(plotsArea_, 1);
  column->addWidget(jogArea_, 1);
  auto* adding = new QHBoxLayout;
  adding->setContentsMargins(6, 0, 6, 0);
  adding->addStretch(1);
  adding->addWidget(addEvent_);
  column->addLayout(adding);
  column->addWidget(resume_);
}

void SimulatePage::listen() {
  timeline::TimelineBar* bar = &work().timeline;
  connect(bar, &timeline::TimelineBar::timeChanged, plots_, &timeline::JointPlots::setTimeS);
  connect(plots_, &timeline::JointPlots::timeClicked, bar, &timeline::TimelineBar::setTimeS);
  for (QCheckBox* box : {solids_, kinds_})
    connect(box, &QCheckBox::toggled, this, [this] { work().shell.showView(); });
  connect(bar, &timeline::TimelineBar::timeChanged, this, [this] {
    showCursor();
    followNozzle();
    if (traces_->currentIndex() != kWholeTrace)
      showTrace();
  });
  connect(follow_, &QCheckBox::toggled, this, &SimulatePage::followNozzle);
  connect(jog_, &QCheckBox::toggled, this, &SimulatePage::jog);
  side_->installEventFilter(this);
  connect(jogging_.get(), &Jogging::moved, this, [this] {
    showCursor();
    work().shell.showView();
  });
  connect(jogging_.get(), &Jogging::ended, jog_, [this] { jog_->setChecked(false); });
  connect(traces_, &QComboBox::currentIndexChanged, this, &SimulatePage::showTrace);
  connect(lines_, &ProgramPreview::linesReady, this, &SimulatePage::showCursor);
  connect(&work().document, &document::Document::resultChanged, this, [this](Stage stage) {
    if (stage == Stage::Replay)
      showProgram();
  });
  connect(&work().presenter, &Presenter::motionReady, this, &SimulatePage::showMotion);
  connect(&work().presenter, &Presenter::statisticsReady, this, &SimulatePage::showCursor);
  connect(resume_, &panels::ResumeBar::asked, this, &SimulatePage::resume);
  connect(bar, &timeline::TimelineBar::menuAsked, this, &SimulatePage::openTimeMenu);
  connect(addEvent_, &QPushButton::clicked, this,
          [this] { askForEvent(work(), layerShown(), side_->window()); });
  connect(bar, &timeline::TimelineBar::timeChanged, this, &SimulatePage::showResume);
  connect(&work().document, &document::Document::stateChanged, this, &SimulatePage::showResume);
}

void SimulatePage::jog(bool on) {
  if (on && !jogging_->start()) {
    jog_->setChecked(false);
    work().shell.say(tr("Plan the motion before you jog the arm."));
    return;
  }
  if (!on)
    jogging_->end();
  plotsArea_->setVisible(!on);
  jogArea_->setVisible(on);
  cursor_->setVisible(!on); // the panel has the same values, and needs the room
  showCursor();
  if (isShown())
    work().shell.showView();
}

void SimulatePage::left() {
  jogging_->end();
  tracing_->cancel();
  traced_.reset();
  tracedClock_ = nullptr;
  work().viewport.scene().setTrace({});
}

// The tips of all points, once they are wanted.
void SimulatePage::prepareTrace() {
  const auto& clock = work().presenter.clock();
  const auto motion = work().document.result(Stage::Motion);
  if (clock == tracedClock_)
    return;
  tracing_->cancel();
  traced_.reset();
  tracedClock_ = nullptr;
  // Between two plans the clock may be that of the one before.
  if (!clock || clock->empty() || !motion || !motion->cell ||
      motion->job.trajectory != clock->trajectory())
    return;
  tracedClock_ = clock;
  inBackground(
      *tracing_,
      [clock, cell = motion->cell,
       theme = sceneTheme(side_->palette())](const base::RunContext& ctx) {
        auto traced = std::make_shared<Traced>();
        traced->trace = tipTrace(*clock, *cell, ctx);
        traced->whole = traceLines(traced->trace, 0.0, clock->durationS(), theme);
        return std::shared_ptr<const Traced>(traced);
      },
      [this](auto&& traced) {
        traced_ = traced;
        showTrace();
      });
}

void SimulatePage::showTrace() {
  if (!isShown())
    return;
  const int of = traces_->currentIndex();
  if (of != kNoTrace)
    prepareTrace();
  const scene::Theme theme = sceneTheme(side_->palette());
  std::vector<scene::LineGroup> lines;
  if (of == kWholeTrace && traced_) {
    lines = traced_->whole;
    colourTrace(lines, theme);
  } else if (of != kNoTrace && traced_) {
    const double now = work().timeline.timeS();
    lines = traceLines(traced_->trace, now - (of == kLastSeconds ? kShortTraceS : kLongTraceS), now,
                       theme);
  }
  work().viewport.scene().setTrace(lines);
  work().viewport.requestFrame();
}

// The trace has colours of the look.
bool SimulatePage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == side_ && event->type() == QEvent::PaletteChange)
    showTrace();
  return Page::eventFilter(watched, event);
}

std::vector<Command> SimulatePage::commands() {
  return {{"resumePrint",
           "runMenu",
           2,
           QT_TRANSLATE_NOOP("Commands", "&Resume print from here…"),
           QT_TRANSLATE_NOOP("Commands",
                             "Opens the rest of a print stopped at this moment as a new project"),
           {},
           [this] { resume(); },
           [this] { return resumePoint().has_value(); }},
          {"compareRun",
           "runMenu",
           3,
           QT_TRANSLATE_NOOP("Commands", "Compare with a recor&ded run…"),
           QT_TRANSLATE_NOOP("Commands",
                             "Lays a run that the controller recorded beside the plan shown"),
           {},
           [this] { compareRun(); },
           [this] { return comparable() != nullptr; }},
          {"printTogether",
           "runMenu",
           3,
           QT_TRANSLATE_NOOP("Commands", "Print to&gether with other machines…"),
           QT_TRANSLATE_NOOP("Commands", "Places other machines beside this one and finds an "
                                         "order of work in which they do not meet"),
           {},
           [this] { printTogether(); },
           [this] { return comparable() != nullptr; }}};
}

std::shared_ptr<const pipeline::PlanResult> SimulatePage::comparable() const {
  const auto motion = work().document.result(Stage::Motion);
  return motion && motion->job.trajectory ? motion : nullptr;
}

void SimulatePage::compareRun() {
  const QString file =
      QFileDialog::getOpenFileName(side_->window(), tr("Recorded run"), {}, tr("All files (*)"));
  const auto plan = comparable();
  if (!plan || file.isEmpty())
    return;
  work().shell.show(*this);
  auto* dialog = new RunDialog(file, plan, side_->window());
  connect(dialog, &RunDialog::placeChosen, this, &SimulatePage::goToPoint);
  connect(dialog, &RunDialog::compared, this,
          [this](const std::vector<record::ErrorPlace>& places) {
            runPlaces_ = places;
            showRunPlaces();
          });
  dialog->open();
}

void SimulatePage::printTogether() {
  const auto plan = comparable();
  if (!plan)
    return;
  project::Station station;
  station.machines.push_back({plan->job.item().partName, plan->job});
  auto* dialog = new TogetherDialog(station, side_->window());
  dialog->open();
}

void SimulatePage::goToPoint(std::size_t point) {
  if (const auto& clock = work().presenter.clock(); clock && point < clock->pointCount())
    work().timeline.setTimeS(clock->timeOfPoint(point));
}

// Marks the places of the recorded run on the time-line.
void SimulatePage::showRunPlaces() {
  if (!isShown())
    return; // the time-line has the marks of another page
  const auto& clock = work().presenter.clock();
  std::vector<timeline::Span> spans;
  if (clock)
    for (const record::ErrorPlace& place : runPlaces_)
      if (place.point < clock->pointCount()) {
        const double at = clock->timeOfPoint(place.point);
        spans.push_back({at, at, placeText(place)});
      }
  std::ranges::sort(spans, {}, &timeline::Span::fromS);
  work().timeline.setSpans(std::move(spans));
}

// Those of the shown motion; the choices that are planned next may have others.
void SimulatePage::showEvents() {
  std::vector<double> waits;
  const auto motion = work().document.result(Stage::Motion);
  if (motion)
    for (const project::ItemChoices& item : motion->job.choices.items)
      if (const auto text = item.parameters.find(motion::kLayerEvents);
          text != item.parameters.end())
        try {
          for (const plan::LayerEvent& event : motion::layerEventsOf(text->second))
            if (event.kind == plan::LayerEventKind::Wait)
              waits.push_back(event.seconds);
        } catch (const base::Error&) { // the plan reports it
        }
  const auto& clock = work().presenter.clock();
  work().timeline.setEvents(clock ? eventMarks(*clock, waits) : std::vector<timeline::EventMark>());
}

int SimulatePage::layerShown() const {
  const auto& clock = work().presenter.clock();
  return clock && !clock->empty() ? clock->layerAt(work().timeline.timeS()) : -1;
}

void SimulatePage::openTimeMenu(double timeS, const QPoint& global) {
  const auto& clock = work().presenter.clock();
  if (!isShown() || !clock || clock->empty())
    return;
  work().timeline.setTimeS(timeS);
  const int layer = layerShown();
  auto* menu = new QMenu(side_->window());
  menu->setObjectName("timeMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const bool isPaused = std::ranges::binary_search(pausedLayers(work()), layer);
  QAction* pause = menu->addAction(isPaused ? tr("Remove the pause before layer %1").arg(layer + 1)
                                            : tr("Pause before layer %1").arg(layer + 1));
  pause->setObjectName("pauseHere");
  connect(pause, &QAction::triggered, this,
          [this, layer, isPaused] { setPause(work(), layer, !isPaused); });
  QAction* event = menu->addAction(tr("Event before layer %1…").arg(layer + 1));
  event->setObjectName("eventHere");
  connect(event, &QAction::triggered, this,
          [this, layer] { askForEvent(work(), layer, side_->window()); });
  menu->popup(global);
}

std::optional<std::size_t> SimulatePage::resumePoint() const {
  return resumableAt(work(), [&](const plan::Trajectory& t) {
    return motion::resumePointOfBead(t, work().presenter.clock()->pointAt(work().timeline.timeS()));
  });
}

void SimulatePage::showResume() {
  if (!isShown())
    return;
  addEvent_->setEnabled(layerShown() >= 0);
  const auto point = resumePoint();
  resume_->setPlace(point ? placeOfPoint(work(), *point) : QString());
}

void SimulatePage::resume() {
  if (const auto point = resumePoint())
    work().shell.resume(*point);
}

void SimulatePage::retranslate() {
  solids_->setText(tr("Collision solids"));
  solids_->setToolTip(tr("Shows the solids used for collision checks over the arm"));
  follow_->setText(tr("Follow the nozzle"));
  follow_->setToolTip(tr("Keeps the nozzle in the middle of the view"));
  kinds_->setText(tr("Kinds of beads, with statistics"));
  kinds_->setToolTip(tr("Colours the beads by kind, with time, share, length and mass of each"));
  jog_->setText(tr("Jog the arm"));
  jog_->setToolTip(
      tr("Moves the arm by hand, by joints or by the nozzle. The plan stays as it is"));
  traceName_->setText(tr("Trace of the nozzle"));
  const QSignalBlocker quiet(traces_);
  traces_->setItemText(kNoTrace, tr("None"));
  traces_->setItemText(kLastSeconds, tr("Last %1 s").arg(QLocale().toString(kShortTraceS)));
  traces_->setItemText(kLastMinute, tr("Last %1 s").arg(QLocale().toString(kLongTraceS)));
  traces_->setItemText(kWholeTrace, tr("Whole print"));
  traces_->setToolTip(tr("Solid where the nozzle prints, dashed where it travels"));
  addEvent_->setText(tr("Event before this layer…"));
  addEvent_->setToolTip(tr("A pause, a wait, an output, another tool or a line of your own"));
  jogging_->retranslate();
  showResume();
}

void SimulatePage::entered() {
  showCursor();
  showTrace();
  showRunPlaces();
}

void SimulatePage::showMotion() {
  runPlaces_.clear(); // of another motion
  showRunPlaces();
  showEvents();
  const auto& clock = work().presenter.clock();
  std::vector<robot::JointLimits> limits;
  std::vector<robot::ExternalAxis> externalAxes;
  if (const auto motion = work().document.result(Stage::Motion); motion && motion->cell) {
    limits = motion->cell->limits();
    externalAxes = motion->cell->externalAxes();
  }
  plots_->setTrajectory(clock ? clock->trajectory() : nullptr, std::move(limits),
                        std::move(externalAxes));
  showProgram();
  showResume();
  showTrace();
}

// Of the first format, as the programs of one plan have the same motion.
void SimulatePage::showProgram() {
  const auto& clock = work().presenter.clock();
  const auto replay = work().document.result(Stage::Replay);
  const auto trajectory = clock ? clock->trajectory() : nullptr;
  texts_.clear();
  if (replay && !replay->checked.empty() && replay->job.trajectory == trajectory) {
    const auto& checked = replay->checked.front();
    lines_->setProgram(checked, trajectory);
    for (const plan::ProgramFile& file : checked->program.files)
      texts_.emplace_back(std::shared_ptr<const std::string>(checked, &file.text));
  } else {
    lines_->setProgram(nullptr, nullptr);
  }
  showCursor();
}

QString SimulatePage::programLine(std::size_t& number) const {
  const auto at = lines_->lineAt(*work().presenter.clock(), work().timeline.timeS());
  if (!at || at->file >= texts_.size() || at->line == 0 || at->line > texts_[at->file].count())
    return {};
  number = at->line;
  const std::string_view text = texts_[at->file].line(at->line - 1);
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).trimmed();
}

void SimulatePage::showCursor() {
  if (!isShown())
    return;
  const auto& clock = work().presenter.clock();
  const auto motion = work().document.result(Stage::Motion);
  if (!clock || clock->empty() || !motion || !motion->cell) {
    cursor_->setFacts(std::nullopt);
    return;
  }
  const robot::Cell& cell = *motion->cell;
  const double now = work().timeline.timeS();
  const bool jogged = jogging_->isOn();
  const robot::JointVector joints = jogged ? jogging_->joints() : clock->jointsAt(now);
  const Eigen::Isometry3d work_T_tool = cell.work_T_tool(joints);
  panels::CursorFacts facts;
  if (!jogged)
    facts.line = programLine(facts.lineNumber);
  const NozzlePose nozzle = nozzlePose(work_T_tool);
  facts.tipMm = nozzle.tipMm;
  facts.anglesDeg = nozzle.anglesDeg;
  // The nozzle's z axis points out of it.
  facts.tiltDeg =
      base::radiansToDegrees(std::acos(std::clamp(std::abs(work_T_tool.linear()(2, 2)), 0.0, 1.0)));
  constexpr double kStepS = 1e-3;
  const double from = std::max(0.0, now - kStepS), to = std::min(clock->durationS(), now + kStepS);
  if (to > from && !jogged)
    facts.speedMmPerS = (cell.work_T_tool(clock->jointsAt(to)).translation() -
                         cell.work_T_tool(clock->jointsAt(from)).translation())
                            .norm() /
                        (to - from);
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    const bool slides =
        cell.limits()[static_cast<std::size_t>(i)].kind == robot::JointKind::Sliding;
    facts.joints.push_back({slides ? joints[i] : base::radiansToDegrees(joints[i]), slides});
  }
  const plan::Trajectory& t = *clock->trajectory();
  if (t.extrudedMm3.back() > 0.0)
    facts.printedShare = t.extrudedMm3[clock->pointAt(now)] / t.extrudedMm3.back();
  if (const auto& statistics = work().presenter.statistics();
      statistics && statistics->of == clock->toolPlan())
    facts.printedG = facts.printedShare * statistics->figures.whole.total().massG;
  cursor_->setFacts(facts);
}

void SimulatePage::followNozzle() {
  const auto& clock = work().presenter.clock();
  const auto motion = work().document.result(Stage::Motion);
  if (!isShown() || !follow_->isChecked() || !clock || clock->empty() || !motion || !motion->cell)
    return;
  const robot::JointVector joints = clock->jointsAt(work().timeline.timeS());
  work().viewport.follow(motion->cell->base_T_work(joints) *
                         motion->cell->work_T_tool(joints).translation());
}

void SimulatePage::draw(scene::ViewState& view) {
  drawCellAtWork(view, work());
  view.collisionSolids = solids_->isChecked();
  if (kinds_->isChecked())
    view.materialColour = false;
  if (jogging_->isOn())
    view.joints = jogging_->joints();
}

std::optional<PrintProgress> SimulatePage::printProgress() const {
  PrintProgress printProgress;
  if (const auto& clock = work().presenter.clock(); clock && !clock->empty())
    printProgress.end = clock->printedWaypoints(work().timeline.timeS());
  const auto plan = planOfLayers(work().document);
  const plan::ToolPath* path =
      plan ? plan::pathOf(*plan, std::max<std::size_t>(printProgress.end, 1) - 1) : nullptr;
  printProgress.layer = path ? path->layer : work().layers.last();
  return printProgress;
}

void SimulatePage::goToTimeOf(std::size_t waypoint) {
  if (!work().presenter.clock())
    return;
  if (const auto time = work().presenter.clock()->timeOfWaypoint(waypoint))
    work().timeline.setTimeS(*time);
}

void SimulatePage::goToWaypoint(const plan::ToolPath&, std::size_t waypoint) {
  goToTimeOf(waypoint);
}

int SimulatePage::interest(const plan::Finding& finding) const {
  if (!work().presenter.clock())
    return 0;
  if (finding.whenS)
    return 3;
  return plan::stageOf(finding) == Stage::Motion || plan::stageOf(finding) == Stage::Replay ? 2 : 0;
}

bool SimulatePage::goTo(const plan::Finding& finding) {
  if (finding.whenS)
    work().timeline.setTimeS(*finding.whenS);
  return false;
}

void SimulatePage::clicked(const std::optional<scene::Hit>& hit) {
  if (!hit || hit->what != scene::Hit::What::Path || !work().presenter.clock())
    return;
  goToTimeOf(hit->waypoint);
  work().shell.chooseWaypoint(hit->waypoint);
}

} // namespace voluta::window
