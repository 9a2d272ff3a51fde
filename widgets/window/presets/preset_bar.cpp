#include "window/presets/preset_bar.h"

#include "forms/value_boxes.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr int kDepthRole = Qt::UserRole + 1;
constexpr int kBesideLabel = 48; // [px] scroll bar, frame and indents

struct DeedRow {
  PresetDeed deed;
  const char *name, *text;
  bool isNewGroup;
};
constexpr DeedRow kDeeds[] = {
    {PresetDeed::Save, "savePreset", QT_TRANSLATE_NOOP("PresetBar", "&Save"), false},
    {PresetDeed::SaveAs, "savePresetAs", QT_TRANSLATE_NOOP("PresetBar", "Save &as…"), false},
    {PresetDeed::Discard, "discardPresetChanges",
     QT_TRANSLATE_NOOP("PresetBar", "D&iscard changes"), false},
    {PresetDeed::Rename, "renamePreset", QT_TRANSLATE_NOOP("PresetBar", "&Rename…"), true},
    {PresetDeed::Delete, "deletePreset", QT_TRANSLATE_NOOP("PresetBar", "&Delete…"), false},
    {PresetDeed::Compare, "comparePresets", QT_TRANSLATE_NOOP("PresetBar", "&Compare with…"), true},
    {PresetDeed::Export, "exportPreset", QT_TRANSLATE_NOOP("PresetBar", "&Export…"), true},
    {PresetDeed::Import, "importPreset", QT_TRANSLATE_NOOP("PresetBar", "I&mport…"), false}};

// Shows an entry of the open list to the right of its parent; the closed box has no indent.
class Indented : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    constexpr int kBlanks = 4;
    option->text.prepend(QString(kBlanks * index.data(kDepthRole).toInt(), u' '));
    if (!index.flags().testFlag(Qt::ItemIsEnabled))
      option->font.setItalic(true);
  }
};
} // namespace

PresetBar::PresetBar(QWidget* parent)
    : QWidget(parent), label_(new QLabel(this)), combo_(forms::makeCombo(this)),
      button_(new QToolButton(this)), menu_(new QMenu(this)) {
  combo_->setObjectName(QStringLiteral("preset"));
  combo_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  combo_->setItemDelegate(new Indented(combo_));
  label_->setBuddy(combo_);
  button_->setObjectName(QStringLiteral("presetMenuButton"));
  button_->setText(QStringLiteral("…"));
  connect(button_, &QToolButton::clicked, this,
          [this] { menu_->popup(button_->mapToGlobal(QPoint(0, button_->height()))); });
  menu_->setObjectName(QStringLiteral("presetMenu"));
  for (const DeedRow& row : kDeeds) {
    if (row.isNewGroup)
      menu_->addSeparator();
    QAction* action = menu_->addAction(QString());
    action->setObjectName(QLatin1String(row.name));
    connect(action, &QAction::triggered, this, [this, deed = row.deed] { emit asked(deed); });
    actions_[row.deed] = action;
  }
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(12, 6, 6, 0);
  line->addWidget(label_);
  line->addWidget(combo_, 1);
  line->addWidget(button_);
  connect(combo_, &QComboBox::activated, this, [this] {
    const QString choice = combo_->currentData().toString();
    // The document decides which entry is shown.
    const QSignalBlocker quiet(combo_);
    combo_->setCurrentIndex(combo_->findData(chosen_));
    if (choice != chosen_ && !choice.isEmpty())
      emit chosen(choice);
  });
  retranslate();
}

void PresetBar::showPresets(const std::vector<PresetEntry>& entries, const QString& chosen,
                            bool changed) {
  const QSignalBlocker quiet(combo_);
  if (entries_ != entries) {
    entries_ = entries;
    fill();
  }
  chosen_ = chosen;
  for (int row = 0; row < combo_->count(); ++row) {
    const PresetEntry& entry = entries_[static_cast<std::size_t>(row)];
    const bool isMarked = changed && entry.choice == chosen_;
    const QString text = isMarked ? tr("%1 (changed)").arg(entry.label) : entry.label;
    if (combo_->itemText(row) != text)
      combo_->setItemText(row, text);
  }
  const int row = combo_->findData(chosen_);
  combo_->setCurrentIndex(row);
  combo_->setToolTip(row < 0 ? QString() : combo_->itemData(row, Qt::ToolTipRole).toString());
  QFont font = combo_->font();
  font.setBold(changed);
  combo_->setFont(font);
}

void PresetBar::fill() {
  combo_->clear();
  int widest = 0;
  for (const PresetEntry& entry : entries_) {
    combo_->addItem(entry.label, entry.choice);
    const int row = combo_->count() - 1;
    combo_->setItemData(row, entry.depth, kDepthRole);
    combo_->setItemData(row, entry.about, Qt::ToolTipRole);
    if (entry.choice.isEmpty())
      static_cast<QStandardItemModel*>(combo_->model())->item(row)->setEnabled(false);
    widest = std::max(widest, combo_->fontMetrics().horizontalAdvance(entry.label));
  }
  combo_->view()->setMinimumWidth(widest + kBesideLabel);
}

void PresetBar::setPossible(PresetDeed deed, bool possible) {
  actions_.at(deed)->setEnabled(possible);
}

void PresetBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

void PresetBar::retranslate() {
  label_->setText(tr("Preset"));
  combo_->setAccessibleName(tr("Preset"));
  button_->setToolTip(tr("Save, compare, export or import presets"));
  button_->setAccessibleName(tr("Preset menu"));
  for (const DeedRow& row : kDeeds)
    actions_.at(row.deed)->setText(QCoreApplication::translate("PresetBar", row.text));
}

} // namespace voluta::window
