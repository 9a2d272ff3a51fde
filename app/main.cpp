// voluta: the window. `voluta [FILE]` opens a mesh, a project or sample:NAME.
#include "project/version.h"
#include "viewer/vtk_view.h"
#include "window/icons.h"
#include "window/language.h"
#include "window/main_window.h"
#include "window/theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <QTimer>

int main(int argc, char** argv) {
  using namespace voluta;
  // The surface format has to stand before the application does.
  viewer::VtkView::setDefaultFormat();
  QApplication app(argc, argv);
  QApplication::setApplicationName("voluta");
  QApplication::setOrganizationName("voluta");
  QApplication::setApplicationVersion(project::kVersion);
  QSettings::setDefaultFormat(QSettings::IniFormat);
  if (const QString state = qEnvironmentVariable("VOLUTA_STATE_DIR"); !state.isEmpty())
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, state);

  QCommandLineParser parser;
  parser.setApplicationDescription("Plans prints with a robot arm.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("file", "mesh, project (.voluta) or sample:NAME", "[file]");
  parser.process(app);

  const window::Appearance appearance =
      window::appearanceNamed(QSettings().value("window/appearance").toString());
  window::applyAppearance(app, appearance);
  window::chooseLanguage(window::wantedLanguage());
  QApplication::setWindowIcon(window::icon("voluta", app.palette()));

  window::MainWindow main(appearance);
  main.show();
  QTimer::singleShot(0, &main, [&] {
    main.offerRecovered();
    if (!parser.positionalArguments().isEmpty())
      main.open(parser.positionalArguments().first());
  });
  return QApplication::exec();
}
