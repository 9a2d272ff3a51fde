// Contents of the viewport as a tree: part, platform, cell; each is shown or hidden by its eye.
#pragma once

#include <QString>
#include <QTreeWidget>
#include <array>
#include <optional>

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
  std::optional<SceneItem> sceneItemAt(const QPoint& place) const;
  // As a click on its eye.
  void toggle(SceneItem item);
  // Hides all other items, or shows all if they are hidden.
  void isolate(SceneItem item);
  bool isIsolated(SceneItem item) const;
  // Lets the user edit that name of the part; `renamed` follows.
  void editPartName(const QString& name);

signals:
  void renamed(const QString& name);
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
  void showEntry(SceneItem item);
  void retranslate();

  std::array<Entry, kSceneItemCount> entries_;
};

} // namespace voluta::panels
