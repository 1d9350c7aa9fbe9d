// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

#include "editor/core/Document.h"

/// What an author says of the joint as a whole: each function is one undo step on the document, or does nothing and answers
/// false (the value is the same). GUI thread only.
namespace glenoid {

/// Not an empty name.
bool renameJoint(Document& document, const QString& name);
bool describeJoint(Document& document, const QString& description);
bool setJointLicence(Document& document, const QString& licence);
bool setJointAuthor(Document& document, const QString& author);
bool setJointSide(Document& document, JointSide side);

/// The joint of the other side of the body with its scenario and its recorded hands; the run begins anew. The recording
/// is the window's from now on: the scenario no longer names the file that it came from.
bool mirrorJoint(Document& document);

}  // namespace glenoid
