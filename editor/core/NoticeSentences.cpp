// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/NoticeSentences.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "editor/core/PartName.h"
#include "editor/core/Sentences.h"

namespace glenoid {
namespace {

struct NoticeSentences {
  Q_DECLARE_TR_FUNCTIONS(glenoid::NoticeSentences)
 public:
  static QString of(const UnusedSetting& unused);
  static QString of(const Notice& notice, const NameOf& nameOf);
  static QString departure(const QString& word);
};

QString words(const std::string& id) { return QString::fromStdString(id); }
QString millimetres(double metres) { return QLocale().toString(metres * 1e3, 'g', 3); }
QString number(double value, int digits = 3) { return QLocale().toString(value, 'g', digits); }

/// "tool / part", each by its name.
template <class Name>
QString namesOf(const std::string& ids, const Name& name) {
  QStringList names;
  for (const QString& id : words(ids).split(QStringLiteral(" / "))) names << name(id.toStdString());
  return names.join(QStringLiteral(" / "));
}

QString NoticeSentences::of(const UnusedSetting& unused) {
  switch (unused.why) {
    case UnusedSetting::Why::NotBuilt:
      return tr("The effect “%1” is switched on, but no version has it yet: it does nothing.").arg(effectName(unused.name));
    case UnusedSetting::Why::LoadRise:
      return tr("Loads are to rise over %1 s, but the scenario has none: the time changes nothing.").arg(number(std::stod(unused.name)));
    case UnusedSetting::Why::Seed:
      return tr("The seed %1 changes nothing, since nothing in this version is drawn at random.").arg(words(unused.name));
  }
  return {};
}

// One case for each kind and no default: the compiler names the one that is missing. The forms of arg() with several
// texts leave a “%1” in a name alone.
QString NoticeSentences::of(const Notice& n, const NameOf& nameOf) {
  const auto name = [&](const std::string& id) { return nameOf ? nameOf(id) : words(id); };
  const QString time = number(n.time, 4);
  switch (n.kind) {
    case NoticeKind::UnusedSetting: return of(n.unused);
    case NoticeKind::EffectIdle:
      return tr("The effect “%1” is switched on, but the scene holds nothing for it to act on.").arg(effectName(n.subject));
    case NoticeKind::TooDeep:
      if (n.subject == n.other)
        return tr("“%1” lay %2 mm deep in itself at %3 s, beyond the limit of %4 mm: what the run says after that is not to be "
                  "trusted.")
            .arg(name(n.subject), millimetres(n.figure), time, millimetres(n.limit));
      return tr("“%1” and “%2” lay %3 mm deep in each other at %4 s, beyond the limit of %5 mm: what the run says after that is "
                "not to be trusted.")
          .arg(name(n.subject), name(n.other), millimetres(n.figure), time, millimetres(n.limit));
    case NoticeKind::TornAway:
      return tr("“%1” was carried %2 mm away by step %3 (%4 s), many times its own size of %5 mm: nothing holds it against its "
                "loads.")
          .arg(name(n.subject), millimetres(n.figure), QString::number(n.step), time, millimetres(n.limit));
    case NoticeKind::Overstretched:
      return tr("“%1” was stretched to %2 times its length by step %3 (%4 s), where any tissue is torn: its loads are too large or "
                "its material is too soft.")
          .arg(name(n.subject), number(n.figure), QString::number(n.step), time);
    case NoticeKind::InsideOut:
      return tr("In “%1” %2 of %3 elements were turned inside out, most so at step %4 (%5 s): its loads are too large or its material "
                "is too soft, and what the run says after that is not to be trusted.")
          .arg(name(n.subject), number(n.figure, 9), number(n.limit, 9), QString::number(n.step), time);
    case NoticeKind::Pressed:
      return tr("In “%1” %2 of %3 elements were pressed beyond three times their Young's modulus, most so at step %4 (%5 s): no law of "
                "this kind holds tissue that is pressed so hard.")
          .arg(name(n.subject), number(n.figure, 9), number(n.limit, 9), QString::number(n.step), time);
    case NoticeKind::MarkMissed:
      return tr("The mark “%1” (%2) was missed: nothing pressed with 1 N while it lasted, at steps of %3 ms.")
          .arg(words(n.subject), namesOf(n.other, name), number(n.figure * 1e3));
    case NoticeKind::PathCut:
      return tr("The steps are too long for the recording: the hand of “%1” passes its path at %2 s by %3 mm, and contact begins at "
                "%4 mm.")
          .arg(name(n.subject), time, millimetres(n.figure), millimetres(n.limit));
    case NoticeKind::Bounded:
      return tr("In %1 of %2 steps, first at step %3 (%4 s), contacts would have cost more than a step may: some of them were left out or "
                "the step was taken in fewer parts, so what parts do to each other there is only roughly right.")
          .arg(number(n.figure, 9), number(n.limit, 9), QString::number(n.step), time);
    case NoticeKind::TimeUp:
      if (n.subject.empty())
        return tr("The run took longer than %1 s and was stopped at step %2 (%3 s).").arg(number(n.limit), QString::number(n.step), time);
      return tr("The run took longer than %1 s and was stopped at step %2 (%3 s) with %4 contacts, most of them between “%5” and “%6”.")
          .arg(number(n.limit), QString::number(n.step), time, number(n.figure, 9), name(n.subject), name(n.other));
  }
  return {};
}

QString NoticeSentences::departure(const QString& word) {
  if (word == u"tension") return tr("the stiffness of taut tissue against turning is in A");
  if (word == u"recovery-cap") return tr("the speed at which penetration is undone is capped");
  if (word == u"parts") return tr("steps that turn too far are cut in parts");
  if (word == u"search-again") return tr("contacts are looked for again along unforeseen motion");
  if (word == u"stretch-law") return tr("overstretched and crushed tissue leaves the linear law");
  if (word == u"explicit-b") return tr("B is kept as a matrix");
  if (word == u"geometric-left-out") return tr("terms of turning levers are left out of ∂F/∂q");
  if (word == u"springs-in-regions") return tr("couplings are springs at points of their regions");
  return word;
}

}  // namespace

QString sentenceOf(const UnusedSetting& unused) { return NoticeSentences::of(unused); }

QString sentenceOf(const Notice& notice, const NameOf& nameOf) { return NoticeSentences::of(notice, nameOf); }

NameOf namesIn(const Joint& joint, const Scenario& scenario) {
  return [&joint, &scenario](const std::string& id) {
    const int tool = findTool(scenario, id);
    if (tool >= 0 && !scenario.tools[tool].name.empty() && findPart(joint, id) < 0) return words(scenario.tools[tool].name);
    return partName(joint, id);
  };
}

QString paperDeparture(const std::string& word) { return NoticeSentences::departure(words(word)); }

}  // namespace glenoid
