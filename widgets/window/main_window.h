// The window: one flow of four pages about one viewport (docs/design.md, Window). Puts the parts
// together; what they do is their own.
#pragma once

#include "document/autosave.h"
#include "document/comparing.h"
#include "document/document.h"
#include "document/live_preview.h"
#include "document/mode_switch.h"
#include "document/opening.h"
#include "document/planning.h"
#include "document/recent_files.h"
#include "document/saving.h"
#include "panels/object_tree.h"
#include "planar/given_cuts.h"
#include "viewer/viewport.h"
#include "window/flow_bar.h"
#include "window/presenter.h"
#include "window/theme.h"
#include "window/view_options.h"

#include <QMainWindow>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QActionGroup;
class QDockWidget;
class QLabel;
class QMenu;
class QScrollArea;
class QStackedWidget;
class QTabWidget;

namespace voluta::forms {
class ChoicesForm;
class ParameterForm;
} // namespace voluta::forms
namespace voluta::panels {
class ExportPanel;
class FindingsPanel;
struct RemedyButton;
class LayerInfo;
class MeshPanel;
class PiecesPanel;
class PlacementPanel;
} // namespace voluta::panels
namespace voluta::timeline {
class JointPlots;
class LayerRangeSlider;
class TimelineBar;
} // namespace voluta::timeline

namespace voluta::window {

class ComparePage;
class LegendView;
class ProgramPreview;
class SpacingView;
class StatusLine;
class UnrolledView;
class Welcome;

class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  explicit MainWindow(Appearance appearance, QWidget* parent = nullptr);
  ~MainWindow() override;

  // A part, a project or "sample:NAME".
  void open(const QString& path);
  // Offers what a crash left, if anything is there.
  void offerRecovered();

  void setPage(Page page);
  Page page() const { return flow_->page(); }

  document::Document& document() { return document_; }
  document::Planning& planning() { return planning_; }
  document::LivePreview& livePreview() { return live_; }
  document::Comparing& comparing() { return comparing_; }
  viewer::Viewport& viewport() { return *viewport_; }
  Presenter& presenter() { return *presenter_; }

protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  // main_window.cpp: what there is and how it is laid out
  void buildCentre();
  void buildPages();
  void buildDocks();
  void connectDocument(); // main_window_connections.cpp
  void connectPages();
  void retranslate();
  void showLists();
  QScrollArea* scrolled(QWidget* content);

  // main_window_actions.cpp: menus, tool bar, keys
  struct Command {
    QAction* action;
    const char* text; // source text, translated anew with the language
    const char* tip;
    QString icon;
  };
  void buildMenus();
  void buildToolBar();
  QAction* command(QMenu* menu, const char* id, const char* text, const char* tip,
                   const QKeySequence& keys, const QString& icon, std::function<void()> does);
  void showRecent();
  void editShortcuts();
  void showAbout();
  void chooseFile();
  void chooseExportedFile();
  void newProject();
  void save();
  void saveAs();
  void switchAppearance(Appearance appearance);
  void switchLanguage(const QString& code);
  void redrawIcons();
  void retranslateUndo();

  // main_window_{flow,document,view,export}.cpp: what happens when something changes
  // Runs `then` once the user has saved or given up unsaved changes.
  void afterSaved(std::function<void()> then);
  void plan();
  void cancel();
  void showStates();
  void showChoices();
  // main_window_modes.cpp: what goes with a way of building
  void connectModes();
  void switchMode(const std::string& mode);
  void showNotice();
  void pressNotice();
  void placeOnTouchedPoints();
  void showPart();
  void showFindings();
  // Of what counts now: preview, result, and the error that a run ended in.
  plan::Findings presentFindings() const;
  std::vector<panels::RemedyButton> remediesOf(const plan::Finding& finding) const;
  void applyRemedy(const plan::Finding& finding, const QString& id);
  void setLivePreview(bool on);
  void showExport();
  void showPreview();
  QString summaryText() const;
  QString endText() const;
  void showLayerMeasures(int layer);
  void showView();
  void showLayerCount();
  void showMoves();
  // main_window_growth.cpp
  LayerSubject shownSubject() const; // never Furthest
  bool replaysGrowth() const;
  void showGrowth();
  void connectGrowth();
  // main_window_pieces.cpp
  void connectPieces();
  bool piecesShown() const;
  double explodeMm() const;
  void showPieces();
  void showCuts();
  void selectPiece(int piece); // -1: none
  void showCutHandles();
  void dragCut(const viewer::GizmoChange& change, bool finished);
  std::optional<Eigen::Isometry3d> movedBase() const;
  void setCuts(const QString& text, const QString& editName); // empty: the search's
  void pickRoot(const Eigen::Vector3d& point);
  // Flies to the face that the finding is about, to a side that it is seen from; false: there are
  // no pieces, or it is not about them.
  bool lookAtPieces(const plan::Finding& finding);
  // main_window_unrolled.cpp
  void buildUnrolled();
  void addUnrolledAction(QAction* action);
  void showUnrolled();
  std::shared_ptr<const plan::ToolPlan> planOfLayers() const;
  void chooseWaypoint(std::optional<std::size_t> waypoint);
  void showChosen(scene::ViewState& view) const;
  // main_window_compare.cpp
  void buildCompare();
  void showCompareState();
  // Flies to a group of missed voxels, the others made see-through; false: the finding is no such.
  bool lookAtMissed(const plan::Finding& finding);
  void goTo(const plan::Finding& finding);
  void exportPrograms(const QString& folder, const QStringList& formats, bool includeRefused);
  void writePrograms(const QString& folder, const QStringList& formats, bool includeRefused);
  void tell(const QString& title, const QString& message);
  void applyGizmo(const viewer::GizmoChange& change, bool finished);
  void placeOnFace(const Eigen::Vector3d& normal);
  // Where edits of the placement begin.
  geometry::Placement placed() const;
  void setTool(viewer::Tool tool);
  bool shows(panels::SceneItem item) const;
  void setTime(double timeS);
  scene::ViewState viewState() const;

