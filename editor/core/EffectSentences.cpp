// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/EffectSentences.h"

#include <QCoreApplication>
#include <QLocale>

namespace glenoid {
namespace {

// The command line has no translator, so one and many are told apart here.
struct EffectSentences {
  Q_DECLARE_TR_FUNCTIONS(glenoid::EffectSentences)
 public:
  static QString materials(double count) {
    return count == 1 ? tr("one material") : tr("%1 materials").arg(number(count));
  }
  static QString tools(double count) {
    return count == 1 ? tr("one tool") : tr("%1 tools").arg(number(count));
  }
  static QString parts(double count) {
    return count == 1 ? tr("one part") : tr("%1 parts").arg(number(count));
  }
  static QString couplings(double count) {
    return count == 1 ? tr("one coupling") : tr("%1 couplings").arg(number(count));
  }
  static QString number(double count) { return QLocale().toString(count, 'g', 6); }
  static QString both(const QString& a, double countA, const QString& b, double countB);

  static QString there(const EffectFacts& facts);
  static QString missing(const EffectFacts& facts);
  static QString of(const EffectFacts& facts);
};

/// Both, or the one that there is.
QString EffectSentences::both(const QString& a, double countA, const QString& b, double countB) {
  if (countB == 0) return a;
  return countA == 0 ? b : tr("%1 and %2", "two things counted").arg(a, b);
}

/// What the effect acts on.
QString EffectSentences::there(const EffectFacts& facts) {
  const auto n = [&](const char* what) { return facts.count(what); };
  if (facts.name == "gravity")
    return tr("%1 can move and gravity is %2 m/s²").arg(parts(n("movingParts")), number(n("acceleration")));
  if (facts.name == "couplings")
    return tr("the joint has %1, made of springs: %2").arg(couplings(n("couplings")), number(n("springs")));
  if (facts.name == "contact") {
    if (n("pairs") == 1) return tr("one pair of parts or tools can touch");
    return n("pairs") > 0 ? tr("%1 pairs of parts and tools can touch").arg(number(n("pairs")))
                          : tr("the joint has a bursa");
  }
  if (facts.name == "selfContact") return tr("contact with itself is wanted for %1").arg(parts(n("parts")));
  if (facts.name == "friction")
    return tr("a friction coefficient is given to %1")
        .arg(both(materials(n("materials")), n("materials"), tools(n("tools")), n("tools")));
  if (facts.name == "damping")
    return tr("damping is given to %1")
        .arg(both(materials(n("materials")), n("materials"), couplings(n("couplings")), n("couplings")));
  if (facts.name == "bursa")
    return n("bursae") == 1 ? tr("the joint has a bursa")
                            : tr("the joint has %1 bursae").arg(number(n("bursae")));
  if (facts.name == "dent")
    return tr("for %1 it is known how tissue gives under a tip, and there is a round tip on %2")
        .arg(parts(n("parts")), tools(n("tools")));
  if (facts.name == "haptics") return tr("a hand holds %1").arg(tools(n("tools")));
  return tr("the scene holds something it acts on");
}

/// What would be wanted for it to act.
QString EffectSentences::missing(const EffectFacts& facts) {
  const auto n = [&](const char* what) { return facts.count(what); };
  if (facts.name == "gravity")
    return n("movingParts") == 0 ? tr("no part can move") : tr("the scenario’s gravity is zero");
  if (facts.name == "couplings") return tr("the joint has no coupling");
  if (facts.name == "contact") return tr("no two parts or tools can touch");
  if (facts.name == "selfContact")
    return n("softParts") == 0 ? tr("no soft part can move")
                               : tr("the scenario names no part that may fold onto itself");
  if (facts.name == "friction")
    return n("materials") + n("tools") == 0
               ? tr("no material and no tool has a friction coefficient")
               : tr("of no two surfaces that can touch have both a friction coefficient");
  if (facts.name == "damping") return tr("no material and no coupling damps");
  if (facts.name == "bursa")
    return n("bursae") == 0 ? tr("the joint has no bursa") : tr("the joint’s bursae cover no surface");
  if (facts.name == "dent")
    return n("parts") == 0   ? tr("for no part it is known how tissue gives under a tip")
           : n("tools") == 0 ? tr("no tool has a round tip")
                             : tr("parts were changed after it had been found out how they give under a tip");
  return tr("nothing in the scene for it to act on");
}

QString EffectSentences::of(const EffectFacts& facts) {
  if (facts.reason == "asked-off") return tr("off, because the scenario switches it off");
  if (facts.reason == "no-contact") return tr("off, because contact is off");
  if (facts.reason == "not-built") return tr("off, because this version does not have it");
  if (facts.reason == "run-felt")
    return tr("off, because it is no part of a step: “run --realtime” and a device switch it on");
  if (!facts.on) return tr("off, because %1").arg(missing(facts));
  return (facts.reason == "asked-on" ? tr("on, because the scenario asks for it and %1")
                                     : tr("on, because %1"))
      .arg(there(facts));
}

}  // namespace

QString effectSentence(const EffectFacts& facts) {
  return EffectSentences::of(facts);
}

}  // namespace glenoid
