// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/SettingWords.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

/// Texts of this file.
struct SettingWords {
  Q_DECLARE_TR_FUNCTIONS(glenoid::SettingWords)
 public:
  static QString digits(double value) { return std::isfinite(value) ? QLocale().toString(value, 'g', 3) : QStringLiteral("–"); }
  /// Digits of an id, such as "0.625" of "0.625ms", as people write them.
  static QString figure(QString words, const char* unit) {
    words.chop(static_cast<int>(qstrlen(unit)));
    bool good = false;
    const double value = words.toDouble(&good);
    return good ? QLocale().toString(value, 'g', 6) : words;
  }
  static QString profile(Profile profile) {
    switch (profile) {
      case Profile::Paper: return tr("solved as published");
      case Profile::Reference: return tr("solved by the reference");
      case Profile::Direct: break;
    }
    return tr("solved directly");
  }
  static QString elements(const QString& word) {
    if (word == u"cells") return tr("whole cells for elements");
    if (word == u"tetrahedra") return tr("tetrahedra for elements");
    return tr("elements as each part has them");
  }
  static QString addition(const QString& word) {
    if (word == u"all") return tr("with all of our additions");
    if (word == u"tension") return tr("with stiffness of what is under tension");
    if (word == u"recovery-cap") return tr("with its recovery speed capped");
    if (word == u"parts") return tr("with steps cut in parts");
    if (word == u"search-again") return tr("with a second search");
    if (word == u"stretch-law") return tr("with the law of far stretched tissue");
    return word;
  }
  static QString one(const QString& key, const QString& value) {
    if (key == u"profile") return value == u"paper" ? profile(Profile::Paper) : value == u"reference" ? profile(Profile::Reference) : profile(Profile::Direct);
    if (key == u"elements") return elements(value);
    if (key == u"cells") return value == u"2" ? tr("twice as many tetrahedra") : tr("%1 times as many tetrahedra").arg(value);
    if (key == u"contact-surfaces") return tr("the visual surfaces touch");
    if (key == u"dt") return tr("steps of %1 ms").arg(figure(value, "ms"));
    if (key == u"contact-distance") return tr("contact from %1 mm on").arg(figure(value, "mm"));
    if (key == u"recovery-speed") return tr("recovery at %1 mm/s at most").arg(figure(value, "mm/s"));
    if (key == u"paper") {
      QStringList words;
      for (const QString& word : value.split(u'+')) words << addition(word);
      return words.join(tr(", "));
    }
    if (key == u"cg-tolerance") return tr("conjugate gradients to %1").arg(value);
    if (key == u"outer") return tr("%1 outer iterations at most").arg(value);
    if (key == u"outer-tolerance") return tr("outer iterations to %1").arg(value);
    if (key == u"lambda-max") return value == u"0" ? tr("the splitting holds whole parts") : tr("λmax up to %1").arg(value);
    if (key == u"inner") return tr("%1 inner sweeps").arg(value);
    return key + QLatin1Char('=') + value;
  }
  static QString failure(const std::string& failure, const QString& detail) {
    if (failure == "not-built") return tr("could not be built: %1").arg(detail);
    const auto count = detail.split(u' ');  // "3 of 40 steps"
    if (failure == "not-finite") return tr("%1 of %2 steps were not finite").arg(count.value(0, detail), count.value(2));
    if (failure == "diverged") return tr("%1 of %2 steps diverged").arg(count.value(0, detail), count.value(2));
    return QString::fromStdString(failure);
  }
  static QString quantity(AccuracyQuantity quantity) {
    switch (quantity) {
      case AccuracyQuantity::Displacement: return tr("displacement");
      case AccuracyQuantity::ContactForce: return tr("contact force");
      case AccuracyQuantity::Penetration: return tr("penetration");
      case AccuracyQuantity::HandForce: return tr("force on the hand");
    }
    return {};
  }
  static QString against(AccuracyAgainst against) {
    return against == AccuracyAgainst::OwnCells ? tr("the same cells, very small steps") : tr("finer cells, smaller steps");
  }
  static QString family(const std::string& family) {
    if (family == "scene") return tr("the scene");
    if (family == "time-step") return tr("time step");
    if (family == "profile") return tr("solver");
    if (family == "elements") return tr("elements");
    if (family == "cells") return tr("cell size");
    if (family == "surfaces") return tr("surfaces");
    if (family == "contact") return tr("contact");
    if (family == "paper") return tr("published method");
    return QString::fromStdString(family);
  }
  static QString elementsOf(const std::optional<Elements>& elements) {
    return SettingWords::elements(!elements ? QString() : *elements == Elements::Cells ? QStringLiteral("cells") : QStringLiteral("tetrahedra"));
  }
  static QString changed(const Scene& before, const Scene& after) {
    const Scenario &was = before.scenario, &is = after.scenario;
    QStringList said;
    const auto say = [&](const QString& now, const QString& then) { said << tr("%1 in place of %2").arg(now, then); };
    if (is.dt != was.dt) say(tr("steps of %1 ms").arg(QLocale().toString(1e3 * is.dt, 'g', 6)), tr("%1 ms").arg(QLocale().toString(1e3 * was.dt, 'g', 6)));
    if (is.profile != was.profile) say(profile(is.profile), profile(was.profile));
    if (is.elements != was.elements) say(elementsOf(is.elements), elementsOf(was.elements));
    if (is.contactDistance != was.contactDistance)
      say(tr("contact from %1 mm on").arg(digits(1e3 * is.contactDistance)), tr("%1 mm").arg(digits(1e3 * was.contactDistance)));
    if (is.recoverySpeedMax != was.recoverySpeedMax)
      say(tr("recovery at %1 mm/s at most").arg(digits(1e3 * is.recoverySpeedMax)), tr("%1 mm/s").arg(digits(1e3 * was.recoverySpeedMax)));
    const auto tetrahedra = [](const Joint& joint) {
      std::size_t count = 0;
      for (const Part& part : joint.parts) count += part.volume ? part.volume->tets.size() : 0;
      return count;
    };
    if (const auto now = tetrahedra(after.joint), then = tetrahedra(before.joint); now != then)
      say(tr("%1 tetrahedra").arg(QLocale().toString(static_cast<qulonglong>(now))), QLocale().toString(static_cast<qulonglong>(then)));
    const auto own = [](const Joint& joint) {
      return std::count_if(joint.parts.begin(), joint.parts.end(), [](const Part& part) { return part.collision == part.visual; });
    };
    if (own(after.joint) > own(before.joint)) said << tr("the visual surfaces touch");
    else if (own(after.joint) < own(before.joint)) said << tr("the simplified surfaces touch again");
    if (said.isEmpty()) return {};
    QString sentence = said.join(tr("; ")) + QLatin1Char('.');
    sentence[0] = sentence[0].toUpper();
    return sentence;
  }
};

}  // namespace

