#include "panels/findings_panel.h"

#include "forms/colours.h"
#include "forms/discard.h"
#include "forms/icons.h"
#include "language/words.h"
#include "panels/effect_card.h"
#include "panels/findings_model.h"
#include "plan/finding_kinds.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace voluta::panels {

namespace {
constexpr int kMinRows = 1, kAmpleRows = 4; // of the list, on a small screen and elsewhere
constexpr int kMinWords = 2;                // lines for the text of the selected finding
constexpr std::size_t kBeyondLoad = 5;      // stages after Load, which check for printing problems

// Returns where the text after the tags begins.
int paintTags(QPainter& painter, const QRect& line, const QStringList& tags) {
  constexpr int kPadding = 4, kApart = 4;
  int x = line.left();
  for (const QString& tag : tags) {
    const QRect frame(x, line.top(), painter.fontMetrics().horizontalAdvance(tag) + 2 * kPadding,
                      line.height());
    if (frame.right() > line.right())
      break;
    painter.drawRoundedRect(QRectF(frame).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    painter.drawText(frame, Qt::AlignCenter, tag);
    x = frame.right() + kApart;
  }
  return x;
}

// Paints icon, reason, and a grey second line, preceded by the programs that it concerns.
class FindingDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {option.fontMetrics.averageCharWidth() * 20, 2 * option.fontMetrics.height() + 8};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& given,
             const QModelIndex& index) const override {
    QStyleOptionViewItem option(given);
    initStyleOption(&option, index);
    const QString reason = option.text;
    option.text.clear();
    const QStyle* style = option.widget->style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    const int side = option.fontMetrics.height();
    const QRect whole = option.rect.adjusted(6, 4, -6, -4);
    const int weight = index.data(FindingsModel::WeightRole).toInt();
    const bool outOfDate = index.data(FindingsModel::OutOfDateRole).toBool();
    forms::paintIcon(*painter, QRectF(whole.left(), whole.top(), side, side),
                     outOfDate                          ? forms::Icon::Pending
                     : weight == FindingsModel::Blocks  ? forms::Icon::Blocked
                     : weight == FindingsModel::Differs ? forms::Icon::Warning
                                                        : forms::Icon::Note,
                     option.palette);

    const bool selected = option.state & QStyle::State_Selected;
    const QRect text = whole.adjusted(side + 6, 0, 0, 0);
    const QRect top(text.left(), text.top(), text.width(), side);
    QRect bottom(text.left(), text.top() + side, text.width(), side);
    painter->save();
    painter->setFont(option.font);
    const QColor plain = selected    ? option.palette.color(QPalette::HighlightedText)
                         : outOfDate ? forms::mutedColour(option.palette)
                                     : option.palette.color(QPalette::Text);
    painter->setPen(plain);
    painter->drawText(top, Qt::AlignVCenter | Qt::AlignLeft,
                      option.fontMetrics.elidedText(reason, Qt::ElideRight, top.width()));
    painter->setPen(selected ? plain : forms::mutedColour(option.palette));
    bottom.setLeft(
        paintTags(*painter, bottom, index.data(FindingsModel::FormatsRole).toStringList()));
    const QString detail = index.data(FindingsModel::DetailRole).toString();
    painter->drawText(bottom, Qt::AlignVCenter | Qt::AlignLeft,
                      option.fontMetrics.elidedText(detail, Qt::ElideRight, bottom.width()));
    painter->restore();
  }
};

// That a program is not released is remedied with the findings that say why.
bool isRemediedByOthers(const plan::Finding& finding) {
  return finding.kind == plan::FindingKind::ProgramRefused;
}

QLabel* wrappedLabel(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setTextFormat(Qt::PlainText);
  return label;
}

// As high as its content at its width, if there is room: QScrollArea on its own assumes one line
// for word-wrapped text.
class FittedArea : public QScrollArea {
public:
  using QScrollArea::QScrollArea;

  QSize sizeHint() const override {
    const QSize narrow = QScrollArea::sizeHint();
    if (!widget() || !widget()->hasHeightForWidth())
      return narrow;
    const int inside = width() - 2 * frameWidth();
    return {narrow.width(), widget()->heightForWidth(inside) + 2 * frameWidth()};
  }
  QSize minimumSizeHint() const override {
    return {QScrollArea::minimumSizeHint().width(),
            std::min(sizeHint().height(), kMinWords * fontMetrics().height() + 8)};
  }

protected:
  void resizeEvent(QResizeEvent* event) override {
    QScrollArea::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
      updateGeometry();
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest)
      updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};
} // namespace

