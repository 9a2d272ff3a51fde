// The pages of the window and which one is on show: brings their widgets in, draws the picture as
// the page on show wants it, takes findings to the page that shows them best.
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
  // `picture`: what stands in the middle on pages without a widget of their own for it.
  PageStack(const WorkspaceParts& workspace, QWidget* picture, LegendView& legend,
            PictureBadge& badge, UnrolledDock& unrolled, QWidget* parent);
  ~PageStack() override;

  FlowBar* flow() { return flow_; }
  QStackedWidget* sides() { return sides_; }
  QStackedWidget* centres() { return centres_; }
  std::vector<Command> commands(); // theirs, and those that go to them

  Page& page() const { return *page_; }
  Page* find(const QString& id) const; // null: unknown
  void show(Page& page) override;
  void showFirst() { show(*pages_.front()); }
  void showPageOf(project::Stage stage);
  // Where what is planned appears: stays where some of it does.
  void showResults();
  void goTo(const plan::Finding& finding);
  void chooseWaypoint(std::optional<std::size_t> waypoint) override;
  void showView() override;
  void showStates() override;
  void resume(std::size_t point) override { emit resumeAsked(point); }
  void say(const QString& text) override { emit said(text); }
  void tell(const QString& title, const QString& message) override { emit told(title, message); }
  void retranslate();

signals:
  void statesShown(); // also: another page is on show
  void resumeAsked(std::size_t point);
  void said(const QString& text);
  void told(const QString& title, const QString& message);

private:
  void listenToViewport();
  void listenToPresenter();
  void listenToBars();
  void showBadge();
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
  bool inCell_ = false, aboutPart_ = false; // the picture that the camera frames
  std::string cell_;                        // drawn last
  scene::World world_ = scene::World::Work;
  Eigen::Vector3d platformSizeMm_ = Eigen::Vector3d::Zero(); // as drawn last
};

} // namespace voluta::window
