// The window's pages and the shown one: adds their widgets, draws the view of the shown page and
// takes findings to the page that shows them best.
#pragma once

#include "window/pages/page.h"

#include <QStackedWidget>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voluta::window {

class FlowBar;
class LegendView;
class PictureBadge;

class PageStack : public QObject, public Shell {
  Q_OBJECT

public:
  // `picture`: the central widget of pages without one of their own.
  PageStack(const WorkspaceParts& workspace, QWidget* picture, LegendView& legend,
            PictureBadge& badge, UnrolledDock& unrolled, QWidget* parent);
  ~PageStack() override;

  FlowBar* flow() { return flow_; }
  QStackedWidget* sides() { return sides_; }
  QStackedWidget* centres() { return centres_; }
  std::vector<Command> commands(); // the pages' own, and those that switch pages

  Page& page() const { return *page_; }
  Page* find(const QString& id) const; // null: unknown
  std::vector<Page*> all() const;
  void show(Page& page) override;
  void showFirst() { show(*pages_.front()); }
  void showPageOf(project::Stage stage);
  // Shows the page on which planned results appear; stays on a page that shows some of them.
  void showResults();
  void goTo(const plan::Finding& finding);
  void showTime(double timeS) { workspace_.timeline.setTimeS(timeS); }
  void chooseWaypoint(std::optional<std::size_t> waypoint) override;
  void showView() override;
  void showStates() override;
  void addPart() override { emit addPartAsked(); }
  void resume(std::size_t point) override { emit resumeAsked(point); }
  void say(const QString& text) override { emit said(text); }
  void showMessage(const QString& title, const QString& message) override {
    emit messageRaised(title, message);
  }
  void retranslate();

signals:
  void statesShown(); // also: another page is shown
  void addPartAsked();
  void resumeAsked(std::size_t point);
  void said(const QString& text);
  void messageRaised(const QString& title, const QString& message);

private:
  void listenToViewport();
  void listenToPresenter();
  void listenToBars();
  void showBadge();
  bool isToolsPicture() const;
  void showLegend();
  void lookAtMarker(const Eigen::Vector3d& place);
  void keepPlatformInView(const Eigen::Vector3d& sizeMm);
  void forInputs(const std::function<void(ViewportInput&)>& does);

  WorkspaceParts workspace_;
  LegendView& legend_;
  PictureBadge& badge_;
  UnrolledDock& unrolled_;
  FlowBar* flow_;
  QStackedWidget *sides_, *centres_;
  std::vector<std::unique_ptr<Page>> pages_;
  Page* page_ = nullptr;
  bool inCell_ = false, aboutPart_ = false; // the view that the camera frames
  std::string cell_;                        // last drawn
  scene::World world_ = scene::World::Work;
  Eigen::Vector3d platformSizeMm_ = Eigen::Vector3d::Zero(); // as last drawn
};

} // namespace voluta::window
