#include "window/milling/mill_dialog.h"

#include "base/error.h"
#include "base/files.h"
#include "forms/dialog_buttons.h"
#include "forms/duration_text.h"
#include "forms/icons.h"
#include "forms/save_file.h"
#include "language/numbers.h"
#include "language/words.h"
#include "plan/finding.h"
#include "viewer/viewport.h"
#include "window/milling/mill_form.h"
#include "window/picture_area.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::window {

namespace {

constexpr int kSideWidth = 360;
constexpr double kMm3PerCm3 = 1000.0;

QString number(double value, int digits = 3) {
  return language::numberText(value, digits);
}

// A sample of a line's colour.
QIcon swatch(const scene::Colour& colour) {
  constexpr int kSize = 14, kThick = 4;
  QPixmap pixmap(kSize, kSize);
  pixmap.fill(Qt::transparent);
  QPainter(&pixmap).fillRect(0, (kSize - kThick) / 2, kSize, kThick,
                             QColor::fromRgbF(static_cast<float>(colour[0]),
                                              static_cast<float>(colour[1]),
                                              static_cast<float>(colour[2])));
  return pixmap;
}

QString verdictText(const milling::CutVerdict& verdict) {
  if (verdict.isComplete())
    return MillDialog::tr("Passed: the program was read back and run on the block.");
  const plan::Finding& first = verdict.findings.front();
  return (verdict.passed ? MillDialog::tr("Not complete: %1 (%2)")
                         : MillDialog::tr("Refused: %1 (%2)"))
      .arg(language::words(plan::reasonOf(first)), language::words(plan::remedyOf(first)));
}

} // namespace

struct MillDialog::Made {
  pipeline::MilledPart milled;
  MillPicture picture;
};

MillDialog::MillDialog(std::shared_ptr<const geometry::TriangleMesh> part, const QString& name,
                       QWidget* parent)
    : QDialog(parent), part_(std::move(part)), name_(name),
      viewport_(new viewer::Viewport(sceneTheme(palette()), this)),
      lines_(viewport_->scene().renderer()) {
  setObjectName("millDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Mill %1 from a block").arg(name_));
  build();
  viewport_->scene().setPart(scene::drawPart(*part_));
  showPicture();
  viewport_->frameAll();
  resize(1180, 760);
}

void MillDialog::build() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  save_ = buttons->addButton(tr("Save G-code…"), QDialogButtonBox::ActionRole);
  save_->setObjectName("millSave");
  compute_ = buttons->addButton(tr("Compute passes"), QDialogButtonBox::ActionRole);
  compute_->setObjectName("millCompute");
  connect(save_, &QPushButton::clicked, this, &MillDialog::save);
  connect(compute_, &QPushButton::clicked, this, [this] {
    if (settled())
      compute();
    else
      runner_.cancel();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  forms::keepOpenOnEnter(*buttons);
  save_->setEnabled(false);
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  connect(&runner_, &jobs::JobRunner::progressed, this, [this](const jobs::Progress& progress) {
    progress_->setValue(static_cast<int>(100.0 * progress.fraction));
  });
  auto* row = new QHBoxLayout;
  row->addWidget(viewport_, 1);
  row->addWidget(buildSide());
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(buttons);
}

QWidget* MillDialog::buildSide() {
  auto* content = new QWidget;
  form_ = new MillForm(content);
  connect(form_, &MillForm::changed, this, &MillDialog::valuesChanged);
  sign_ = new QLabel(content);
  sign_->setAlignment(Qt::AlignTop);
  figures_ = new QLabel(content);
  figures_->setObjectName("millFigures");
  figures_->setWordWrap(true);
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  figures_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* results = new QHBoxLayout;
  results->addWidget(sign_);
  results->addWidget(figures_, 1);
  auto* column = new QVBoxLayout(content);
  column->addWidget(form_);
  column->addWidget(buildLegend());
  column->addWidget(progress_);
  column->addLayout(results);
  column->addStretch(1);
  progress_->hide();
  auto* side = new QScrollArea(this);
  side->setFrameShape(QFrame::NoFrame);
  side->setWidgetResizable(true);
  side->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  side->setFixedWidth(kSideWidth);
  side->setWidget(content);
  return side;
}

// What the picture shows; the lines' colours are beside their names.
QWidget* MillDialog::buildLegend() {
  auto* legend = new QWidget(this);
  auto* grid = new QGridLayout(legend);
  grid->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const char* id, const QString& name, bool isOn, int row, int column) {
    auto* box = new QCheckBox(name, legend);
    box->setObjectName(id);
    box->setChecked(isOn);
    connect(box, &QCheckBox::toggled, this, &MillDialog::showPicture);
    grid->addWidget(box, row, column);
    return box;
  };
  showPart_ = add("millShowPart", tr("Part"), false, 0, 0);
  showMilled_ = add("millShowMilled", tr("Milled block"), true, 0, 1);
  static const char* const kIds[kMillLines] = {"millShowBlock",  "millShowRapid",  "millShowRoughA",
                                               "millShowFineA",  "millShowRoughB", "millShowFineB",
                                               "millShowContour"};
  for (std::size_t i = 0; i < kMillLines; ++i) {
    const auto which = static_cast<MillLines>(i);
    const int at = static_cast<int>(i);
    showLines_[i] =
        add(kIds[i], millLinesName(which), which == MillLines::Block, 1 + at / 2, at % 2);
    showLines_[i]->setIcon(swatch(millLinesColour(which)));
  }
  return legend;
}