  document::Document document_;
  document::Planning planning_;
  document::LivePreview live_;
  document::Opening opening_;
  document::Saving saving_;
  document::Comparing comparing_;
  document::RecentFiles recent_;
  std::unique_ptr<document::Autosave> autosave_;
  document::ModeSwitch modeSwitch_;
  jobs::JobRunner exporting_;
  Appearance appearance_;

  viewer::Viewport* viewport_ = nullptr;
  LegendView* legend_ = nullptr;
  Welcome* welcome_ = nullptr;
  FlowBar* flow_ = nullptr;
  StatusLine* status_ = nullptr;
  timeline::TimelineBar* timeline_ = nullptr;
  timeline::LayerRangeSlider* layers_ = nullptr;
  Presenter* presenter_ = nullptr;

  QDockWidget *partDock_ = nullptr, *findingsDock_ = nullptr, *pageDock_ = nullptr;
  QDockWidget* unrolledDock_ = nullptr;
  UnrolledView* unrolled_ = nullptr;
  QAction* unrolledAction_ = nullptr;
  panels::ObjectTree* tree_ = nullptr;
  panels::FindingsPanel* findings_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QStackedWidget* centre_ = nullptr; // the viewport with its bars, or the comparison
  ComparePage* compare_ = nullptr;
  panels::PlacementPanel* placement_ = nullptr;
  panels::MeshPanel* mesh_ = nullptr;
  forms::ChoicesForm* choices_ = nullptr;
  forms::ParameterForm* parameters_ = nullptr;
  ViewOptions* options_ = nullptr;
  panels::LayerInfo* layerInfo_ = nullptr;
  SpacingView* spacing_ = nullptr;
  panels::PiecesPanel* piecesPanel_ = nullptr;
  timeline::JointPlots* plots_ = nullptr;
  panels::ExportPanel* export_ = nullptr;
  ProgramPreview* preview_ = nullptr;
  QLabel* summary_ = nullptr;
  QTabWidget* prepareTabs_ = nullptr;

  std::vector<Command> commands_;
  QMenu* recentMenu_ = nullptr;
  std::vector<std::pair<QMenu*, const char*>> menus_;
  QActionGroup* tools_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr, *plan_ = nullptr, *cancel_ = nullptr;

  // Of the mode that was last switched to, what was changed with it; empty: nothing.
  std::pair<std::string, QString> wentAlong_;
  std::optional<Eigen::Vector3d> marker_;
  std::optional<std::size_t> chosenWaypoint_; // its path stands out in both views
  geometry::Placement placedBeforeGizmo_;
  double scaleBeforeGizmo_ = 1.0;
  std::vector<planar::GivenCut> cuts_, cutsBeforeDrag_; // as the choices have them, else as found
  int chosenCut_ = -1;                                  // of the chosen piece; -1: none
  bool cutHandles_ = false;
  std::function<void()> afterSave_;
  struct PendingExport {
    QString folder;
    QStringList formats;
    bool includeRefused;
  };
  std::optional<PendingExport> pendingExport_;
  std::array<bool, 3> newest_{}; // of what is on show: decides what the viewport shows
  bool lookingAtMissed_ = false; // until something else is asked for
  bool closing_ = false, framedInCell_ = false, unrolledSized_ = false;
};

} // namespace voluta::window
