// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/scene/Joint.h"
#include "simcore/scene/Recording.h"
#include "simcore/scene/Scenario.h"

/// Left from right: mirror images in the body's sagittal plane, z = 0 of W. Each of these done twice gives the same bits.
namespace glenoid {

/// The joint of the other side of the body. Meshes look outwards, regions, couplings and cages hold as they did, what was
/// proved of the start or computed as dents stays so. In names, words that say a side become those of the other one (see
/// otherSideIn). Ids stay, since others refer to them, and so do sentences (descriptions, reasons), where such a word may
/// mean something else: see sideWordsOf.
Joint mirroredJoint(const Joint& joint);

/// Gravity, loads, holds, motions, cameras and the homes of tools. A tool is its own mirror image (its hook lies in its own
/// plane y = 0), so its mirrored pose is that of the same tool.
Scenario mirroredScenario(const Scenario& scenario);

/// The poses of the hands. What was expected of the run (hashes) goes: it was of the other joint.
Recording mirroredRecording(const Recording& recording);

/// Pose of a tool whose shape is symmetric about y = 0 of its own frame.
Pose mirroredTool(const Pose& pose);

/// The text with every word that says a side replaced by that of the other one: left and right, dexter and sinister with
/// their endings, izquierdo and derecho with theirs; as they are written (left, Left, LEFT), whole words only.
std::string otherSideIn(const std::string& text);

/// Where a joint says a side: what mirroredJoint changes, and what it leaves for its author to look at.
struct SideWords {
  std::vector<std::string> names;      ///< mirroredJoint makes them say the other one
  std::vector<std::string> ids;        ///< it keeps them
  std::vector<std::string> sentences;  ///< it keeps them: descriptions and reasons
};
SideWords sideWordsOf(const Joint& joint);

}  // namespace glenoid
