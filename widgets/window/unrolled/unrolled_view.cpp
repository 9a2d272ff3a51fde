#include "window/unrolled/unrolled_view.h"

#include "plan/waypoints.h"
#include "window/background.h"
#include "window/unrolled/unrolled_canvas.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::window {

namespace {
QString kindName(plan::PathKind kind) {
  switch (kind) {
  case plan::PathKind::Wall:
    return UnrolledView::tr("Wall");
  case plan::PathKind::Infill:
    return UnrolledView::tr("Infill");
  case plan::PathKind::GapFill:
    return UnrolledView::tr("Gap fill");
  case plan::PathKind::Skirt:
    return UnrolledView::tr("Skirt or brim");
  case plan::PathKind::Support:
    return UnrolledView::tr("Support");
  case plan::PathKind::SparseInfill:
    return UnrolledView::tr("Sparse infill");
  case plan::PathKind::Bridge:
    return UnrolledView::tr("Bridge");
  case plan::PathKind::Tape:
    return UnrolledView::tr("Tape");
  case plan::PathKind::Shot:
    return UnrolledView::tr("Shot");
  case plan::PathKind::Prime:
    break;
  }
  return UnrolledView::tr("Prime");
}
} // namespace

UnrolledView::UnrolledView(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), place_(new QLabel(this)),
      canvas_(new UnrolledCanvas(this)) {
  title_->setObjectName("unrolledTitle");
  place_->setObjectName("unrolledPlace");
  canvas_->setObjectName("unrolledCanvas");
  place_->setWordWrap(true);
  place_->setMinimumHeight(2 * place_->fontMetrics().height());
  place_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->setSpacing(2);
  column->addWidget(title_);
  column->addWidget(canvas_, 1);
  column->addWidget(place_);
  connect(canvas_, &UnrolledCanvas::hovered, this, &UnrolledView::showPlace);
  connect(canvas_, &UnrolledCanvas::clicked, this, [this](const auto& hit) {
    emit chosen(hit ? std::optional(hit->waypoint) : std::nullopt);
  });
  retranslate();
}

UnrolledView::~UnrolledView() = default;

void UnrolledView::setPlan(std::shared_ptr<const layers::LayerStack> stack,
                           std::shared_ptr<const plan::ToolPlan> plan) {
  if (stack == stack_ && plan == plan_)
    return;
  stack_ = std::move(stack);
  plan_ = std::move(plan);
  layer_.reset();
  preparing_ = -1;
  runner_.cancel();
  chosen_.reset();
  prepare();
  refresh();
}

void UnrolledView::showLayer(int layer, std::size_t printedEnd, const QString& title) {
  title_->setText(title);
  wanted_ = layer;
  printedEnd_ = printedEnd;
  prepare();
  refresh();
}

void UnrolledView::choose(std::optional<std::size_t> waypoint) {
  chosen_ = waypoint;
  refresh();
}

bool UnrolledView::settled() const {
  return !runner_.running() && (!layer_ || layer_->layer == wanted_) && canvas_->settled();
}

// Prepares one layer at a time: while the slider moves, layers that would come too late are
// skipped.
void UnrolledView::prepare() {
  if (!isVisible() || !stack_ || wanted_ < 0 || runner_.running() ||
      (layer_ && layer_->layer == wanted_))
    return;
  preparing_ = wanted_;
  inBackground(
      runner_,
      [stack = stack_, plan = plan_, layer = wanted_](const base::RunContext& ctx) {
        return unrolledLayer(*stack, plan.get(), layer, ctx);
      },
      [this](std::shared_ptr<const UnrolledLayer>&& made) {
        layer_ = std::move(made);
        refresh();
        QMetaObject::invokeMethod(
            this, [this] { prepare(); }, Qt::QueuedConnection);
      });
}

void UnrolledView::refresh() {
  UnrolledContent content;
  content.layer = layer_;
  content.unprintedFrom = printedEnd_;
  if (const plan::ToolPath* path = chosen_ && plan_ ? plan::pathOf(*plan_, *chosen_) : nullptr)
    content.path = static_cast<std::size_t>(path - plan_->paths.data());
  canvas_->setContent(content);
  canvas_->setChosen(chosen_);
}

void UnrolledView::showPlace(const std::optional<QPointF>& mm,
                             const std::optional<UnrolledHit>& hit) {
  if (!mm || !layer_) {
    place_->clear();
    return;
  }
  const QLocale locale;
  const auto number = [&](double value, int digits) { return locale.toString(value, 'f', digits); };
  double around = mm->x();
  QString text;
  if (layer_->periodMm > 0.0) {
    around = std::remainder(around, layer_->periodMm);
    text = tr("Around %1 mm (%2°), along %3 mm")
               .arg(number(around, 2), number(360.0 * around / layer_->periodMm, 1),
                    number(mm->y(), 2));
  } else {
    text = tr("Around %1 mm, along %2 mm").arg(number(around, 2), number(mm->y(), 2));
  }
  if (hit && plan_) {
    const plan::ToolPath& path = plan_->paths[hit->path];
    text += QChar('\n') + tr("%1 %2, waypoint %3 of %4")
                              .arg(kindName(hit->kind))
                              .arg(hit->path + 1)
                              .arg(hit->waypoint - path.first + 1)
                              .arg(path.count);
  }
  place_->setText(text);
}

void UnrolledView::retranslate() {
  canvas_->setHint(tr("This layer is not wound around an axis."));
  canvas_->setAccessibleName(tr("Unrolled layer"));
  canvas_->setToolTip(tr("Click a path to find it in the 3D view. Wheel zooms, drag moves, "
                         "double click shows all."));
}

void UnrolledView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

void UnrolledView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  prepare();
}

} // namespace voluta::window
