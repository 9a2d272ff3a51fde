#include "panels/compare_table.h"

#include "base/error.h"
#include "forms/colours.h"
#include "forms/icons.h"

#include <QAbstractTableModel>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

namespace voluta::panels {

namespace {
enum Column { Place, Strategy, FirstFigure };
enum Role { EntryRole = Qt::UserRole };
constexpr int kPictureWidth = 88, kPictureHeight = 66, kMargin = 6, kGap = 8, kLineGap = 3;
constexpr int kMinText = 92;    // of the column that names the way
constexpr int kMaxText = 220;   // longer names are elided
constexpr int kAmpleText = 120; // wider than this: the rest goes to the figures
constexpr int kMaxSpare = 28;

forms::Icon iconOf(CompareState state) {
  switch (state) {
  case CompareState::Clear:
    return forms::Icon::Good;
  case CompareState::Blocked:
    return forms::Icon::Blocked;
  case CompareState::Failed:
    return forms::Icon::Warning;
  default:
    return forms::Icon::Pending;
  }
}

const CompareEntry& entryAt(const QModelIndex& index) {
  return *static_cast<const CompareEntry*>(index.data(EntryRole).value<const void*>());
}

QString placeText(const CompareEntry& entry) {
  return entry.place > 0 ? QString::number(entry.place) : QStringLiteral("–");
}

// Paints the two columns that contain more than a text.
class EntryDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& given,
             const QModelIndex& index) const override {
    QStyleOptionViewItem option(given);
    initStyleOption(&option, index);
    option.text.clear();
    option.widget->style()->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    if (index.column() == Place)
      paintPlace(*painter, option, entryAt(index));
    else
      paintStrategy(*painter, option, entryAt(index));
    painter->restore();
  }

private:
  static QColor textColour(const QStyleOptionViewItem& option, bool muted) {
    if (option.state & QStyle::State_Selected)
      return option.palette.color(QPalette::HighlightedText);
    return muted ? forms::mutedColour(option.palette) : option.palette.color(QPalette::Text);
  }

  static void paintPlace(QPainter& painter, const QStyleOptionViewItem& option,
                         const CompareEntry& entry) {
    if (entry.best)
      painter.fillRect(QRect(option.rect.left(), option.rect.top(), 4, option.rect.height() - 1),
                       forms::goodColour(option.palette));
    QFont large = option.font, bold = option.font;
    large.setBold(true);
    large.setPointSizeF(large.pointSizeF() * 1.3);
    bold.setBold(true);
    struct Line {
      QString text;
      QFont font;
      QColor colour;
    };
    std::vector<Line> lines{{placeText(entry), large, textColour(option, entry.place == 0)}};
    if (entry.score)
      lines.push_back(
          {QLocale().toString(*entry.score, 'f', 2), option.font, textColour(option, true)});
    if (entry.best)
      lines.push_back({CompareTable::tr("Best"), bold,
                       option.state & QStyle::State_Selected ? textColour(option, false)
                                                             : forms::goodColour(option.palette)});
    if (entry.inUse)
      lines.push_back({CompareTable::tr("In use"), option.font, textColour(option, true)});
    int height = 0;
    for (const Line& line : lines)
      height += QFontMetrics(line.font).height() + kLineGap;
    int y = option.rect.center().y() - height / 2;
    for (const Line& line : lines) {
      const int own = QFontMetrics(line.font).height();
      painter.setFont(line.font);
      painter.setPen(line.colour);
      painter.drawText(QRect(option.rect.left() + 4, y, option.rect.width() - 4, own),
                       Qt::AlignCenter, line.text);
      y += own + kLineGap;
    }
  }

  static void paintStrategy(QPainter& painter, const QStyleOptionViewItem& option,
                            const CompareEntry& entry) {
    const QRect r = option.rect.adjusted(kMargin, kMargin, -kMargin, -kMargin);
    const QRect frame(r.left(), r.center().y() - kPictureHeight / 2, kPictureWidth, kPictureHeight);
    if (!entry.picture.isNull())
      painter.drawImage(frame, entry.picture);
    painter.setPen(QPen(option.palette.color(QPalette::Mid), 1,
                        entry.picture.isNull() ? Qt::DotLine : Qt::SolidLine));
    painter.drawRect(QRectF(frame).adjusted(0.5, 0.5, -0.5, -0.5));

    const int line = QFontMetrics(option.font).height(), step = line + kLineGap;
    const int left = frame.right() + 1 + kGap, width = r.right() - left + 1;
    int y = r.center().y() - ((entry.growth.isEmpty() ? 3 : 4) * step - kLineGap) / 2;
    const auto write = [&](const QString& text, bool strong, bool muted, int indent) {
      QFont font = option.font;
      font.setBold(strong);
      painter.setFont(font);
      painter.setPen(textColour(option, muted));
      painter.drawText(QRect(left + indent, y, width - indent, line),
                       Qt::AlignVCenter | Qt::AlignLeft,
                       QFontMetrics(font).elidedText(text, Qt::ElideRight, width - indent));
      y += step;
    };
    write(entry.strategy, true, false, 0);
    if (!entry.growth.isEmpty())
      write(entry.growth, false, true, 0);
    write(entry.platform, false, true, 0);
    forms::paintIcon(painter, QRectF(left, y, line, line), iconOf(entry.state), option.palette);
    write(entry.verdict, false, false, line + 5);
  }
};
} // namespace

