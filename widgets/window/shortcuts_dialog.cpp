#include "window/shortcuts_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
QString plain(QString text) {
  return text.remove('&');
}
} // namespace

QKeySequence shortcutOf(const QString& id, const QKeySequence& standard) {
  const QVariant kept = QSettings().value("keys/" + id);
  return kept.isValid() ? QKeySequence(kept.toString(), QKeySequence::PortableText) : standard;
}

ShortcutsDialog::ShortcutsDialog(std::vector<QAction*> actions, QWidget* parent)
    : QDialog(parent), actions_(std::move(actions)), search_(new QLineEdit(this)),
      table_(new QTableWidget(this)), edit_(new QKeySequenceEdit(this)), clash_(new QLabel(this)) {
  setObjectName("shortcutsDialog");
  setWindowTitle(tr("Keys"));
  for (const QAction* action : actions_)
    keys_.push_back(action->shortcut());
  search_->setPlaceholderText(tr("Search"));
  search_->setAccessibleName(search_->placeholderText());
  table_->setAccessibleName(windowTitle());
  search_->setClearButtonEnabled(true);
  table_->setColumnCount(2);
  table_->setHorizontalHeaderLabels({tr("Command"), tr("Key")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->verticalHeader()->hide();
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  clash_->setWordWrap(true);
  auto* standard = new QPushButton(tr("Default key"), this);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  auto* column = new QVBoxLayout(this);
  column->addWidget(search_);
  column->addWidget(table_, 1);
  auto* editRow = new QHBoxLayout;
  auto* editLabel = new QLabel(tr("New key:"), this);
  editLabel->setBuddy(edit_);
  edit_->setAccessibleName(tr("New key"));
  editRow->addWidget(editLabel);
  editRow->addWidget(edit_, 1);
  editRow->addWidget(standard);
  column->addLayout(editRow);
  column->addWidget(clash_);
  column->addWidget(buttons);
  connect(search_, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &ShortcutsDialog::chosen);
  connect(edit_, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutsDialog::edited);
  connect(standard, &QPushButton::clicked, this, [this] {
    const int row = table_->currentRow();
    if (row >= 0)
      edit_->setKeySequence(actions_[static_cast<std::size_t>(row)]
                                ->property("defaultShortcut")
                                .value<QKeySequence>());
  });
  connect(buttons, &QDialogButtonBox::accepted, this, &ShortcutsDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &ShortcutsDialog::reject);
  fill();
  resize(460, 560);
}

void ShortcutsDialog::fill() {
  table_->setRowCount(static_cast<int>(actions_.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    table_->setItem(row, 0, new QTableWidgetItem(plain(actions_[i]->text())));
    table_->setItem(row, 1, new QTableWidgetItem(keys_[i].toString(QKeySequence::NativeText)));
  }
  table_->selectRow(0);
}

void ShortcutsDialog::chosen() {
  const int row = table_->currentRow();
  if (row < 0)
    return;
  const QSignalBlocker quiet(edit_);
  edit_->setKeySequence(keys_[static_cast<std::size_t>(row)]);
  clash_->clear();
}

void ShortcutsDialog::edited(const QKeySequence& keys) {
  const int row = table_->currentRow();
  if (row < 0)
    return;
  const auto i = static_cast<std::size_t>(row);
  keys_[i] = keys;
  table_->item(row, 1)->setText(keys.toString(QKeySequence::NativeText));
  clash_->clear();
  // Two commands with one key would both stop working: remove it from the other command.
  for (std::size_t other = 0; other < keys_.size(); ++other)
    if (other != i && !keys.isEmpty() && keys_[other] == keys) {
      keys_[other] = QKeySequence();
      table_->item(static_cast<int>(other), 1)->setText({});
      clash_->setText(tr("This key was removed from “%1”.").arg(plain(actions_[other]->text())));
    }
}

void ShortcutsDialog::filter(const QString& text) {
  for (int row = 0; row < table_->rowCount(); ++row)
    table_->setRowHidden(row,
                         !table_->item(row, 0)->text().contains(text, Qt::CaseInsensitive) &&
                             !table_->item(row, 1)->text().contains(text, Qt::CaseInsensitive));
}

void ShortcutsDialog::accept() {
  QSettings settings;
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    if (keys_[i] == actions_[i]->shortcut())
      continue;
    actions_[i]->setShortcut(keys_[i]);
    const QString key = "keys/" + actions_[i]->objectName();
    if (keys_[i] == actions_[i]->property("defaultShortcut").value<QKeySequence>())
      settings.remove(key);
    else
      settings.setValue(key, keys_[i].toString(QKeySequence::PortableText));
  }
  QDialog::accept();
}

} // namespace voluta::window