void MillDialog::compute() {
  pipeline::MillOrder order = form_->order();
  order.name = name_.toStdString();
  isOutOfDate_ = true; // until it is done
  progress_->setValue(0);
  progress_->show();
  save_->setEnabled(false);
  compute_->setText(tr("Cancel"));
  say(tr("Computing the passes and running them on the block…"));
  runner_.run(
      [part = part_, order](const base::RunContext& ctx) {
        auto made = std::make_shared<Made>();
        made->milled = pipeline::millPart(*part, order, ctx);
        made->picture = pictureOf(made->milled);
        return std::shared_ptr<const Made>(std::move(made));
      },
      [this](base::Outcome<std::shared_ptr<const Made>> outcome) { take(std::move(outcome)); });
}

void MillDialog::take(base::Outcome<std::shared_ptr<const Made>> outcome) {
  progress_->hide();
  compute_->setText(tr("Compute passes"));
  if (const auto* made = std::get_if<std::shared_ptr<const Made>>(&outcome)) {
    made_ = *made;
    isOutOfDate_ = false;
    showPicture();
    viewport_->frameAll();
    showFigures();
  } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
    say(language::words(error->whole()), forms::Icon::Blocked);
  } else {
    say(tr("Cancelled."));
  }
}

void MillDialog::valuesChanged() {
  if (!settled())
    runner_.cancel();
  if (!made_)
    return;
  isOutOfDate_ = true;
  save_->setEnabled(false);
  say(tr("Values have changed: compute the passes again."), forms::Icon::Warning);
}

void MillDialog::showPicture() {
  for (QCheckBox* box : showLines_)
    box->setEnabled(made_ != nullptr);
  showPart_->setEnabled(made_ != nullptr);
  showMilled_->setEnabled(made_ != nullptr);
  scene::ViewState view;
  view.platform = false;
  if (made_) {
    const MillPicture& picture = made_->picture;
    view.part = showPart_->isChecked();
    view.otherParts = showMilled_->isChecked();
    viewport_->scene().setPart(picture.part);
    viewport_->scene().setOtherParts({picture.milled});
    std::vector<const scene::LineGroup*> shown;
    for (std::size_t i = 0; i < kMillLines; ++i)
      if (showLines_[i]->isChecked())
        shown.push_back(&picture.lines[i]);
    lines_.show(shown);
  }
  viewport_->setView(view);
}

void MillDialog::showFigures() {
  const pipeline::MilledPart& milled = made_->milled;
  const milling::CutVerdict& v = milled.verdict;
  const Eigen::Vector3d size = milled.plan.block.sizes();
  const double left = std::max(v.residueMm, v.sideResidueMm);
  const QStringList lines{
      verdictText(v),
      tr("Block %1 × %2 × %3 mm").arg(number(size.x()), number(size.y()), number(size.z())),
      tr("Time %1, %2 moves")
          .arg(forms::durationText(v.seconds),
               QLocale().toString(static_cast<qulonglong>(milled.motions))),
      tr("Removed %1 of %2 cm³")
          .arg(number(v.removedMm3 / kMm3PerCm3), number(size.prod() / kMm3PerCm3)),
      tr("Left on the part: at most %1 mm").arg(number(left)),
      tr("Missing from the part: at most %1 mm").arg(number(v.deepestMm, 2))};
  say(lines.join(QLatin1Char('\n')), v.isComplete() ? forms::Icon::Good : forms::Icon::Blocked);
  save_->setEnabled(v.passed);
}

void MillDialog::say(const QString& text, std::optional<forms::Icon> icon) {
  figures_->setText(text);
  if (icon)
    sign_->setPixmap(forms::iconBeside(*this, *icon));
  else
    sign_->clear();
}

void MillDialog::save() {
  const QString file =
      forms::saveFile(this, tr("Save the G-code"), name_ + ".nc", tr("G-code (*.nc)"));
  if (file.isEmpty() || !made_ || isOutOfDate_)
    return;
  try {
    base::writeFile(file.toStdString(), made_->milled.program);
    say(tr("Saved %1").arg(file), forms::Icon::Good);
  } catch (const base::Error& error) {
    QMessageBox::warning(this, windowTitle(), language::words(error.whole()));
  }
}

} // namespace voluta::window
