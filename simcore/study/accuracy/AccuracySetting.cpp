// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/accuracy/AccuracySetting.h"

#include <charconv>
#include <iterator>

#include "simcore/live/RunReport.h"
#include "simcore/scene/JointFile.h"
#include "simcore/study/RefineJoint.h"

namespace glenoid {
namespace {

/// The shortest text that reads back as the same number: 2.5, 1e-04.
std::string shortest(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  return std::string(digits, end);
}

/// In thousandths, without the digits that the factor 1000 adds at the end of the double: 0.0003125 is 0.3125.
std::string thousandths(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, 1e3 * value, std::chars_format::general, 6).ptr;
  return std::string(digits, end);
}

constexpr const char* kAdditions[] = {"tension", "recovery-cap", "parts", "search-again", "stretch-law"};  ///< words of PaperSettings
constexpr double kTimeStepMost = 0.1;  ///< s: no scenario may have a longer one

struct Sweep {
  AccuracySetting base;
  std::vector<AccuracySetting> settings;

  template <class Change>
  void add(const char* family, const Change& change) {
    AccuracySetting setting = base;
    setting.family = family;
    change(setting);
    if (setting.dt > kTimeStepMost) return;
    nameSetting(setting, base);
    for (const AccuracySetting& known : settings)
      if (known.id == setting.id) return;  // the scene has it already
    settings.push_back(std::move(setting));
  }
};

void sweepPaper(Sweep& sweep, bool quick) {
  const auto paper = [&](const auto& change) {
    sweep.add("paper", [&](AccuracySetting& s) {
      s.profile = Profile::Paper;
      change(s);
    });
  };
  sweep.add("profile", [](AccuracySetting& s) { s.profile = Profile::Paper; });
  paper([](AccuracySetting& s) { s.paper = PaperSettings::all(); });
  if (quick) return;
  for (const double tolerance : {1e-2, 1e-4, 1e-9}) paper([&](AccuracySetting& s) { s.paperLimits.cgTolerance = tolerance; });
  for (const int outer : {10, 160}) paper([&](AccuracySetting& s) { s.paperLimits.outerIterations = outer; });
  paper([](AccuracySetting& s) {
    s.paperLimits.outerIterations = 400;
    s.paperLimits.outerTolerance = 1e-7;
  });
  for (const int inner : {5, 120}) paper([&](AccuracySetting& s) { s.paperLimits.innerSweeps = inner; });
  paper([](AccuracySetting& s) { s.paperLimits.lambdaMaxForNodes = 0; });  // D holds whole objects everywhere
  for (const char* word : kAdditions) paper([&](AccuracySetting& s) { *paperSetting(s.paper, word) = true; });
}

bool hasSoftParts(const Model& base) {
  for (const SceneObject& object : base.objects)
    if (object.volume && object.layout.free) return true;
  return false;
}

}  // namespace

AccuracySetting settingOf(const Model& base) {
  AccuracySetting setting;
  setting.id = setting.family = "scene";
  setting.profile = base.scenario.profile;
  setting.dt = base.scenario.dt;
  setting.elements = base.scenario.elements;
  setting.contactDistance = base.scenario.contactDistance;
  setting.recoverySpeedMax = base.scenario.recoverySpeedMax;
  return setting;
}

std::vector<AccuracySetting> accuracySettings(const Model& base, bool quick) {
  Sweep sweep{settingOf(base), {}};
  const double dt = sweep.base.dt;
  sweep.settings.push_back(sweep.base);
  for (const double times : quick ? std::vector{4.0, 2.0, 0.5} : std::vector{4.0, 2.0, 0.5, 0.25, 0.125})
    sweep.add("time-step", [&](AccuracySetting& s) { s.dt = times * dt; });
  sweep.add("profile", [](AccuracySetting& s) { s.profile = Profile::Direct; });
  sweep.add("profile", [](AccuracySetting& s) { s.profile = Profile::Reference; });
  if (hasSoftParts(base)) {
    for (const Elements elements : {Elements::Tetrahedra, Elements::Cells})
      for (const double times : quick ? std::vector{1.0} : std::vector{1.0, 0.5})
        sweep.add("elements", [&](AccuracySetting& s) {
          s.elements = elements;
          s.dt = times * dt;
        });
    for (const double cells : quick ? std::vector{2.0} : std::vector{2.0, 4.0})
      for (const double times : quick ? std::vector{1.0} : std::vector{4.0, 2.0, 1.0, 0.5})
        sweep.add("cells", [&](AccuracySetting& s) {
          s.cells = cells;
          s.dt = times * dt;
        });
    if (!quick)
      sweep.add("cells", [&](AccuracySetting& s) {
        s.cells = 2;
        s.elements = Elements::Cells;
      });
  }
  if (!base.collisionPairs.empty()) {
    sweep.add("surfaces", [](AccuracySetting& s) { s.visualContact = true; });
    if (!quick)
      for (const double times : {0.5, 2.0}) {
        sweep.add("contact", [&](AccuracySetting& s) { s.contactDistance *= times; });
        sweep.add("contact", [&](AccuracySetting& s) { s.recoverySpeedMax *= times; });
      }
  }
  sweepPaper(sweep, quick);
  return std::move(sweep.settings);
}

