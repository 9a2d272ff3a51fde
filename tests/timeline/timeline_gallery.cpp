// Pictures of the time-line's widgets, to be looked at: timeline_gallery FOLDER
#include "timeline/joint_plots.h"
#include "timeline/layer_range_slider.h"
#include "timeline/sample_program.h"
#include "timeline/timeline_bar.h"

#include <QApplication>
#include <QDir>
#include <QEventLoop>
#include <QStyle>
#include <QStyleFactory>
#include <QVBoxLayout>
#include <cstdio>

using namespace voluta;
using namespace voluta::timeline;

namespace {
QPalette darkPalette() {
  QPalette p;
  p.setColor(QPalette::Window, QColor(45, 46, 50));
  p.setColor(QPalette::Base, QColor(32, 33, 36));
  p.setColor(QPalette::Button, QColor(56, 57, 62));
  p.setColor(QPalette::Mid, QColor(90, 92, 98));
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(role, QColor(232, 232, 232));
  p.setColor(QPalette::Highlight, QColor(74, 144, 217));
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, QColor(125, 125, 125));
  return p;
}

std::vector<double> heights(int count) {
  std::vector<double> top;
  for (int i = 0; i < count; ++i)
    top.push_back(0.8 * (i + 1));
  return top;
}

bool grab(const QString& folder, const QString& suffix) {
  const test::SampleProgram p = test::sampleProgram(40, 200, 0.11);
  QWidget page;
  auto* column = new QVBoxLayout(&page);
  auto* bar = new TimelineBar(&page);
  bar->setClock(std::make_shared<Clock>(p.trajectory, p.toolPlan));
  bar->setMarks({{120.0, false, "turns fast"}, {400.0, true, "collision"}, {405.0, false, "near"}});
  bar->setTimeS(300.0);
  column->addWidget(bar);
  auto* moves = new TimelineBar(&page);
  moves->setMoveCount(3470);
  moves->setMode(BarMode::Moves);
  moves->setMove(1200);
  column->addWidget(moves);
  column->addWidget(new TimelineBar(&page));
  auto* plots = new JointPlots(&page);
  auto* row = new QHBoxLayout;
  row->addWidget(plots, 1);
  for (const bool withHeights : {true, false}) {
    auto* layers = new LayerRangeSlider(&page);
    layers->setLayers(125, withHeights ? heights(125) : std::vector<double>());
    layers->setRange(withHeights ? 40 : 60, withHeights ? 100 : 62);
    row->addWidget(layers);
  }
  auto* single = new LayerRangeSlider(&page);
  single->setLayers(125, heights(125));
  single->setRange(0, 124);
  row->addWidget(single);
  row->addWidget(new LayerRangeSlider(&page));
  column->addLayout(row, 1);
  page.resize(1100, 620);
  page.show();
  QEventLoop loop;
  QObject::connect(plots, &JointPlots::ready, &loop, &QEventLoop::quit);
  plots->setTrajectory(p.trajectory, test::sampleLimits());
  loop.exec();
  plots->setTimeS(300.0);
  QApplication::processEvents();
  return page.grab().save(QDir(folder).filePath(QStringLiteral("timeline-%1.png").arg(suffix)));
}
} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "timeline_gallery FOLDER\n");
    return 2;
  }
  QApplication app(argc, argv);
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  const QString scale = qEnvironmentVariable("QT_SCALE_FACTOR", "1");
  const QPalette light = QApplication::style()->standardPalette();
  bool saved = true;
  for (const bool dark : {false, true}) {
    QApplication::setPalette(dark ? darkPalette() : light);
    saved = grab(argv[1], QStringLiteral("%1-%2").arg(dark ? "dark" : "light", scale)) && saved;
  }
  return saved ? 0 : 3;
}