QString settingWords(const std::string& id) {
  if (id == "scene") return SettingWords::tr("the scene as it is");
  QStringList words;
  for (const QString& entry : QString::fromStdString(id).split(u','))
    words << SettingWords::one(entry.section(u'=', 0, 0), entry.section(u'=', 1));
  return words.join(SettingWords::tr("; "));
}

QString failureWords(const std::string& failure, const std::string& detail) { return SettingWords::failure(failure, QString::fromStdString(detail)); }

QString quantityName(AccuracyQuantity quantity) { return SettingWords::quantity(quantity); }

QString againstName(AccuracyAgainst against) { return SettingWords::against(against); }

QString familyName(const std::string& family) { return SettingWords::family(family); }

QString errorText(AccuracyQuantity quantity, double shown) {
  if (!std::isfinite(shown)) return QStringLiteral("–");
  const bool length = quantity == AccuracyQuantity::Displacement || quantity == AccuracyQuantity::Penetration;
  return (length ? SettingWords::tr("%1 mm") : SettingWords::tr("%1 N")).arg(SettingWords::digits(shown));
}

QString msText(double ms) { return std::isfinite(ms) ? SettingWords::tr("%1 ms").arg(SettingWords::digits(ms)) : QStringLiteral("–"); }

QString changedSentence(const Scene& before, const Scene& after) { return SettingWords::changed(before, after); }

}  // namespace glenoid