void nameSetting(AccuracySetting& setting, const AccuracySetting& base) {
  std::string id;
  const auto say = [&](const std::string& what) { id += (id.empty() ? "" : ",") + what; };
  if (setting.profile != base.profile) say(std::string("profile=") + profileName(setting.profile));
  if (setting.elements != base.elements)
    say(!setting.elements ? "elements=own" : *setting.elements == Elements::Cells ? "elements=cells" : "elements=tetrahedra");
  if (setting.cells != base.cells) say("cells=" + shortest(setting.cells));
  if (setting.visualContact != base.visualContact) say("contact-surfaces=visual");
  if (setting.dt != base.dt) say("dt=" + thousandths(setting.dt) + "ms");
  if (setting.contactDistance != base.contactDistance) say("contact-distance=" + thousandths(setting.contactDistance) + "mm");
  if (setting.recoverySpeedMax != base.recoverySpeedMax) say("recovery-speed=" + thousandths(setting.recoverySpeedMax) + "mm/s");
  std::size_t additions = 0;
  std::string words;
  PaperSettings ours = setting.paper, theirs = base.paper;
  for (const char* word : kAdditions)
    if (*paperSetting(ours, word) != *paperSetting(theirs, word)) {
      ++additions;
      words += std::string(words.empty() ? "" : "+") + word;
    }
  if (additions) say("paper=" + (additions == std::size(kAdditions) ? "all" : words));
  const PaperLimits &limits = setting.paperLimits, &known = base.paperLimits;
  if (limits.cgTolerance != known.cgTolerance) say("cg-tolerance=" + shortest(limits.cgTolerance));
  if (limits.outerIterations != known.outerIterations) say("outer=" + std::to_string(limits.outerIterations));
  if (limits.outerTolerance != known.outerTolerance) say("outer-tolerance=" + shortest(limits.outerTolerance));
  if (limits.lambdaMaxForNodes != known.lambdaMaxForNodes) say("lambda-max=" + shortest(limits.lambdaMaxForNodes));
  if (limits.innerSweeps != known.innerSweeps) say("inner=" + std::to_string(limits.innerSweeps));
  setting.id = id.empty() ? "scene" : id;
}

bool hasOwnCells(const AccuracySetting& setting, const AccuracySetting& base) {
  return setting.cells == base.cells && setting.elements == base.elements && setting.visualContact == base.visualContact;
}

bool fitsScenario(const AccuracySetting& setting) {
  if (setting.profile != Profile::Paper) return true;
  PaperSettings additions = setting.paper;
  for (const char* word : kAdditions)
    if (*paperSetting(additions, word)) return false;
  return setting.paperLimits == PaperLimits();
}

Scenario scenarioWith(const AccuracySetting& setting, Scenario scenario) {
  scenario.profile = setting.profile;
  scenario.dt = setting.dt;
  scenario.elements = setting.elements;
  scenario.contactDistance = setting.contactDistance;
  scenario.recoverySpeedMax = setting.recoverySpeedMax;
  return scenario;
}

Result<Joint> jointWith(const AccuracySetting& setting, const Joint& joint) {
  Result<Joint> made = refineCells(joint, setting.cells);
  if (!made) return made;
  if (setting.visualContact)
    for (Part& part : made->parts) part.collision = part.visual;
  // A table of dents is of the tissue, whose surface, materials and couplings are the same; the step takes off what the
  // elements give that it has.
  for (std::size_t i = 0; i < joint.parts.size(); ++i) {
    Part& part = made->parts[i];
    if (!part.dents || part.dents->basis != dentBasis(joint, joint.parts[i])) continue;
    DentTable dents = *part.dents;
    dents.basis = dentBasis(*made, part);
    part.dents = std::make_shared<const DentTable>(std::move(dents));
  }
  return made;
}

StepperOptions stepperWith(const AccuracySetting& setting) {
  StepperOptions options;
  options.profile = setting.profile;
  options.paper = setting.paper;
  options.paperLimits = setting.paperLimits;
  return options;
}

}  // namespace glenoid
