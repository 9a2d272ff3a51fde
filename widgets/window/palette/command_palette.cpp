#include "window/palette/command_palette.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

namespace voluta::window {

namespace {
constexpr QSize kSize(620, 420);
constexpr int kTopMargin = 60; // [px] below the window's upper edge
constexpr int kRowPadding = 8; // [px] above and below a row's text, together
enum Column { kName, kPlace, kKeys, kColumns };

bool startsAWord(const QString& text, const QString& word) {
  for (qsizetype at = text.indexOf(word, 0, Qt::CaseInsensitive); at >= 0;
       at = text.indexOf(word, at + 1, Qt::CaseInsensitive))
    if (at == 0 || !text[at - 1].isLetterOrNumber())
      return true;
  return false;
}

// Returns 0 for the best place of a word in an entry; none if it does not occur.
std::optional<int> rankOf(const PaletteEntry& entry, const QString& word) {
  if (entry.name.startsWith(word, Qt::CaseInsensitive))
    return 0;
  if (startsAWord(entry.name, word))
    return 1;
  if (entry.name.contains(word, Qt::CaseInsensitive))
    return 2;
  if (startsAWord(entry.meaning, word))
    return 4;
  if (entry.meaning.contains(word, Qt::CaseInsensitive) || startsAWord(entry.more, word))
    return 8;
  if (entry.more.contains(word, Qt::CaseInsensitive) ||
      entry.place.contains(word, Qt::CaseInsensitive))
    return 16;
  return {};
}
} // namespace

std::vector<const PaletteEntry*> found(const std::vector<PaletteEntry>& entries,
                                       const QStringList& words) {
  constexpr int kDisabled = 1000;
  std::vector<std::pair<int, const PaletteEntry*>> ranked;
  for (const PaletteEntry& entry : entries) {
    int rank = entry.enabled || words.isEmpty() ? 0 : kDisabled;
    const bool hasAll = std::ranges::all_of(words, [&](const QString& word) {
      const std::optional<int> one = rankOf(entry, word);
      rank += one.value_or(0);
      return one.has_value();
    });
    if (hasAll)
      ranked.emplace_back(rank, &entry);
  }
  std::ranges::stable_sort(ranked, {}, [](const auto& one) { return one.first; });
  std::vector<const PaletteEntry*> sorted;
  for (const auto& [rank, entry] : ranked)
    sorted.push_back(entry);
  return sorted;
}

CommandPalette::CommandPalette(std::vector<PaletteEntry> entries, QWidget* window)
    : QDialog(window, Qt::Dialog | Qt::FramelessWindowHint), entries_(std::move(entries)),
      search_(new QLineEdit(this)), list_(new QTreeWidget(this)), nothing_(new QLabel(this)) {
  setObjectName("commandPalette");
  setWindowTitle(tr("Commands and settings"));
  setAttribute(Qt::WA_DeleteOnClose);
  search_->setObjectName("paletteSearch");
  search_->setPlaceholderText(tr("Find a command or a setting"));
  search_->setAccessibleName(search_->placeholderText());
  search_->setClearButtonEnabled(true);
  QFont large = search_->font();
  large.setPointSizeF(1.2 * large.pointSizeF());
  search_->setFont(large);
  search_->installEventFilter(this);
  list_->setObjectName("paletteList");
  list_->setAccessibleName(windowTitle());
  list_->setFocusPolicy(Qt::NoFocus); // The keys go to the line above
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setHeaderHidden(true);
  list_->setColumnCount(kColumns);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(kPlace, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(kKeys, QHeaderView::ResizeToContents);
  nothing_->setAlignment(Qt::AlignCenter);
  nothing_->setText(tr("No command and no setting has these words."));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 10, 10, 10);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  column->addWidget(nothing_);
  connect(search_, &QLineEdit::textChanged, this, &CommandPalette::show);
  connect(search_, &QLineEdit::returnPressed, this, &CommandPalette::use);
  connect(list_, &QTreeWidget::itemClicked, this, &CommandPalette::use);
  show(QString());
}

void CommandPalette::show(const QString& text) {
  shown_ = found(entries_, text.split(QChar(' '), Qt::SkipEmptyParts));
  list_->clear();
  QList<QTreeWidgetItem*> items;
  const QBrush grey = palette().brush(QPalette::Disabled, QPalette::Text);
  const int height = fontMetrics().height() + kRowPadding;
  for (const PaletteEntry* entry : shown_) {
    auto* item = new QTreeWidgetItem({entry->name, entry->place, entry->keys});
    item->setSizeHint(kName, QSize(0, height));
    item->setForeground(kPlace, grey);
    item->setTextAlignment(kKeys, Qt::AlignRight | Qt::AlignVCenter);
    if (!entry->enabled)
      item->setForeground(kName, grey);
    items << item;
  }
  list_->addTopLevelItems(items);
  if (!items.isEmpty())
    list_->setCurrentItem(items.first());
  list_->setVisible(!items.isEmpty());
  nothing_->setVisible(items.isEmpty());
}

// The command runs once the dialog has given the focus back.
void CommandPalette::use() {
  const int row = list_->indexOfTopLevelItem(list_->currentItem());
  if (row < 0)
    return;
  const PaletteEntry& entry = *shown_[static_cast<std::size_t>(row)];
  if (!entry.enabled)
    return;
  QTimer::singleShot(0, parentWidget(), [does = entry.does] { does(); });
  accept();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == search_ && event->type() == QEvent::KeyPress)
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      QCoreApplication::sendEvent(list_, event);
      return true;
    default:
      break;
    }
  return QDialog::eventFilter(watched, event);
}

void CommandPalette::paintEvent(QPaintEvent* event) {
  QDialog::paintEvent(event);
  QPainter painter(this);
  painter.setPen(palette().mid().color());
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void CommandPalette::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  const QRect window = parentWidget()->window()->geometry();
  resize(kSize.boundedTo(window.size()));
  move(window.center().x() - width() / 2,
       window.top() + std::min(kTopMargin, (window.height() - height()) / 2));
  search_->setFocus();
}

} // namespace voluta::window
