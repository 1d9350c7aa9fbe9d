// SPDX-License-Identifier: GPL-3.0-or-later
// Every text of the sources has a finished translation in every language, with the same placeholders.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>

static void initTranslations() { Q_INIT_RESOURCE(glenoid_translations); }  // wants the global namespace

namespace {

struct Message {
  QString context, source;
  QStringList translations;  ///< several for plurals
  QString type;              ///< "unfinished", "vanished", "obsolete" or empty
};

std::vector<Message> readTs(const QString& path) {
  std::vector<Message> messages;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return messages;
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == u"name") context = xml.readElementText();
    if (xml.name() == u"message") messages.push_back({context, {}, {}, {}});
    if (messages.empty()) continue;
    if (xml.name() == u"source") messages.back().source = xml.readElementText();
    if (xml.name() == u"translation") {
      messages.back().type = xml.attributes().value(QStringLiteral("type")).toString();
      QString plain;
      bool plural = false;
      while (!(xml.readNext() == QXmlStreamReader::EndElement && xml.name() == u"translation") && !xml.atEnd()) {
        if (xml.isCharacters()) plain += xml.text();
        if (xml.isStartElement() && xml.name() == u"numerusform") {
          plural = true;
          messages.back().translations << xml.readElementText();
        }
      }
      if (!plural) messages.back().translations << plain;
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return messages;
}

QStringList placeholders(const QString& text) {
  static const QRegularExpression pattern(QStringLiteral("%(?:\\d|n)"));
  QStringList found;
  for (auto it = pattern.globalMatch(text); it.hasNext();) found << it.next().captured();
  found.sort();
  return found;
}

std::string describe(const Message& message) {
  return (message.context + QStringLiteral(": “") + message.source + QStringLiteral("”")).toStdString();
}

/// The shipped file as it would be after lupdate: a text that is missing in it comes out unfinished.
std::vector<Message> updated(const QString& language) {
  const QString root = QStringLiteral(GLENOID_SOURCE_DIR);
  QTemporaryDir folder;
  const QString copy = folder.filePath(QStringLiteral("glenoid_%1.ts").arg(language));
  EXPECT_TRUE(QFile::copy(root + QStringLiteral("/translations/glenoid_%1.ts").arg(language), copy));
  QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
  QProcess lupdate;
  QStringList arguments{root + QStringLiteral("/app"), root + QStringLiteral("/editor"), QStringLiteral("-I"), root,
                        QStringLiteral("-locations"), QStringLiteral("none"), QStringLiteral("-ts"), copy};
  if (language == u"en") arguments.prepend(QStringLiteral("-pluralonly"));
  lupdate.start(QStringLiteral(GLENOID_LUPDATE), arguments);
  EXPECT_TRUE(lupdate.waitForFinished(60000));
  EXPECT_EQ(lupdate.exitCode(), 0) << lupdate.readAllStandardError().toStdString();
  return readTs(copy);
}

void expectComplete(const std::vector<Message>& messages) {
  for (const Message& message : messages) {
    EXPECT_NE(message.type, QStringLiteral("unfinished")) << "not translated: " << describe(message);
    EXPECT_NE(message.type, QStringLiteral("vanished")) << "no longer in the sources: " << describe(message);
    EXPECT_NE(message.type, QStringLiteral("obsolete")) << "no longer in the sources: " << describe(message);
    for (const QString& translation : message.translations) {
      EXPECT_FALSE(translation.isEmpty()) << "empty: " << describe(message);
    }
  }
}

TEST(Translations, spanishIsComplete) {
  const std::vector<Message> messages = updated(QStringLiteral("es"));
  EXPECT_GT(messages.size(), 150u) << "the sources have many texts; lupdate found few";
  expectComplete(messages);
}

TEST(Translations, englishHasItsPlurals) {
  const std::vector<Message> messages = updated(QStringLiteral("en"));
  EXPECT_GE(messages.size(), 3u);
  for (const Message& message : messages) EXPECT_EQ(message.translations.size(), 2) << describe(message);
  expectComplete(messages);
}

TEST(Translations, contextsAreThoseOfTheRunningProgram) {
  for (const Message& message : updated(QStringLiteral("es"))) {
    EXPECT_TRUE(message.context.startsWith(QStringLiteral("glenoid::"))) << describe(message);
  }
}

TEST(Translations, placeholdersAreTheSame) {
  for (const Message& message : updated(QStringLiteral("es"))) {
    const QStringList wanted = placeholders(message.source);
    for (const QString& form : message.translations) {
      EXPECT_EQ(placeholders(form), wanted) << describe(message) << " → " << form.toStdString();
    }
  }
}

TEST(Translations, theProgramCarriesThem) {
  initTranslations();
  EXPECT_TRUE(QFile::exists(QStringLiteral(":/translations/glenoid_es.qm")));
}

}  // namespace
