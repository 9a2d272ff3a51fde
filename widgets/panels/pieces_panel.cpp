#include "panels/pieces_panel.h"

#include "forms/colours.h"
#include "forms/discard.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace voluta::panels {

namespace {
constexpr int kPiece = 0, kVolume = 1, kRisky = 2, kMaterial = 3;
constexpr int kExplodeSteps = 100, kSwatch = 12;
constexpr int kMinRows = 4, kMaxRows = 9;

QIcon swatch(const QColor& colour) {
  QPixmap picture(kSwatch, kSwatch);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(colour.darker(130));
  painter.setBrush(colour);
  painter.drawRoundedRect(QRectF(0.5, 0.5, kSwatch - 1.0, kSwatch - 1.0), 2, 2);
  QIcon icon(picture);
  icon.addPixmap(picture, QIcon::Selected); // not tinted: it is the piece's colour
  return icon;
}

QString areaText(double mm2) {
  return QStringLiteral("%1 mm²").arg(
      QLocale().toString(mm2, 'f', mm2 < 0.05 || mm2 >= 10.0 ? 0 : 1));
}
} // namespace

PiecesPanel::PiecesPanel(QWidget* parent) : QWidget(parent) {
  build();
  retranslate();
}

void PiecesPanel::build() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 8);
  tree_ = new QTreeWidget(this);
  tree_->setObjectName("pieceTree");
  tree_->setColumnCount(4);
  tree_->setUniformRowHeights(true);
  tree_->setIndentation(12);
  tree_->setIconSize({kSwatch, kSwatch});
  tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setMinimumSectionSize(20);
  for (const int fits : {kVolume, kRisky, kMaterial})
    tree_->header()->setSectionResizeMode(fits, QHeaderView::ResizeToContents);
  tree_->header()->setSectionResizeMode(kPiece, QHeaderView::Stretch);
  total_ = new QLabel(this);
  total_->setObjectName("pieceTotal");
  total_->setWordWrap(true);
  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  explodeLabel_ = new QLabel(this);
  explode_ = new QSlider(Qt::Horizontal, this);
  explode_->setObjectName("explode");
  explode_->setRange(0, kExplodeSteps);
  grid->addWidget(explodeLabel_, 0, 0);
  grid->addWidget(explode_, 0, 1);
  numbers_ = new QCheckBox(this);
  numbers_->setObjectName("pieceNumbers");
  numbers_->setChecked(true);
  planes_ = new QCheckBox(this);
  planes_->setObjectName("basePlanes");
  hint_ = new QLabel(this);
  hint_->setObjectName("pieceHint");
  hint_->setWordWrap(true);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  cuts_ = new QPushButton(this);
  cuts_->setObjectName("pieceCuts");
  root_ = new QPushButton(this);
  root_->setObjectName("pickRoot");
  root_->setCheckable(true);
  root_->hide();
  auto* buttons = new QVBoxLayout; // side by side they would not fit into a narrow panel
  buttons->addWidget(cuts_, 0, Qt::AlignLeft);
  buttons->addWidget(root_, 0, Qt::AlignLeft);
  column->addWidget(tree_);
  column->addWidget(total_);
  column->addLayout(grid);
  auto* boxes = new QVBoxLayout;
  boxes->addWidget(numbers_);
  boxes->addWidget(planes_);
  column->addLayout(boxes);
  column->addWidget(hint_);
  column->addLayout(buttons);
  connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (filling_)
      return;
    selected_ = item ? item->data(kPiece, Qt::UserRole).toInt() : -1;
    emit selectionChanged(selected_);
  });
  connect(explode_, &QSlider::valueChanged, this, &PiecesPanel::viewChanged);
  connect(explode_, &QSlider::sliderPressed, this, [this] { emit dragging(true); });
  connect(explode_, &QSlider::sliderReleased, this, [this] { emit dragging(false); });
  for (QCheckBox* box : {numbers_, planes_})
    connect(box, &QCheckBox::toggled, this, &PiecesPanel::viewChanged);
  connect(cuts_, &QPushButton::clicked, this, [this] {
    if (own_)
      emit searchRequested();
    else
      emit keepCutsRequested();
  });
  connect(root_, &QPushButton::toggled, this, &PiecesPanel::rootPicking);
}

void PiecesPanel::setPieces(std::vector<PieceRow> pieces, double riskyBeforeMm2) {
  rows_ = std::move(pieces);
  before_ = riskyBeforeMm2;
  estimated_ = false;
  fill();
  showTotal();
}

