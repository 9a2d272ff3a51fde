// Base class of the window's pages: their widgets, their view in the viewport and their reactions
// to input. Signals go one way, from the document through the window to the pages; a page calls the
// window through Shell and knows no other page. page_table.cpp lists the pages.
#pragma once

#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "project/job_stage.h"
#include "scene/view_state.h"
#include "timeline/timeline_bar.h"
#include "viewer/viewport.h"
#include "window/page_state.h"
#include "window/unrolled/unrolled_dock.h"
#include "window/window_commands.h"

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

// The window's interface for pages.
class Shell {
public:
  virtual ~Shell() = default;
  virtual void show(Page& page) = 0;
  // Redraws the viewport as the shown page defines it.
  virtual void showView() = 0;
  // Updates the states of all pages and the enabled commands.
  virtual void showStates() = 0;
  // Highlights a path in all views, given by one of its waypoints; none: no path.
  virtual void chooseWaypoint(std::optional<std::size_t> waypoint) = 0;
  // Lets the user choose a part to be added to those that are open.
  virtual void addPart() = 0;
  // Opens the rest of the print, from a point of the trajectory, as a new project.
  virtual void resume(std::size_t point) = 0;
  virtual void say(const QString& text) = 0;                                  // in the status line
  virtual void showMessage(const QString& title, const QString& message) = 0; // in a message box
};

// The objects that the pages work on; all of them outlive the pages.
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
  const char* name;      // source text of the context "Commands", with its mnemonic
  bool separate = false; // beside the flow, not a step of it
};

struct PageLayout {
  bool layerSlider = false;
  std::optional<timeline::BarMode> timeline = {}; // none: no bar below the viewport
  bool inCell = false;    // the view shows the robot's cell, not the part alone
  bool aboutPart = false; // the view shows the part and its surroundings
};

// Mouse input in the viewport while its page is shown.
class ViewportInput {
public:
  virtual ~ViewportInput() = default;
  virtual void clicked(const std::optional<scene::Hit>&) {}
  virtual void hovered(const std::optional<scene::Hit>&) {}
  virtual void painted(const std::optional<scene::Hit>&, bool /*erases*/, bool /*finished*/) {}
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
  // Returns whether this page is shown.
  bool isShown() const { return shown_; }
  void enter();
  void leave();

  // The widget for the right dock.
  virtual QWidget* side() = 0;
  // The widget in place of the viewport; null: the viewport.
  virtual QWidget* centre() { return nullptr; }
  virtual PageLayout layout() const { return {}; }
  virtual std::vector<Command> commands() { return {}; }
  virtual std::vector<ViewportInput*> inputs() { return {}; }
  // The stages whose results the page shows.
  virtual std::vector<project::Stage> stages() const { return {}; }
  virtual PageState state() const; // the worst of stages()
  virtual void retranslate() {}

  // Adds the page's content to Picture::base().
  virtual void draw(scene::ViewState& view) = 0;
  virtual void drawn() {} // called after the viewport has drawn it
  // The printed layers on show; none: the page shows no printing.
  virtual std::optional<PrintProgress> printProgress() const { return {}; }
  // Moves the view to a waypoint of that path.
  virtual void goToWaypoint(const plan::ToolPath&, std::size_t /*waypoint*/) {}

  // Returns how well the page can show a finding; the page with the highest value is chosen. 0: not
  // at all.
  virtual int interest(const plan::Finding&) const { return 0; }
  // Shows the finding; called while the page is shown. Returns true if the camera is at its place
  // too.
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
// Returns a scroll area with the content of a dock.
QScrollArea* scrolled(QWidget* content);

} // namespace voluta::window
