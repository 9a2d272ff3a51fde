// A page of the window: what it brings, what it shows in the viewport, what happens on it.
// Signals go one way, from the document over the window to the pages; a page asks the window
// through Shell and knows no other page. The pages there are stand in page_table.cpp.
#pragma once

#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "project/stage.h"
#include "scene/view_state.h"
#include "timeline/timeline_bar.h"
#include "viewer/viewport.h"
#include "window/commands.h"
#include "window/page_state.h"
#include "window/unrolled/unrolled_dock.h"

#include <QObject>
#include <QString>
#include <optional>
#include <vector>

class QScrollArea;

namespace voluta::document {
class Comparing;
class Document;
class LivePreview;
class Opening;
class Planning;
} // namespace voluta::document
namespace voluta::panels {
class ObjectTree;
}
namespace voluta::timeline {
class LayerRangeSlider;
}

namespace voluta::window {

class Page;
class Picture;
class Presenter;

// What a page asks of the window.
class Shell {
public:
  virtual ~Shell() = default;
  virtual void show(Page& page) = 0;
  // The picture anew, as the page on show draws it.
  virtual void showView() = 0;
  // What every page has come to, and which commands can be used.
  virtual void showStates() = 0;
  // A path to stand out in all views, by a waypoint of it; none: no path.
  virtual void chooseWaypoint(std::optional<std::size_t> waypoint) = 0;
  // The rest of the print from a point of the trajectory on, as a project of its own.
  virtual void resume(std::size_t point) = 0;
  virtual void say(const QString& text) = 0;                           // in the status line
  virtual void tell(const QString& title, const QString& message) = 0; // in a box
};

// What the pages work on; all of it outlives them.
struct WorkspaceParts {
  document::Document& document;
  document::Planning& planning;
  document::LivePreview& live;
  document::Opening& opening;
  document::Comparing& comparing;
  viewer::Viewport& viewport;
  timeline::LayerRangeSlider& layers;
  timeline::TimelineBar& timeline;
  panels::ObjectTree& tree;
  Presenter& presenter;
  Picture& picture;
};

struct Workspace : WorkspaceParts {
  Shell& shell;
};

struct PageInfo {
  const char* id;
  const char* name;   // source text of the context "Commands", with its mnemonic
  bool aside = false; // beside the flow, no step of it
};

struct PageLayout {
  bool layerSlider = false;
  std::optional<timeline::BarMode> timeline = {}; // none: no bar under the viewport
  bool inCell = false;    // the picture is of the robot's cell, not of the part alone
  bool aboutPart = false; // the picture is of the part and what stands about it
};

// What is done with the mouse in the viewport while its page is on show.
class ViewportInput {
public:
  virtual ~ViewportInput() = default;
  virtual void clicked(const std::optional<scene::Hit>&) {}
  virtual void hovered(const std::optional<scene::Hit>&) {}
  virtual void gizmoStarted() {}
  virtual void gizmoDragged(const viewer::GizmoChange&, bool /*finished*/) {}
};

class Page : public QObject {
  Q_OBJECT

public:
  Page(const PageInfo& info, const Workspace& workspace);

  QString id() const { return info_.id; }
  const PageInfo& info() const { return info_; }
  QString title() const;
  // Is it the page on show?
  bool isShown() const { return shown_; }
  void enter();
  void leave();

  // Into the dock at the right.
  virtual QWidget* side() = 0;
  // In place of the viewport; null: the viewport.
  virtual QWidget* centre() { return nullptr; }
  virtual PageLayout layout() const { return {}; }
  virtual std::vector<Command> commands() { return {}; }
  virtual std::vector<ViewportInput*> inputs() { return {}; }
  // Whose results it shows.
  virtual std::vector<project::Stage> stages() const { return {}; }
  virtual PageState state() const; // the worst of stages()
  virtual void retranslate() {}

  // What is seen, on top of Picture::base().
  virtual void draw(scene::ViewState& view) = 0;
  virtual void drawn() {} // the viewport has it
  // none: it shows no layers being laid.
  virtual std::optional<Laid> laid() const { return {}; }
  // Takes the picture to a waypoint of that path.
  virtual void goToWaypoint(const plan::ToolPath&, std::size_t /*waypoint*/) {}

  // How well it can show what a finding is about: the best page does. 0: not at all.
  virtual int interest(const plan::Finding&) const { return 0; }
  // Called on show; true: the camera is there too.
  virtual bool goTo(const plan::Finding&) { return false; }

protected:
  virtual void entered() {}
  virtual void left() {}
  const Workspace& work() const { return workspace_; }

private:
  PageInfo info_;
  Workspace workspace_;
  bool shown_ = false;
};

inline constexpr const char* kPageArea = "pageArea";
// The content of a dock in a bar that scrolls.
QScrollArea* scrolled(QWidget* content);

} // namespace voluta::window
