// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/PartMovement.h"

#include <QCoreApplication>
#include <algorithm>

#include "editor/core/AnatomyNames.h"

namespace glenoid {
namespace {

struct PartMovement {
  Q_DECLARE_TR_FUNCTIONS(glenoid::PartMovement)
};

}  // namespace

Movement movementOf(const Scenario& scenario, const std::string& part) {
  if (std::find(scenario.fixedParts.begin(), scenario.fixedParts.end(), part) != scenario.fixedParts.end()) return Movement::Fixed;
  const bool held = std::any_of(scenario.holds.begin(), scenario.holds.end(), [&](const Hold& hold) { return hold.part == part; });
  return held ? Movement::Held : Movement::Free;
}

bool setMovement(Document& document, const std::string& part, Movement movement) {
  const int index = findPart(document.joint(), part);
  if (index < 0 || movementOf(document.scenario(), part) == movement) return false;
  if (movement == Movement::Held && document.joint().parts[index].kind != PartKind::Rigid) return false;
  ChangeSet changes;
  changes.model = changes.settings = true;
  changes.parts = {part};
  const QString name = anatomyName(document.joint().parts[index].name);
  const QString text = movement == Movement::Fixed  ? PartMovement::tr("Fix “%1” in the room").arg(name)
                       : movement == Movement::Held ? PartMovement::tr("Hold “%1” by a spring").arg(name)
                                                    : PartMovement::tr("Let “%1” move freely").arg(name);
  document.edit(text, changes, [&](Scene& scene) {
    Scenario& scenario = scene.scenario;
    std::erase(scenario.fixedParts, part);
    std::erase_if(scenario.holds, [&](const Hold& hold) { return hold.part == part; });
    std::erase_if(scenario.motions, [&](const Motion& motion) { return motion.part == part; });
    if (movement == Movement::Fixed) {
      dropActionsOn(scenario, part);
      scenario.fixedParts.push_back(part);
    }
    if (movement == Movement::Held) {
      Hold hold;
      hold.part = part;
      scenario.holds.push_back(hold);
    }
  });
  return true;
}

bool foldsOntoItself(const Scenario& scenario, const std::string& part) {
  return std::find(scenario.selfContactParts.begin(), scenario.selfContactParts.end(), part) != scenario.selfContactParts.end();
}

bool setFoldsOntoItself(Document& document, const std::string& part, bool folds) {
  const int index = findPart(document.joint(), part);
  if (index < 0 || foldsOntoItself(document.scenario(), part) == folds) return false;
  if (document.joint().parts[index].kind != PartKind::Soft || movementOf(document.scenario(), part) == Movement::Fixed) return false;
  ChangeSet changes;
  changes.model = changes.settings = true;
  changes.parts = {part};
  const QString name = anatomyName(document.joint().parts[index].name);
  const QString text = folds ? PartMovement::tr("Let “%1” touch itself").arg(name) : PartMovement::tr("Let “%1” pass through itself").arg(name);
  document.edit(text, changes, [&](Scene& scene) {
    std::vector<std::string>& parts = scene.scenario.selfContactParts;
    if (folds)
      parts.push_back(part);
    else
      std::erase(parts, part);
  });
  return true;
}

Scene emptyScene(const QString& name) {
  Scene scene;
  scene.joint.id = scene.scenario.id = "untitled";
  scene.joint.name = scene.scenario.name = name.toStdString();
  scene.scenario.joint = "untitled.joint";
  return scene;
}

}  // namespace glenoid
