// What goes with a way of building: cell, process and platform change along with it, and what does
// not fit is said beside the choices, with a button that mends it.
#include "window/main_window.h"

#include "forms/choices_form.h"
#include "modes/mode_table.h"
#include "window/core_texts.h"
#include "window/touch_dialog.h"

#include <QFileInfo>

namespace voluta::window {

namespace {
QString named(const std::string& text) {
  return QString::fromStdString(text);
}

// What `to` has other than `from`, in words.
QString changesOf(const project::Choices& from, const project::Choices& to) {
  QStringList parts;
  if (to.cell != from.cell)
    parts << MainWindow::tr("cell %1").arg(named(to.cell));
  if (to.platform != from.platform)
    parts << MainWindow::tr("platform %1").arg(platformText(to.platform));
  if (to.process != from.process)
    parts << MainWindow::tr("process %1").arg(named(to.process));
  if (to.scale != from.scale)
    parts << MainWindow::tr("scale %1").arg(named(to.scale));
  if (to.parameters != from.parameters)
    parts << MainWindow::tr("the part as it lies");
  return parts.join(QStringLiteral(", "));
}

// Is the platform a body whose file has gone?
bool bodyIsMissing(const project::Choices& choices) {
  return choices.platform.isBody() && !QFileInfo(named(choices.platform.file())).isFile();
}

bool wantsBody(const project::Choices& choices) {
  return modes::findMode(choices.mode).platforms.front() == project::PlatformUse::Body &&
         !choices.platform.isBody();
}
} // namespace

void MainWindow::connectModes() {
  connect(choices_, &forms::ChoicesForm::noticePressed, this, &MainWindow::pressNotice);
  connect(choices_, &forms::ChoicesForm::rodProfileChanged, this,
          [this](const forms::RodProfile& profile) {
            project::Choices c = document_.choices();
            c.parameters.erase("rodSides");
            c.parameters.erase("rodProfile");
            if (profile.sides > 0)
              c.parameters["rodSides"] = std::to_string(profile.sides);
            if (!profile.points.isEmpty())
              c.parameters["rodProfile"] = profile.points.toStdString();
            document_.setChoices(c, tr("shape of the rod"));
          });
}

void MainWindow::switchMode(const std::string& mode) {
  const project::Choices before = document_.choices();
  const project::Choices now = modeSwitch_.switched(before, mode);
  wentAlong_ = {mode, changesOf(before, now)};
  document_.setChoices(now, tr("way of building"));
  showNotice();
}

void MainWindow::showNotice() {
  const project::Choices& choices = document_.choices();
  if (const QString obstacle = document::obstacle(choices); !obstacle.isEmpty()) {
    const project::Choices mended = document::fitting(choices);
    const QString changes = changesOf(choices, mended);
    choices_->setNotice(obstacle,
                        bodyIsMissing(choices) ? tr("Choose the file…")
                        : changes.isEmpty()    ? QString()
                                               : tr("Use %1").arg(changes),
                        true);
  } else if (wantsBody(choices)) {
    choices_->setNotice(tr("Which body is printed on? Without one it is the plate."),
                        tr("Choose the body…"), false);
  } else if (wentAlong_.first == choices.mode && !wentAlong_.second.isEmpty()) {
    choices_->setNotice(tr("Changed with it: %1.").arg(wentAlong_.second), {}, false);
  } else {
    choices_->setNotice({}, {}, false);
  }
}

void MainWindow::pressNotice() {
  const project::Choices& choices = document_.choices();
  if (bodyIsMissing(choices) || wantsBody(choices))
    choices_->choosePlatformFile();
  else
    document_.setChoices(document::fitting(choices), tr("what fits the way of building"));
}

// The part goes where the real cylinder is; layers that are cylinders get its axis.
void MainWindow::placeOnTouchedPoints() {
  if (!document_.source() || presenter_->partBox().isEmpty())
    return;
  TouchDialog dialog({0.0, 0.0}, this);
  if (dialog.exec() != QDialog::Accepted || !dialog.circle())
    return;
  const Eigen::Vector2d shift = dialog.shiftMm();
  project::Choices choices = document_.choices();
  // From where it lies now, whether by hand or by the way of building.
  choices.placement = placed();
  choices.placement.centreMm.y() += shift.x();
  choices.placement.liftMm += shift.y();
  if (const auto shape = choices.parameters.find("layerShape");
      shape != choices.parameters.end() && shape->second == "cylinder")
    choices.parameters["layerCentre"] = QStringLiteral("0,%1,%2")
                                            .arg(dialog.circle()->centre.x(), 0, 'g', 8)
                                            .arg(dialog.circle()->centre.y(), 0, 'g', 8)
                                            .toStdString();
  document_.setChoices(choices, tr("place on touched points"));
}

} // namespace voluta::window