class CompareTable::Model : public QAbstractTableModel {
public:
  using QAbstractTableModel::QAbstractTableModel;

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(entries_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : FirstFigure + static_cast<int>(heads_.size());
  }
  QVariant data(const QModelIndex& index, int role) const override {
    const CompareEntry& entry = entries_[static_cast<std::size_t>(index.row())];
    switch (role) {
    case EntryRole:
      return QVariant::fromValue(static_cast<const void*>(&entry));
    case Qt::ToolTipRole:
      return entry.tip.isEmpty() ? QVariant() : QVariant(entry.tip);
    case Qt::TextAlignmentRole:
      return index.column() >= FirstFigure ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                           : QVariant();
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      if (index.column() == Place)
        return placeText(entry);
      if (index.column() == Strategy) {
        QStringList parts{entry.strategy, entry.growth, entry.platform, entry.verdict};
        parts.removeAll(QString());
        return parts.join(QStringLiteral(", "));
      }
      if (const auto at = static_cast<std::size_t>(index.column() - FirstFigure);
          at < entry.figures.size())
        return entry.figures[at];
      return {};
    default:
      return {};
    }
  }
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (orientation != Qt::Horizontal)
      return {};
    if (role == Qt::TextAlignmentRole)
      return section >= FirstFigure ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
             : section == Strategy  ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                    : QVariant(Qt::AlignCenter);
    if (role == Qt::ToolTipRole && section == Place)
      return CompareTable::tr("Rank, and the score below it: lower is better");
    if (role != Qt::DisplayRole)
      return {};
    return section == Place      ? CompareTable::tr("Place")
           : section == Strategy ? CompareTable::tr("Way of building")
                                 : heads_[static_cast<std::size_t>(section - FirstFigure)];
  }

  void setHeads(const std::vector<QString>& heads) {
    beginResetModel();
    heads_ = heads;
    endResetModel();
  }
  void setEntries(std::vector<CompareEntry> entries) {
    beginResetModel();
    entries_ = std::move(entries);
    endResetModel();
  }
  void setEntry(int row, const CompareEntry& entry) {
    entries_[static_cast<std::size_t>(row)] = entry;
    emit dataChanged(index(row, 0), index(row, columnCount() - 1));
  }
  void updateEntries(std::vector<CompareEntry> entries) {
    entries_ = std::move(entries);
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  }
  const std::vector<CompareEntry>& entries() const { return entries_; }

private:
  std::vector<QString> heads_;
  std::vector<CompareEntry> entries_;
};

CompareTable::CompareTable(QWidget* parent) : QTableView(parent), model_(new Model(this)) {
  setModel(model_);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setShowGrid(false);
  setAlternatingRowColors(true);
  setWordWrap(false);
  setFrameShape(QFrame::NoFrame);
  setTabKeyNavigation(false);
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(
      std::max(kPictureHeight, 4 * (fontMetrics().height() + kLineGap)) + 2 * kMargin);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionsClickable(false);
  setItemDelegateForColumn(Place, new EntryDelegate(this));
  setItemDelegateForColumn(Strategy, new EntryDelegate(this));
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { emit rowSelected(selectedRow()); });
  connect(this, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { emit rowActivated(index.row()); });
}

void CompareTable::setFigures(const std::vector<QString>& heads) {
  model_->setHeads(heads);
  layColumns();
}

void CompareTable::setEntries(std::vector<CompareEntry> entries) {
  model_->setEntries(std::move(entries));
  layColumns();
  emit rowSelected(-1);
}

const std::vector<CompareEntry>& CompareTable::entries() const {
  return model_->entries();
}

void CompareTable::setEntry(int row, const CompareEntry& entry) {
  model_->setEntry(row, entry);
  layColumns();
}

void CompareTable::updateEntries(std::vector<CompareEntry> entries) {
  base::require(entries.size() == this->entries().size(), "CompareTable: the same rows");
  if (entries.empty())
    return;
  model_->updateEntries(std::move(entries));
  layColumns();
}

int CompareTable::selectedRow() const {
  const QModelIndexList rows = selectionModel()->selectedRows();
  return rows.isEmpty() ? -1 : rows.first().row();
}

// Figures are as wide as needed, a little wider if there is room; the way of building gets the
// rest.
void CompareTable::layColumns() {
  QHeaderView* head = horizontalHeader();
  head->setSectionResizeMode(QHeaderView::Fixed);
  const int columns = model_->columnCount(), figures = columns - FirstFigure;
  std::vector<int> widths(static_cast<std::size_t>(columns), 0);
  int left = viewport()->width();
  for (int column = 0; column < columns; ++column) {
    int& wide = widths[static_cast<std::size_t>(column)];
    if (column != Strategy)
      wide = std::max(head->sectionSizeHint(column), sizeHintForColumn(column));
    if (column == Place)
      wide = std::max(wide, fontMetrics().horizontalAdvance(tr("In use")) + 2 * kMargin);
    left -= wide;
  }
  QFont bold = font();
  bold.setBold(true);
  int text = kMinText;
  for (const CompareEntry& entry : entries())
    text = std::max(text, QFontMetrics(bold).horizontalAdvance(entry.strategy));
  const int minWidth = kPictureWidth + kGap + 2 * kMargin + std::min(text, kMaxText);
  const int spare =
      figures > 0 ? std::clamp((left - minWidth - kAmpleText) / figures, 0, kMaxSpare) : 0;
  for (int column = 0; column < columns; ++column)
    if (column != Strategy)
      head->resizeSection(column, widths[static_cast<std::size_t>(column)] +
                                      (column >= FirstFigure ? spare : 0));
  head->resizeSection(Strategy, std::max(left - spare * figures, minWidth));
}

void CompareTable::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  layColumns();
}

void CompareTable::changeEvent(QEvent* event) {
  QTableView::changeEvent(event);
  if (event->type() == QEvent::FontChange && model_)
    layColumns();
}

void CompareTable::keyPressEvent(QKeyEvent* event) {
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && selectedRow() >= 0)
    emit rowActivated(selectedRow());
  else
    QTableView::keyPressEvent(event);
}

} // namespace voluta::panels
