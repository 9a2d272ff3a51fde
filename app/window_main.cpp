// voluta: the window. `voluta [FILE]` opens a mesh, a project or sample:NAME.
#include "base/outcome.h"
#include "cli/exit_code.h"
#include "language/words.h"
#include "modes/cell_choice.h"
#include "pipeline/automatic.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/version.h"
#include "viewer/vtk_view.h"
#include "window/language.h"
#include "window/main_window.h"
#include "window/window_icons.h"
#include "window/window_theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QMessageBox>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {
using namespace voluta;

void describe(QCommandLineParser& parser) {
  QCoreApplication::setApplicationName("voluta");
  QCoreApplication::setOrganizationName("voluta");
  QCoreApplication::setApplicationVersion(project::kVersion);
  parser.setApplicationDescription("Plans 3D printing with robot arms.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("file", "mesh, project (.voluta) or sample:NAME", "[file]");
}

bool asksForWords(int argc, char** argv) {
  constexpr std::string_view kWords[] = {"-h", "--help", "--help-all", "-v", "--version"};
  return std::any_of(argv + 1, argv + argc, [&](const char* argument) {
    return std::find(std::begin(kWords), std::end(kWords), argument) != std::end(kWords);
  });
}

// Without a display, Qt ends a program by abort(), which leaves a core file.
void leaveWithoutDisplay(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type != QtFatalMsg) {
    std::fprintf(stderr, "%s\n", qPrintable(message));
    return;
  }
  std::fputs("voluta: cannot open a display. voluta-cli plans, verifies and draws "
             "without one.\n",
             stderr);
  std::_Exit(1);
}

// Checks the data that a new project uses. Throws Error if the program's data is missing.
bool readUsualData() {
  const project::Choices usual;
  modes::cellOnAnyPlatform(usual, process::loadProcess(usual.tool().process));
  return true;
}

// Also shows the error in a dialog: users who start the window from a menu see no terminal.
int leaveWith(const base::Error& error) {
  std::fprintf(stderr, "voluta: %s\n", error.what());
  const QString platform = QGuiApplication::platformName();
  if (platform != "offscreen" && platform != "minimal") // Such a dialog could not be closed
    QMessageBox::critical(nullptr, "Voluta", language::words(error.whole()));
  return cli::exitCodeOf(error.code());
}
} // namespace

int main(int argc, char** argv) {
  QCommandLineParser parser;
  describe(parser);
  if (asksForWords(argc, argv)) {
    const QCoreApplication words(argc, argv);
    parser.process(words); // Prints and exits
    return 0;
  }
  // The surface format must be set before the application is created.
  viewer::VtkView::setDefaultFormat();
  const QtMessageHandler usual = qInstallMessageHandler(leaveWithoutDisplay);
  QApplication app(argc, argv);
  qInstallMessageHandler(usual);
  QSettings::setDefaultFormat(QSettings::IniFormat);
  if (const QString state = qEnvironmentVariable("VOLUTA_STATE_DIR"); !state.isEmpty())
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, state);
  parser.process(app);

  const window::Appearance appearance =
      window::appearanceNamed(QSettings().value("window/appearance").toString());
  window::applyAppearance(app, appearance);
  window::chooseLanguage(window::wantedLanguage());
  QApplication::setWindowIcon(window::icon("voluta", app.palette()));

  const auto data = base::outcomeOf(readUsualData);
  if (const auto* error = std::get_if<base::Error>(&data))
    return leaveWith(*error);
  window::MainWindow main(appearance);
  project::Choices start;
  start.item().automatic = true;
  main.document().startWith(pipeline::automaticChoices(start).front());
  main.show();
  QTimer::singleShot(0, &main, [&] {
    main.offerRecovered();
    if (!parser.positionalArguments().isEmpty())
      main.open(parser.positionalArguments().first());
  });
  return QApplication::exec();
}
