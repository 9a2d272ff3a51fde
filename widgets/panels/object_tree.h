// Contents of the viewport as a tree: part, platform, cell; each is shown or hidden by its eye.
#pragma once

#include <QString>
#include <QTreeWidget>
#include <array>

namespace voluta::panels {

enum class SceneItem { Part, Platform, Cell, Robot, Nozzle, Plate };
inline constexpr int kSceneItemCount = 6;

class ObjectTree : public QTreeWidget {
  Q_OBJECT

public:
  explicit ObjectTree(QWidget* parent = nullptr);

  // Name and a short detail (size, text of the platform, id). An empty name: the item's kind.
  void setText(SceneItem item, const QString& name, const QString& detail);
  // Emits nothing. Hiding the cell greys its parts without changing their own eyes.
  void setShown(SceneItem item, bool shown);
  bool isShown(SceneItem item) const;
  // Emits nothing.
  void select(SceneItem item);

signals:
  void visibilityChanged(voluta::panels::SceneItem item, bool shown);
  void selected(voluta::panels::SceneItem item);

protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  struct Entry {
    QTreeWidgetItem* item = nullptr;
    QString name, detail;
    bool shown = true;
  };
  Entry& entry(SceneItem item) { return entries_[static_cast<std::size_t>(item)]; }
  void toggle(QTreeWidgetItem* item);
  void showEntry(SceneItem item);
  void retranslate();

  std::array<Entry, kSceneItemCount> entries_;
};

} // namespace voluta::panels
