// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Studio.h"

#include <QApplication>
#include <QSettings>
#include <cstdio>
#include <cstdlib>

#include "app/StudioScene.h"
#include "app/WindowRecords.h"
#include "editor/core/Autosave.h"
#include "editor/core/Sentences.h"
#include "editor/ui/Language.h"
#include "editor/ui/MainWindow.h"
#include "editor/ui/Resources.h"
#include "editor/ui/Theme.h"
#include "editor/ui/Workspaces.h"

namespace glenoid {
namespace {

/// Whether Qt would find a display. Asked before a QApplication is made, because that aborts without one.
bool displayIsThere() {
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  if (platform && *platform) return true;  // somebody chose
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

}  // namespace

int runStudio(QApplication& application, const StudioOptions& options) {
  initGlenoidResources();
  QApplication::setOrganizationName(QStringLiteral("glenoid"));
  QApplication::setApplicationName(QStringLiteral("glenoid-studio"));
  application.setWindowIcon(QIcon(QStringLiteral(":/icons/glenoid.svg")));
  QSettings settings;
  setLanguage(settings.value(QStringLiteral("language"), systemLanguage()).toString());
  applyTheme(application, loadTheme(settings.value(QStringLiteral("dark"), true).toBool()));

  Document document;
  Selection selection;
  DisplayState display;
  PlayLink link(document);
  MainWindow window({document, link, display, selection}, probeGraphics(), loadScene, saveScene, startScene, labServices(QCoreApplication::applicationFilePath()));
  QObject::connect(&window, &MainWindow::languageWanted, [&settings](const QString& code) {
    setLanguage(code);
    settings.setValue(QStringLiteral("language"), code);
  });
  QObject::connect(&window, &MainWindow::themeWanted, [&](bool dark) {
    applyTheme(application, loadTheme(dark));
    settings.setValue(QStringLiteral("dark"), dark);
  });
  window.workspaces().show(settings.value(QStringLiteral("workspace")).toString());
  window.restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
  window.restoreState(settings.value(QStringLiteral("state")).toByteArray());
  WindowRecords records(document, link, window.tasks(), options.records);
  Autosave autosave(document, AutosaveSession::defaultRoot());
  QObject::connect(&autosave, &Autosave::failed, &window, [&window](const Error& error) { window.showProblem(sentenceOf(error)); });
  window.show();
  window.activateWindow();
  window.openScene(QString::fromStdString(options.file.empty() ? "builtin:arthroscopy" : options.file));
  window.offerRecovery(autosave.root());
  const int status = application.exec();
  settings.setValue(QStringLiteral("geometry"), window.saveGeometry());
  settings.setValue(QStringLiteral("state"), window.saveState());
  settings.setValue(QStringLiteral("workspace"), window.workspaces().current());
  return status;
}

int runStudio(int argc, char** argv, const StudioOptions& options) {
  if (!displayIsThere()) {
    const Error error{Fault::NoGraphics, {}, {}, "neither DISPLAY nor WAYLAND_DISPLAY is set"};
    std::fprintf(stderr, "%s\n", sentenceOf(error).toUtf8().constData());
    return 2;
  }
  prepareGraphics();
  QApplication application(argc, argv);
  return runStudio(application, options);
}

}  // namespace glenoid
