// The pages of the manual: those of docs/, compiled in, and two that are made from tables.
#pragma once

#include <QString>
#include <QUrl>
#include <vector>

class QWidget;

namespace voluta::window {

struct ManualPage {
  QString title;
  QUrl url; // of a text in Markdown
};

struct ManualChapter {
  QString title; // empty: the manual itself
  std::vector<ManualPage> pages;
};

// Returns the pages in the order of their tables of contents, in the window's language where they
// are made from tables.
std::vector<ManualChapter> manualChapters();

// Returns the text of a page that is made from tables; empty for other pages.
QString madePage(const QUrl& url);

// Returns the text of any page; empty if there is none.
QString manualText(const QUrl& url);

// Returns the page about a dialog or a page of the window: by the object names of the widget and
// its parents, else about the page of the window with that id, else the table of contents.
QUrl manualPageFor(const QWidget* widget, const QString& pageId);

} // namespace voluta::window
