#include "window/palette/palette_entries.h"

#include "forms/fold.h"
#include "forms/parameter_form.h"
#include "forms/parameter_row.h"
#include "forms/shown_text.h"
#include "language/setting_words.h"
#include "language/words.h"
#include "window/pages/page_stack.h"
#include "window/window_commands.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QScrollArea>
#include <QTabWidget>
#include <QTimer>
#include <set>

namespace voluta::window {

namespace {
template <typename Kind> Kind* above(const QWidget& widget) {
  for (QWidget* at = widget.parentWidget(); at; at = at->parentWidget())
    if (auto* kind = qobject_cast<Kind*>(at))
      return kind;
  return nullptr;
}

// Whether the page hides the field; folds and tabs can be opened.
bool isHiddenByPage(const QWidget& field, const QWidget& page) {
  for (const QWidget* at = &field; at && at != &page; at = at->parentWidget()) {
    const QWidget* parent = at->parentWidget();
    const bool canOpen = parent && (qobject_cast<const forms::Fold*>(parent) ||
                                    qobject_cast<const QStackedWidget*>(parent));
    if (at->isHidden() && !canOpen)
      return true;
  }
  return false;
}

void reveal(QWidget& field) {
  for (QWidget* at = &field; at; at = at->parentWidget()) {
    if (auto* fold = qobject_cast<forms::Fold*>(at))
      fold->setOpen(true);
    if (auto* form = qobject_cast<forms::ParameterForm*>(at))
      form->reveal(field);
    if (auto* tabs = above<QTabWidget>(*at); tabs && tabs->indexOf(at) >= 0)
      tabs->setCurrentWidget(at);
  }
  field.setFocus(Qt::TabFocusReason);
  // Fields that have just been shown are laid out only later.
  QTimer::singleShot(0, &field, [&field] {
    for (QWidget* at = &field; at; at = at->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(at))
        area->ensureWidgetVisible(&field);
  });
}

class Settings {
public:
  Settings(PageStack& pages, Page& page) : pages_(pages), page_(page) {}

  std::vector<PaletteEntry> entries() {
    QWidget& side = *page_.side();
    for (const QLabel* label : side.findChildren<QLabel*>())
      if (QWidget* field = label->buddy())
        add(*field, forms::shownText(label->text()));
    for (QCheckBox* box : side.findChildren<QCheckBox*>())
      add(*box, forms::shownText(box->text()));
    // Fields in a table or a row, which have a name of their own.
    for (QWidget* field : side.findChildren<QWidget*>())
      if (qobject_cast<const QAbstractSpinBox*>(field) || qobject_cast<const QComboBox*>(field))
        add(*field, field->accessibleName());
    return std::move(entries_);
  }

private:
  void add(QWidget& field, const QString& name) {
    const auto* row = above<forms::ParameterRow>(field);
    const auto* form = above<forms::ParameterForm>(field);
    const bool offered =
        form && row ? form->offers(*row)
                    : (form && form->isSearching()) || !isHiddenByPage(field, *page_.side());
    if (name.isEmpty() || !offered || !added_.insert(&field).second)
      return;
    const std::string key = row ? row->spec().key : field.objectName().toStdString();
    PaletteEntry entry{name, page_.title()};
    if (row)
      entry.place += QStringLiteral(" › ") + language::heading(row->spec().group);
    entry.meaning = language::synonyms(key);
    entry.more = QString::fromStdString(key) + QChar(' ') + field.toolTip();
    entry.does = [&pages = pages_, &page = page_, field = QPointer<QWidget>(&field)] {
      pages.show(page);
      if (field)
        reveal(*field);
    };
    entries_.push_back(std::move(entry));
  }

  PageStack& pages_;
  Page& page_;
  std::vector<PaletteEntry> entries_;
  std::set<const QWidget*> added_;
};
} // namespace

std::vector<PaletteEntry> commandEntries(const CommandTable& table) {
  std::vector<PaletteEntry> entries;
  for (const QMenu* menu : table.menus()) {
    QString place = forms::shownText(menu->title());
    place.remove(QChar(0x2026));
    for (QAction* action : menu->actions()) {
      if (action->isSeparator() || action->menu() || !action->isVisible())
        continue;
      entries.push_back({forms::shownText(action->text()),
                         place,
                         {},
                         action->toolTip(),
                         action->shortcut().toString(QKeySequence::NativeText),
                         action->isEnabled(),
                         [action = QPointer<QAction>(action)] {
                           if (action)
                             action->trigger();
                         }});
    }
  }
  return entries;
}

std::vector<PaletteEntry> settingEntries(PageStack& pages) {
  std::vector<PaletteEntry> entries;
  for (Page* page : pages.all())
    for (PaletteEntry& entry : Settings(pages, *page).entries())
      entries.push_back(std::move(entry));
  return entries;
}

} // namespace voluta::window