void PiecesPanel::fill() {
  filling_ = true;
  forms::discardRows(*tree_);
  items_.clear();
  selected_ = -1;
  const QLocale locale;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const PieceRow& row = rows_[i];
    // A piece comes after its parent.
    const bool stands = row.parent >= 0 && row.parent < static_cast<int>(i);
    auto* item = stands ? new QTreeWidgetItem(items_[static_cast<std::size_t>(row.parent)])
                        : new QTreeWidgetItem(tree_);
    items_.push_back(item);
    item->setData(kPiece, Qt::UserRole, static_cast<int>(i));
    item->setIcon(kPiece, swatch(row.colour));
    item->setText(kPiece, QString::number(i + 1));
    item->setToolTip(kPiece,
                     stands ? tr("Printed as number %1, on piece %2").arg(i + 1).arg(row.parent + 1)
                            : tr("Printed as number %1, on the plate").arg(i + 1));
    item->setText(kVolume,
                  QStringLiteral("%1 cm³").arg(locale.toString(row.volumeMm3 / 1000.0, 'f', 2)));
    item->setText(kRisky, areaText(row.riskyMm2));
    item->setText(kMaterial, row.material);
    for (const int number : {kVolume, kRisky})
      item->setTextAlignment(number, Qt::AlignRight | Qt::AlignVCenter);
    item->setForeground(kRisky, row.riskyMm2 >= 0.05 ? palette().color(QPalette::Text)
                                                     : forms::mutedColour(palette()));
  }
  tree_->expandAll();
  const int shown = std::clamp(static_cast<int>(rows_.size()), kMinRows, kMaxRows);
  const int row = std::max(tree_->sizeHintForRow(0), fontMetrics().height() + 4);
  tree_->setFixedHeight(tree_->header()->sizeHint().height() + shown * row +
                        2 * tree_->frameWidth());
  filling_ = false;
}

void PiecesPanel::select(int piece) {
  filling_ = true;
  selected_ = piece >= 0 && piece < static_cast<int>(items_.size()) ? piece : -1;
  tree_->setCurrentItem(selected_ < 0 ? nullptr : items_[static_cast<std::size_t>(selected_)]);
  if (selected_ < 0)
    tree_->clearSelection();
  filling_ = false;
}

void PiecesPanel::setOwnCuts(bool own) {
  own_ = own;
  retranslate();
}

void PiecesPanel::setHandles(bool there) {
  handles_ = there;
  showHint();
}

void PiecesPanel::showHint() {
  if (selected_ < 0)
    hint_->setText(tr("Click a piece to see its base plane and to move that cut."));
  else if (handles_)
    hint_->setText(tr("Drag the arrow to move the cut, a ring to tilt it. Esc deselects."));
  else
    hint_->setText(tr("This piece is on the plate: it has no cut to move."));
}

void PiecesPanel::setEstimate(const CutEstimate& estimate) {
  estimate_ = estimate;
  estimated_ = true;
  showTotal();
}

void PiecesPanel::clearEstimate() {
  estimated_ = false;
  showTotal();
}

void PiecesPanel::setRootOffered(bool offered) {
  root_->setVisible(offered);
}

void PiecesPanel::setPickingRoot(bool picking) {
  const QSignalBlocker quiet(root_);
  root_->setChecked(picking);
}

void PiecesPanel::setExplodeShare(double share) {
  explode_->setValue(static_cast<int>(std::lround(share * kExplodeSteps)));
}

double PiecesPanel::explodeShare() const {
  return static_cast<double>(explode_->value()) / kExplodeSteps;
}

bool PiecesPanel::basePlanes() const {
  return planes_->isChecked();
}

bool PiecesPanel::numbers() const {
  return numbers_->isChecked();
}

void PiecesPanel::showTotal() {
  double risky = 0.0;
  for (const PieceRow& row : rows_)
    risky += row.riskyMm2;
  if (!estimated_)
    total_->setText(tr("Needs support: %1, uncut %2").arg(areaText(risky), areaText(before_)));
  else if (!estimate_.problem.isEmpty())
    total_->setText(estimate_.problem);
  else if (estimate_.exact)
    total_->setText(
        tr("With this cut: %1 need support. Press Plan.").arg(areaText(estimate_.riskyMm2)));
  else
    total_->setText(tr("With this cut: about %1 need support").arg(areaText(estimate_.riskyMm2)));
}

void PiecesPanel::retranslate() {
  tree_->setHeaderLabels({tr("Piece"), tr("Volume"), tr("Risky"), tr("Material")});
  tree_->headerItem()->setTextAlignment(kVolume, Qt::AlignRight | Qt::AlignVCenter);
  tree_->headerItem()->setTextAlignment(kRisky, Qt::AlignRight | Qt::AlignVCenter);
  tree_->headerItem()->setToolTip(
      kPiece, tr("In print order; each piece is listed below the one it is printed on"));
  tree_->headerItem()->setToolTip(
      kRisky, tr("Area that needs support when the piece is printed from its base"));
  explodeLabel_->setText(tr("Apart"));
  explode_->setToolTip(tr("Moves each piece away from the one it is printed on"));
  numbers_->setText(tr("Numbers"));
  numbers_->setToolTip(tr("In the picture, in print order"));
  planes_->setText(tr("Base planes"));
  planes_->setToolTip(tr("Shows where each piece is cut"));
  showHint();
  cuts_->setText(own_ ? tr("Search again") : tr("Keep these cuts"));
  cuts_->setToolTip(own_ ? tr("Discards your cuts and searches for others")
                         : tr("Keeps these cuts: they become your own and are not searched again"));
  root_->setText(tr("Pick root"));
  root_->setToolTip(tr("Then click a point on the piece to print first"));
  showTotal();
}

void PiecesPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
    const int kept = selected_;
    retranslate();
    fill();
    select(kept);
  }
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
