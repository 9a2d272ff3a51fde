// Shows every form and panel with sample data and keeps a picture of each:
// forms_gallery FOLDER [--dark] [--long] [--width PX]
#include "forms/choices_form.h"
#include "forms/parameter_form.h"
#include "gallery_data.h"
#include "long_translator.h"
#include "panels/export_panel.h"
#include "panels/findings_panel.h"
#include "panels/layer_info.h"
#include "panels/mesh_panel.h"
#include "panels/object_tree.h"
#include "panels/placement_panel.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListView>
#include <QPainter>

using namespace voluta;

namespace {
QPalette darkPalette() {
  QPalette p(QColor(50, 50, 52));
  p.setColor(QPalette::Window, QColor(45, 45, 48));
  p.setColor(QPalette::WindowText, QColor(225, 225, 225));
  p.setColor(QPalette::Base, QColor(32, 32, 34));
  p.setColor(QPalette::AlternateBase, QColor(40, 40, 43));
  p.setColor(QPalette::Text, QColor(225, 225, 225));
  p.setColor(QPalette::Button, QColor(58, 58, 62));
  p.setColor(QPalette::ButtonText, QColor(225, 225, 225));
  p.setColor(QPalette::Highlight, QColor(52, 110, 180));
  p.setColor(QPalette::HighlightedText, Qt::white);
  p.setColor(QPalette::PlaceholderText, QColor(150, 150, 150));
  p.setColor(QPalette::ToolTipBase, QColor(58, 58, 62));
  p.setColor(QPalette::ToolTipText, QColor(225, 225, 225));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, QColor(125, 125, 125));
  return p;
}

forms::ChoicesForm* choicesForm() {
  auto* form = new forms::ChoicesForm;
  forms::ChoiceLists lists;
  lists.modes = {{"curved", "Curved layers", ""}};
  lists.growths = {{"auto", "Automatic", ""}, {"reverse", "Reverse", ""}};
  lists.cells = {{"ur5-fixed", "UR5, fixed nozzle", ""}};
  lists.processes = {{"fdm-1.0", "FDM, nozzle 1.0 mm", ""}};
  form->setLists(lists);
  forms::ChoiceTexts texts{"curved", "auto", "rect:200x120", "ur5-fixed", "fdm-1.0", 1};
  form->setTexts(texts);
  return form;
}

forms::ParameterForm* parameterForm(bool all, const QString& search) {
  auto* form = new forms::ParameterForm(pipeline::allParameters());
  if (!all)
    form->setHeader(choicesForm());
  form->setShowAll(all);
  form->setValues({{"layerHeightMm", "1.4"}, {"infill", "concentric"}, {"output.debug", "true"}});
  form->setProblems(
      {{"layerHeightMm", "1.4 mm is outside the limits of process fdm-1.0 (give 0.4 to 1 mm)"}});
  form->findChild<QLineEdit*>("search")->setText(search);
  return form;
}

panels::FindingsPanel* findingsPanel(bool filled) {
  auto* panel = new panels::FindingsPanel;
  if (!filled)
    return panel;
  panel->setPlanned(true);
  panel->setFindings(gallery::sampleFindings());
  auto* list = panel->findChild<QListView*>();
  list->setCurrentIndex(list->model()->index(1, 0));
  return panel;
}

panels::PlacementPanel* placementPanel() {
  auto* panel = new panels::PlacementPanel;
  geometry::Placement placement;
  placement.centreMm = {12.5, -40.0};
  placement.rotation = Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX());
  panel->setPlacement(placement);
  panel->setScale("0.75", 0.75);
  panel->setSizeMm({71.2, 60.4, 112.8});
  return panel;
}

panels::ObjectTree* objectTree() {
  auto* tree = new panels::ObjectTree;
  using panels::SceneItem;
  tree->setText(SceneItem::Part, "kitten.stl", "71.2 × 60.4 × 112.8 mm");
  tree->setText(SceneItem::Platform, "", "fit:0");
  tree->setText(SceneItem::Cell, "", "ur5-fixed");
  tree->setText(SceneItem::Robot, "", "ur5");
  tree->setShown(SceneItem::Nozzle, false);
  return tree;
}

panels::ExportPanel* exportPanel(const QString& blocked) {
  auto* panel = new panels::ExportPanel;
  panel->setFormats(gallery::sampleFormats());
  panel->setChecked({"urscript", "gcode-extended"});
  panel->setFolder("/home/designer/programs/kitten");
  panel->setBlockedReason(blocked);
  panel->showLine(0, 1204);
  return panel;
}
} // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setStyle("Fusion");
  QCommandLineParser options;
  options.addPositionalArgument("folder", "Where the pictures go");
  options.addOption({"dark", "With a dark palette"});
  options.addOption({"long", "With every text a third longer"});
  options.addOption({"width", "Width of the panels", "pixels", "300"});
  options.process(application);
  if (options.isSet("dark"))
    QApplication::setPalette(darkPalette());
  gallery::LongTranslator translator;
  if (options.isSet("long"))
    QApplication::installTranslator(&translator);
  const QString folder = options.positionalArguments().value(0, ".");
  QDir().mkpath(folder);

  auto* mesh = new panels::MeshPanel;
  mesh->setSummary(gallery::sampleMesh());
  auto* layer = new panels::LayerInfo;
  layer->setMeasures(gallery::sampleLayer());
  const std::vector<std::pair<const char*, std::vector<std::pair<QWidget*, int>>>> sheets{
      {"prepare",
       {{parameterForm(false, ""), 620},
        {parameterForm(true, ""), 620},
        {parameterForm(true, "distance part"), 620}}},
      {"place", {{placementPanel(), 0}, {mesh, 0}, {objectTree(), 220}, {layer, 0}}},
      {"findings", {{findingsPanel(true), 420}, {findingsPanel(false), 420}}},
      {"export",
       {{exportPanel(""), 760}, {exportPanel("Nothing is planned yet. Press Plan."), 760}}},
  };
  for (const auto& [name, panels] : sheets) {
    QWidget sheet;
    auto* row = new QHBoxLayout(&sheet);
    row->setAlignment(Qt::AlignTop);
    for (const auto& [panel, height] : panels) {
      panel->setFixedWidth(options.value("width").toInt());
      if (height > 0)
        panel->setFixedHeight(height);
      row->addWidget(panel, 0, Qt::AlignTop);
    }
    sheet.show();
    sheet.adjustSize();
    for (int i = 0; i < 5; ++i)
      QApplication::processEvents();
    if (!sheet.grab().save(QDir(folder).filePath(QString("%1.png").arg(QLatin1String(name)))))
      return 1;
  }
  return 0;
}
