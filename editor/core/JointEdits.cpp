// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/JointEdits.h"

#include <QCoreApplication>
#include <utility>

#include "editor/core/SameScene.h"
#include "simcore/author/MirrorJoint.h"

namespace glenoid {
namespace {

/// Texts of this file.
struct JointEdits {
  Q_DECLARE_TR_FUNCTIONS(glenoid::JointEdits)
};

/// One text of the joint; `of` answers where it stands.
template <class Of>
bool setText(Document& document, const QString& step, const QString& value, Of&& of) {
  Joint joint = document.joint();
  if (of(joint) == value.toStdString()) return false;
  ChangeSet changes;
  changes.model = true;  // a model knows its joint
  document.edit(step, changes, [&](Scene& scene) { of(scene.joint) = value.toStdString(); });
  return true;
}

}  // namespace

bool renameJoint(Document& document, const QString& name) {
  if (name.isEmpty()) return false;
  return setText(document, JointEdits::tr("Rename the joint to “%1”").arg(name), name, [](Joint& joint) -> std::string& { return joint.name; });
}

bool describeJoint(Document& document, const QString& description) {
  return setText(document, JointEdits::tr("Describe the joint"), description, [](Joint& joint) -> std::string& { return joint.description; });
}

bool setJointLicence(Document& document, const QString& licence) {
  return setText(document, JointEdits::tr("Change the licence of the joint"), licence,
                 [](Joint& joint) -> std::string& { return joint.provenance.license; });
}

bool setJointAuthor(Document& document, const QString& author) {
  return setText(document, JointEdits::tr("Say who made the joint"), author, [](Joint& joint) -> std::string& { return joint.provenance.author; });
}

bool setJointSide(Document& document, JointSide side) {
  if (document.joint().side == side) return false;
  ChangeSet changes;
  changes.model = true;
  const QString step = side == JointSide::Left    ? JointEdits::tr("Make it a left joint")
                       : side == JointSide::Right ? JointEdits::tr("Make it a right joint")
                                                  : JointEdits::tr("Make it a joint of no side");
  document.edit(step, changes, [&](Scene& scene) { scene.joint.side = side; });
  return true;
}

bool mirrorJoint(Document& document) {
  if (document.isEmpty()) return false;
  Scene after = document.scene();
  after.joint = mirroredJoint(after.joint);
  after.scenario = mirroredScenario(after.scenario);
  if (after.input) {
    after.input = std::make_shared<const Recording>(mirroredRecording(*after.input));
    after.scenario.input.clear();
  }
  ChangeSet changes = changesBetween(document.joint(), after.joint);
  changes.model = changes.settings = changes.restart = true;
  document.edit(JointEdits::tr("Mirror the joint"), changes, [&](Scene& scene) { scene = std::move(after); });
  return true;
}

}  // namespace glenoid
