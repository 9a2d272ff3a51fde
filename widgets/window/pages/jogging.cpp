#include "window/pages/jogging.h"

#include "base/units.h"
#include "document/document.h"
#include "language/words.h"
#include "panels/jog_panel.h"
#include "robot/cell.h"
#include "window/background.h"
#include "window/presenters/presenter.h"

#include <QEvent>
#include <QLocale>

namespace voluta::window {

using project::Stage;

namespace {

constexpr int kSlowMs = 150; // a check that takes less changes no text meanwhile

bool slides(const robot::Cell& cell, std::size_t joint) {
  return cell.limits()[joint].kind == robot::JointKind::Sliding;
}

double shownValue(const robot::Cell& cell, std::size_t joint, double value) {
  return slides(cell, joint) ? value : base::radiansToDegrees(value);
}

std::vector<panels::JogJoint> jointsOf(const robot::Cell& cell) {
  std::vector<panels::JogJoint> joints;
  for (std::size_t i = 0; i < cell.limits().size(); ++i) {
    const auto arm = static_cast<std::size_t>(cell.armDof());
    const robot::JointLimits& limits = cell.limits()[i];
    joints.push_back({i < arm ? QString::number(i + 1)
                              : QString::fromStdString(cell.externalAxes()[i - arm].name),
                      shownValue(cell, i, limits.min), shownValue(cell, i, limits.max),
                      slides(cell, i)});
  }
  return joints;
}

} // namespace

Jogging::Jogging(const Workspace& workspace, QWidget* parent)
    : QObject(parent), work_(workspace), panel_(new panels::JogPanel(parent)),
      reading_(std::make_unique<jobs::JobRunner>()),
      checking_(std::make_unique<jobs::JobRunner>()) {
  panel_->setObjectName("jogPanel");
  slowly_.setSingleShot(true);
  slowly_.setInterval(kSlowMs);
  connect(&slowly_, &QTimer::timeout, this, [this] {
    checked_.reset();
    show();
  });
  connect(panel_, &panels::JogPanel::jointWished, this, [this](int joint, double value) {
    if (!arm_)
      return;
    const auto i = static_cast<std::size_t>(joint);
    arm_->setJoint(joint, slides(arm_->cell(), i) ? value : base::degreesToRadians(value));
    take(true);
  });
  connect(panel_, &panels::JogPanel::coordinateWished, this, [this](int coordinate, double value) {
    if (!arm_)
      return;
    NozzlePose pose = arm_->nozzle();
    (coordinate < 3 ? pose.tipMm[coordinate] : pose.anglesDeg[coordinate - 3]) = value;
    take(arm_->setNozzle(pose));
  });
  connect(panel_, &panels::JogPanel::stepWished, this, [this](int coordinate, double amount) {
    if (arm_)
      take(arm_->step(coordinate, amount));
  });
  connect(panel_, &panels::JogPanel::endWished, this, &Jogging::end);
  // The arm is that of one motion, at one moment of it.
  connect(&work_.presenter, &Presenter::motionReady, this, &Jogging::end);
  connect(&work_.timeline, &timeline::TimelineBar::timeChanged, this, &Jogging::end);
}

Jogging::~Jogging() = default;

bool Jogging::start() {
  const auto& clock = work_.presenter.clock();
  const auto motion = work_.document.result(Stage::Motion);
  if (!clock || clock->empty() || !motion || !motion->cell)
    return false;
  work_.timeline.pause();
  arm_ = std::make_unique<JoggedArm>(motion, clock->jointsAt(work_.timeline.timeS()));
  reached_ = true;
  checked_.reset();
  panel_->setJoints(jointsOf(arm_->cell()));
  readPart(motion);
  show();
  check();
  return true;
}

void Jogging::readPart(const std::shared_ptr<const pipeline::PlanResult>& plan) {
  if (!plan->job.toolPlan)
    return;
  const std::size_t printed = work_.presenter.clock()->printedWaypoints(work_.timeline.timeS());
  inBackground(
      *reading_, [plan](const base::RunContext& ctx) { return joggingPart(*plan, ctx); },
      [this, printed](auto&& part) {
        if (!arm_)
          return;
        arm_->setPart(part, printed);
        check();
      });
}

void Jogging::end() {
  if (!arm_)
    return;
  reading_->cancel();
  checking_->cancel();
  slowly_.stop();
  againWanted_ = false;
  arm_.reset();
  emit ended();
}

void Jogging::retranslate() {
  if (arm_)
    show();
}

void Jogging::take(bool reached) {
  reached_ = reached;
  show();
  check();
  emit moved();
}

void Jogging::check() {
  if (!slowly_.isActive())
    slowly_.start();
  againWanted_ = checking_->running();
  if (againWanted_)
    return;
  inBackground(*checking_, arm_->check(), [this](JoggedArm::Check check) {
    if (!arm_)
      return;
    checked_ = std::move(check);
    if (againWanted_) {
      QTimer::singleShot(0, this, [this] {
        if (arm_)
          this->check();
      });
      return;
    }
    slowly_.stop();
    show();
  });
}

void Jogging::show() {
  const robot::Cell& cell = arm_->cell();
  panels::JogState state;
  for (std::size_t i = 0; i < cell.limits().size(); ++i)
    state.joints.push_back(shownValue(cell, i, arm_->joints()[static_cast<Eigen::Index>(i)]));
  const NozzlePose nozzle = arm_->nozzle();
  for (std::size_t i = 0; i < 3; ++i) {
    state.coordinates[i] = nozzle.tipMm[static_cast<Eigen::Index>(i)];
    state.coordinates[i + 3] = nozzle.anglesDeg[static_cast<Eigen::Index>(i)];
  }
  say(state);
  panel_->setState(state);
}

void Jogging::say(panels::JogState& state) const {
  if (!checked_) {
    state.sign = forms::Icon::Pending;
    state.message = tr("Checking the pose…");
  } else if (checked_->colliding) {
    state.sign = forms::Icon::Blocked;
    state.message = tr("Collision: %1 and %2")
                        .arg(language::words(checked_->colliding->first),
                             language::words(checked_->colliding->second));
  } else {
    const bool far = checked_->clearanceMm >= JoggedArm::kMaxClearanceMm;
    state.message = (far ? tr("Free: more than %1 mm between bodies")
                         : tr("Free: %1 mm between the nearest bodies"))
                        .arg(QLocale().toString(checked_->clearanceMm, 'f', 0));
  }
  if (!reached_) {
    state.sign = checked_ && checked_->colliding ? forms::Icon::Blocked : forms::Icon::Warning;
    state.message = tr("The arm does not reach that pose within its joint limits. It stays here.");
  } else if (checked_ && !arm_->checksPart()) {
    state.message += QStringLiteral("\n") + tr("The printed part is not checked yet.");
  }
}

} // namespace voluta::window
