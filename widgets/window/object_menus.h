// Menus of the right mouse button: on the objects of the tree, on parts, layers and beads in the
// view, and on findings.
#pragma once

#include "panels/object_tree.h"
#include "scene/hit.h"

#include <QObject>
#include <QPoint>
#include <optional>

class QMenu;

namespace voluta::document {
class Document;
}
namespace voluta::panels {
class FindingsPanel;
}
namespace voluta::timeline {
class LayerRangeSlider;
}
namespace voluta::viewer {
class Viewport;
}

namespace voluta::window {

class CommandTable;
class PageStack;
class Picture;
class Presenter;

class ObjectMenus : public QObject {
  Q_OBJECT

public:
  struct Parts {
    document::Document& document;
    PageStack& pages;
    panels::ObjectTree& tree;
    CommandTable& commands;
    timeline::LayerRangeSlider& layers;
    Picture& picture;
    viewer::Viewport& viewport;
    Presenter& presenter;
  };
  // All must outlive this.
  ObjectMenus(const Parts& parts, panels::FindingsPanel& findings, QObject* parent);

private:
  void askInTree(const QPoint& place);
  void askInView(const std::optional<scene::Hit>& hit, const QPoint& global);
  void addItem(QMenu& menu, panels::SceneItem item);
  void addMesh(QMenu& menu);
  void addLayer(QMenu& menu, int layer);
  void addBead(QMenu& menu, const scene::Hit& hit);
  void addCommand(QMenu& menu, const char* id);
  // Shows the menu; it deletes itself. Nothing if it is empty.
  static void open(QMenu* menu, const QPoint& global);

  Parts on_;
};

} // namespace voluta::window
