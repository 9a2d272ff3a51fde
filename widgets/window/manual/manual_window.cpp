#include "window/manual/manual_window.h"

#include "window/manual/manual_pages.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTextBrowser>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

namespace voluta::window {

namespace {

constexpr int kUrl = Qt::UserRole;
constexpr QSize kSize(1000, 700);
constexpr int kContentsWidth = 260;

// Shows the pages that are made from tables beside those that are compiled in.
class Browser : public QTextBrowser {
public:
  using QTextBrowser::QTextBrowser;
  QVariant loadResource(int type, const QUrl& name) override {
    const QString made = madePage(name);
    return made.isEmpty() ? QTextBrowser::loadResource(type, name) : QVariant(made);
  }
};

// Returns whether a page has all words, in any order and case.
bool hasWords(const QString& page, const QStringList& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return page.contains(word, Qt::CaseInsensitive); });
}

} // namespace

ManualWindow::ManualWindow(QWidget* parent) : QDialog(parent) {
  setObjectName("manualWindow");
  setAttribute(Qt::WA_DeleteOnClose);
  search_ = new QLineEdit(this);
  search_->setObjectName("manualSearch");
  search_->setClearButtonEnabled(true);
  contents_ = new QTreeWidget(this);
  contents_->setObjectName("manualContents");
  contents_->setHeaderHidden(true);
  text_ = new Browser(this);
  text_->setObjectName("manualText");
  text_->setOpenExternalLinks(true);
  auto* split = new QSplitter(this);
  auto* left = new QWidget(split);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(search_);
  column->addWidget(contents_, 1);
  split->addWidget(left);
  split->addWidget(text_);
  split->setStretchFactor(1, 1);
  split->setSizes({kContentsWidth, kSize.width() - kContentsWidth});
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* back = buttons->addButton(QString(), QDialogButtonBox::ActionRole);
  back->setObjectName("manualBack");
  back->setAutoDefault(false);
  back->setEnabled(false);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  auto* rows = new QVBoxLayout(this);
  rows->addWidget(split, 1);
  rows->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(back, &QPushButton::clicked, text_, &QTextBrowser::backward);
  connect(text_, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
  connect(search_, &QLineEdit::textChanged, this, &ManualWindow::filter);
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    for (QTreeWidgetItemIterator it(contents_); *it; ++it)
      if (!(*it)->isHidden() && (*it)->data(0, kUrl).isValid()) {
        contents_->setCurrentItem(*it);
        break;
      }
  });
  connect(contents_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item && item->data(0, kUrl).isValid())
      show(item->data(0, kUrl).toUrl());
  });
  connect(text_, &QTextBrowser::sourceChanged, this, [this](const QUrl& url) {
    const QSignalBlocker blocked(contents_);
    for (QTreeWidgetItemIterator it(contents_); *it; ++it)
      if ((*it)->data(0, kUrl).toUrl() == url.adjusted(QUrl::RemoveFragment))
        contents_->setCurrentItem(*it);
    highlight();
  });
  fill();
  resize(kSize);
}

void ManualWindow::show(const QUrl& page) {
  if (text_->source() != page)
    text_->setSource(page, QTextDocument::MarkdownResource);
  QDialog::show();
  raise();
  activateWindow();
}

void ManualWindow::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::LanguageChange)
    fill();
}

void ManualWindow::fill() {
  setWindowTitle(tr("Manual"));
  search_->setPlaceholderText(tr("Search the manual"));
  search_->setAccessibleName(search_->placeholderText());
  contents_->setAccessibleName(tr("Contents"));
  text_->setAccessibleName(tr("Page of the manual"));
  findChild<QPushButton*>("manualBack")->setText(tr("&Back"));
  const QSignalBlocker blocked(contents_);
  contents_->clear();
  for (const ManualChapter& chapter : manualChapters()) {
    QTreeWidgetItem* parent = contents_->invisibleRootItem();
    if (!chapter.title.isEmpty())
      parent = new QTreeWidgetItem(parent, {chapter.title});
    for (const ManualPage& page : chapter.pages)
      (new QTreeWidgetItem(parent, {page.title}))->setData(0, kUrl, page.url);
  }
  if (!madePage(text_->source()).isEmpty())
    text_->reload();
  filter(search_->text());
}

void ManualWindow::filter(const QString& words) {
  const QStringList all = words.split(' ', Qt::SkipEmptyParts);
  for (QTreeWidgetItemIterator it(contents_); *it; ++it) {
    const QVariant url = (*it)->data(0, kUrl);
    if (!url.isValid())
      continue;
    (*it)->setHidden(!all.isEmpty() &&
                     !hasWords((*it)->text(0) + '\n' + manualText(url.toUrl()), all));
  }
  for (int i = 0; i < contents_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* chapter = contents_->topLevelItem(i);
    int shown = 0;
    for (int k = 0; k < chapter->childCount(); ++k)
      shown += chapter->child(k)->isHidden() ? 0 : 1;
    if (chapter->childCount() > 0) {
      chapter->setHidden(shown == 0);
      chapter->setExpanded(!all.isEmpty());
    }
  }
  highlight();
}

// Marks the searched words on the page.
void ManualWindow::highlight() {
  QList<QTextEdit::ExtraSelection> marks;
  for (const QString& word : search_->text().split(' ', Qt::SkipEmptyParts)) {
    QTextCursor found(text_->document());
    while (!(found = text_->document()->find(word, found)).isNull()) {
      QTextEdit::ExtraSelection mark;
      mark.cursor = found;
      mark.format.setBackground(palette().highlight());
      mark.format.setForeground(palette().highlightedText());
      marks << mark;
    }
  }
  text_->setExtraSelections(marks);
  if (!marks.isEmpty()) {
    QTextCursor first = marks.front().cursor;
    first.clearSelection();
    text_->setTextCursor(first);
  }
}

void openManual(QWidget& window, const QString& pageId) {
  QWidget* modal = QApplication::activeModalWidget();
  QWidget& parent = modal ? *modal : window;
  const QUrl page = manualPageFor(modal ? modal : QApplication::focusWidget(), pageId);
  auto* manual = parent.findChild<ManualWindow*>(QString(), Qt::FindDirectChildrenOnly);
  (manual ? manual : new ManualWindow(&parent))->show(page);
}

ManualKey::ManualKey(QWidget& window) : QObject(&window), window_(window) {
  qApp->installEventFilter(this);
}

bool ManualKey::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && QApplication::activeModalWidget() &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_F1) {
    openManual(window_, {});
    return true;
  }
  return QObject::eventFilter(watched, event);
}

} // namespace voluta::window