// In a narrow panel only the number is shown: the icon says what is counted.
class FindingsPanel::CountButton : public QToolButton {
public:
  explicit CountButton(QWidget* parent) : QToolButton(parent) {
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  }
  void setCount(const QString& words, const QString& number) {
    number_ = number;
    setText(words);
  }
  QSize minimumSizeHint() const override {
    const int less =
        fontMetrics().horizontalAdvance(text()) - fontMetrics().horizontalAdvance(number_);
    return sizeHint() - QSize(less, 0);
  }

protected:
  void paintEvent(QPaintEvent*) override {
    QStyleOptionToolButton option;
    initStyleOption(&option);
    if (width() < sizeHint().width())
      option.text = number_;
    QStylePainter(this).drawComplexControl(QStyle::CC_ToolButton, option);
  }

private:
  QString number_;
};

FindingsPanel::FindingsPanel(QWidget* parent) : QWidget(parent) {
  model_ = new FindingsModel(this);
  title_ = new QLabel(this);
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  blockedOnly_ = new CountButton(this);
  blockedOnly_->setObjectName(QStringLiteral("blockedOnly"));
  blockedOnly_->setCheckable(true);
  blockedOnly_->setIcon(forms::icon(forms::Icon::Blocked));
  connect(blockedOnly_, &QToolButton::toggled, this, [this](bool only) {
    model_->setBlockedOnly(only);
    showState();
    showCurrent();
  });

  list_ = new QListView(this);
  list_->setObjectName(QStringLiteral("list"));
  list_->setModel(model_);
  list_->setItemDelegate(new FindingDelegate(list_));
  list_->setUniformItemSizes(true);
  list_->setAlternatingRowColors(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->installEventFilter(this);
  connect(list_, &QListView::clicked, this, &FindingsPanel::activateCurrent);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &FindingsPanel::showCurrent);
  notChecked_ = wrappedLabel(this);
  notChecked_->setObjectName(QStringLiteral("notChecked"));
  notChecked_->setForegroundRole(QPalette::PlaceholderText);
  notChecked_->setContentsMargins(6, 0, 6, 0);
  effect_ = new EffectCard(this);
  effect_->setObjectName(QStringLiteral("effect"));
  empty_ = wrappedLabel(this);
  empty_->setObjectName(QStringLiteral("nothing"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setMargin(12);
  pages_ = new QStackedWidget(this);
  pages_->addWidget(list_);
  pages_->addWidget(empty_);

  details_ = new QWidget(this);
  details_->setObjectName(QStringLiteral("details"));
  reason_ = wrappedLabel(details_);
  where_ = wrappedLabel(details_);
  where_->setForegroundRole(QPalette::PlaceholderText);
  remedy_ = wrappedLabel(details_);
  auto* detailColumn = new QVBoxLayout(details_);
  detailColumn->setContentsMargins(6, 4, 6, 4);
  detailColumn->setSpacing(4);
  detailColumn->addWidget(reason_);
  detailColumn->addWidget(where_);
  detailColumn->addWidget(remedy_);
  whyNone_ = wrappedLabel(details_);
  whyNone_->setObjectName(QStringLiteral("whyNoRemedy"));
  whyNone_->setForegroundRole(QPalette::PlaceholderText);
  detailColumn->addWidget(whyNone_);
  applying_ = wrappedLabel(details_);
  applying_->setObjectName(QStringLiteral("applying"));
  detailColumn->addWidget(applying_);
  // On a small screen the text scrolls, but the remedy buttons stay visible.
  detailsArea_ = new FittedArea(this);
  detailsArea_->setWidgetResizable(true);
  detailsArea_->setFrameShape(QFrame::NoFrame);
  detailsArea_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  detailsArea_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  detailsArea_->setWidget(details_);
  actions_ = new QWidget(this);
  actions_->setObjectName(QStringLiteral("actions"));
  buttons_ = new QGridLayout(actions_);
  buttons_->setContentsMargins(6, 0, 6, 4);
  buttons_->setSpacing(4);
  show_ = new QPushButton(actions_);
  show_->setObjectName(QStringLiteral("show"));
  connect(show_, &QPushButton::clicked, this, &FindingsPanel::activateCurrent);

  auto* heading = new QHBoxLayout;
  heading->setContentsMargins(6, 0, 0, 0);
  heading->addWidget(title_, 1);
  heading->addWidget(blockedOnly_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2, 2, 2, 2);
  column->setSpacing(4);
  column->addLayout(heading);
  column->addWidget(notChecked_);
  column->addWidget(effect_);
  column->addWidget(pages_, 1);
  column->addWidget(detailsArea_);
  column->addWidget(actions_);
  retranslate();
  arrange();
}

void FindingsPanel::setFindings(const plan::Findings& findings, const plan::Findings& before,
                                bool hasPrograms) {
  const QModelIndex current = list_->currentIndex();
  const std::optional<plan::Finding> chosen =
      current.isValid() ? std::optional(model_->finding(current.row())) : std::nullopt;
  model_->setFindings(findings, before, hasPrograms);
  showState();
  if (chosen)
    for (int row = 0; row < model_->rowCount(); ++row)
      if (plan::reasonOf(model_->finding(row)) == plan::reasonOf(*chosen)) {
        list_->setCurrentIndex(model_->index(row)); // shows it
        return;
      }
  showCurrent();
}

void FindingsPanel::setRemedies(RemedySource remedies) {
  remedies_ = std::move(remedies);
  showCurrent();
}

void FindingsPanel::setPlanned(bool planned) {
  planned_ = planned;
  showState();
}

void FindingsPanel::setUnchecked(const std::vector<plan::Stage>& stages) {
  unchecked_ = stages;
  showState();
}

QString FindingsPanel::uncheckedText() const {
  QStringList names;
  for (const plan::Stage stage : unchecked_)
    names << language::words(plan::stageLabel(stage));
  return names.isEmpty() ? QString() : tr("Not checked: %1.").arg(names.join(QStringLiteral(", ")));
}

void FindingsPanel::setParts(const QStringList& names) {
  model_->setParts(names);
}

void FindingsPanel::setBlockedOnly(bool only) {
  blockedOnly_->setChecked(only);
}

void FindingsPanel::activateCurrent() {
  if (const QModelIndex current = list_->currentIndex(); current.isValid()) {
    const plan::Findings& places = model_->places(current.row());
    if (std::exchange(isPlaceShown_, true)) // The next click goes to the next place
      place_ = (place_ + 1) % places.size();
    showPlace(current.row());
    const plan::Finding finding = places[place_]; // A copy: a slot may set other findings
    emit activated(finding);
  }
}

void FindingsPanel::showCurrent() {
  const QModelIndex current = list_->currentIndex();
  detailsArea_->setVisible(current.isValid());
  actions_->setVisible(current.isValid());
  if (!current.isValid()) {
    arrange();
    return;
  }
  const plan::Finding& finding = model_->finding(current.row());
  reason_->setText(model_->reason(current.row()));
  place_ = 0;
  isPlaceShown_ = false;
  showPlace(current.row());
  const QString remedy = FindingsModel::remedyText(finding);
  remedy_->setText(tr("What helps: %1").arg(remedy));
  show_->setEnabled(finding.where || finding.whenS);
  showRemedies(finding);
  remedy_->setVisible(!remedy.isEmpty() && !isRemediedByOthers(finding));
  applying_->setVisible(!remedyButtons_.empty());
  showWhyNone(finding);
  arrange();
}

void FindingsPanel::showPlace(int row) {
  const plan::Findings& places = model_->places(row);
  QStringList parts;
  if (places.size() > 1) {
    const auto shown = [](std::size_t n) { return QLocale().toString(static_cast<qulonglong>(n)); };
    parts << tr("Place %1 of %2").arg(shown(place_ + 1), shown(places.size()));
  }
  parts << model_->detail(places[place_]);
  where_->setText((parts + model_->formats(row)).join(QStringLiteral(" · ")));
  show_->setText(places.size() > 1 ? tr("Show next") : tr("Show"));
}

// For a blocking finding without a remedy, shows why there is none.
void FindingsPanel::showWhyNone(const plan::Finding& finding) {
  const base::Text why = plan::rowOf(finding.kind).whyNoRemedy;
  whyNone_->setVisible(finding.blocking && remedyButtons_.empty() && !why.empty() &&
                       !isRemediedByOthers(finding));
  whyNone_->setText(language::heading(why) + QLatin1Char('.'));
}

int FindingsPanel::heightOfRows(int rows) const {
  return rows * (2 * fontMetrics().height() + 8) + 2 * list_->frameWidth();
}

QSize FindingsPanel::minimumSizeHint() const {
  return {QWidget::minimumSizeHint().width(), heightBesideList() + heightOfRows(kMinRows)};
}

// Computed here because the layout's size hint is outdated while widgets are added and removed.
int FindingsPanel::heightBesideList() const {
  const QMargins margins = layout()->contentsMargins();
  std::vector<int> heights{layout()->itemAt(0)->minimumSize().height()};
  if (!notChecked_->isHidden())
    heights.push_back(notChecked_->heightForWidth(width() - margins.left() - margins.right()));
  if (!detailsArea_->isHidden())
    heights.insert(heights.end(), {detailsArea_->minimumSizeHint().height(),
                                   buttons_->totalMinimumSize().height()});
  int sum = margins.top() + margins.bottom();
  for (const int height : heights)
    sum += height + layout()->spacing();
  return sum;
}

// Two buttons per line if both fit, and as many rows of the list as leave room for text and
// buttons.
void FindingsPanel::arrange() {
  std::vector<QPushButton*> all = remedyButtons_;
  all.push_back(show_);
  int widest = 0;
  for (QPushButton* button : all) {
    buttons_->removeWidget(button);
    widest = std::max(widest, button->sizeHint().width());
  }
  const QMargins margins = buttons_->contentsMargins();
  const int wide =
      width() - 2 * layout()->contentsMargins().left() - margins.left() - margins.right();
  const int columns = 2 * widest + buttons_->spacing() <= wide ? 2 : 1;
  for (std::size_t i = 0; i < all.size(); ++i)
    buttons_->addWidget(all[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
  QWidget* before = detailsArea_;
  for (QPushButton* button : all) {
    setTabOrder(before, button); // otherwise a new button would be last in the window's tab order
    before = button;
  }
  const int row = heightOfRows(1) - heightOfRows(0);
  const int room = height() - heightBesideList() - heightOfRows(0);
  const int rows = std::clamp(room / row, kMinRows, kAmpleRows);
  list_->setMinimumHeight(heightOfRows(rows));
}

void FindingsPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

// Keeps buttons with unchanged texts: one of them may be pressed by the mouse.
void FindingsPanel::showRemedies(const plan::Finding& finding) {
  const std::vector<RemedyButton> wanted =
      remedies_ ? remedies_(finding) : std::vector<RemedyButton>{};
  if (wanted == shownRemedies_)
    return;
  shownRemedies_ = wanted;
  for (QPushButton* button : remedyButtons_)
    forms::discard(button);
  remedyButtons_.clear();
  for (const RemedyButton& remedy : wanted) {
    auto* button = new QPushButton(remedy.label, actions_);
    button->setObjectName(QStringLiteral("remedy_") + remedy.id);
    button->setToolTip(remedy.help);
    connect(button, &QPushButton::clicked, this, [this, id = remedy.id] { chooseRemedy(id); });
    button->show();
    remedyButtons_.push_back(button);
  }
}

void FindingsPanel::chooseRemedy(const QString& id) {
  if (const QModelIndex current = list_->currentIndex(); current.isValid()) {
    const plan::Finding finding = model_->finding(current.row());
    emit remedyChosen(finding, id);
  }
}

void FindingsPanel::showState() {
  const QLocale locale;
  const auto count = [&](std::size_t n) { return locale.toString(static_cast<qulonglong>(n)); };
  title_->setText(model_->total() == 0 ? tr("Findings")
                                       : tr("Findings (%1)").arg(count(model_->total())));
  const std::size_t blocking = model_->blocking(), differing = model_->differing();
  const QString informing = count(model_->total() - blocking - differing);
  title_->setToolTip(differing == 0
                         ? tr("%1 blocking, %2 for information").arg(count(blocking), informing)
                         : tr("%1 blocking, %2 not as asked, %3 for information")
                               .arg(count(blocking), count(differing), informing));
  blockedOnly_->setEnabled(model_->total() > 0);
  const bool isAmber = blocking == 0 && differing > 0;
  blockedOnly_->setIcon(forms::icon(isAmber ? forms::Icon::Warning : forms::Icon::Blocked));
  blockedOnly_->setCount(
      isAmber ? tr("Not as asked (%1)").arg(count(differing))
      : differing == 0
          ? tr("Blocked (%1)").arg(count(blocking))
          : tr("Blocked (%1), not as asked (%2)").arg(count(blocking), count(differing)),
      count(isAmber ? differing : blocking));
  if (model_->rowCount() > 0)
    pages_->setCurrentWidget(list_);
  else
    pages_->setCurrentWidget(empty_);
  const QString unchecked = planned_ ? uncheckedText() : QString();
  notChecked_->setText(unchecked);
  notChecked_->setVisible(!unchecked.isEmpty() && model_->rowCount() > 0);
  empty_->setText(model_->total() > 0   ? tr("No blocking findings.")
                  : !planned_           ? tr("No findings yet.")
                  : unchecked.isEmpty() ? tr("No problems found.")
                  : unchecked_.size() < kBeyondLoad
                      ? tr("No problems found so far.") + QLatin1Char('\n') + unchecked
                      : unchecked);
  arrange();
}

void FindingsPanel::retranslate() {
  blockedOnly_->setToolTip(tr("Show only findings that block, or by which the part differs"));
  applying_->setText(tr("Apply and plan:"));
  show_->setToolTip(tr("Move the camera, the sliders and the robot there"));
  list_->setAccessibleName(tr("Findings"));
  model_->retranslate();
  showState();
  showCurrent();
}

void FindingsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

bool FindingsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      activateCurrent();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

} // namespace voluta::panels
