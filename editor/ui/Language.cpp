// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/Language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace glenoid {
namespace {

struct Installed {
  QString code;
  QTranslator ours, qts;
};

// Lives as long as the program: QCoreApplication keeps pointers to translators.
Installed& installed() {
  static Installed translators;
  return translators;
}

}  // namespace

QStringList languages() { return {QStringLiteral("en"), QStringLiteral("es")}; }

QString languageName(const QString& code) {
  return code == u"es" ? QStringLiteral("Español") : QStringLiteral("English");
}

QString systemLanguage() {
  const QString code = QLocale::system().name().section(QLatin1Char('_'), 0, 0);
  return languages().contains(code) ? code : languages().first();
}

void setLanguage(const QString& code) {
  Installed& now = installed();
  const QString wanted = languages().contains(code) ? code : languages().first();
  if (wanted == now.code) return;
  now.code = wanted;
  // Numbers that people read; files and devices do not ask this locale. A regional one of the same language wins.
  const QLocale system = QLocale::system(), plain(wanted);
  QLocale::setDefault(system.language() == plain.language() ? system : plain);
  QCoreApplication::removeTranslator(&now.ours);
  QCoreApplication::removeTranslator(&now.qts);
  // Qt's own words (file dialog, OK, Cancel) come with Qt where they are installed.
  const bool qts = now.qts.load(QStringLiteral("qtbase_") + wanted,
                                QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  if (qts) QCoreApplication::installTranslator(&now.qts);
  // English has a file, too: it holds the plurals alone.
  if (now.ours.load(QStringLiteral(":/translations/glenoid_%1.qm").arg(wanted))) {
    QCoreApplication::installTranslator(&now.ours);
  }
}

QString currentLanguage() { return installed().code.isEmpty() ? languages().first() : installed().code; }

}  // namespace glenoid
