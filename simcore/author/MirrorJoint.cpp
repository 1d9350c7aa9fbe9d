// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MirrorJoint.h"

#include <algorithm>
#include <cctype>

#include "simcore/author/MoveJoint.h"

namespace glenoid {
namespace {

Vec3 mirrored(const Vec3& v) { return {v.x(), v.y(), -v.z()}; }
/// A torque or a rotation vector turns the other way about what lies in the plane.
Vec3 mirroredAxial(const Vec3& v) { return {-v.x(), -v.y(), v.z()}; }
/// S R S with S = diag(1, 1, −1).
Quat mirroredTurn(const Quat& q) { return {q.w(), -q.x(), -q.y(), q.z()}; }

/// Calls `what` for every name of a joint that people read.
template <class AnyJoint, class What>
void eachName(AnyJoint& joint, What&& what) {
  what(joint.name);
  for (auto& part : joint.parts) {
    what(part.name);
    for (auto& region : part.regions) what(region.name);
    for (auto& landmark : part.landmarks) what(landmark.name);
  }
  for (auto& bursa : joint.bursae) what(bursa.name);
}

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80; }

std::string lower(std::string word) {
  for (char& c : word)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return word;
}
std::string upper(std::string word) {
  for (char& c : word)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return word;
}

/// The word of the other side in small letters, or empty.
std::string opposite(const std::string& word) {
  static constexpr const char* kPairs[][2] = {{"left", "right"},           {"sinister", "dexter"},      {"sinistra", "dextra"},
                                              {"sinistrum", "dextrum"},    {"sinistri", "dextri"},      {"sinistrae", "dextrae"},
                                              {"izquierdo", "derecho"},    {"izquierda", "derecha"},    {"izquierdos", "derechos"},
                                              {"izquierdas", "derechas"}};
  for (const auto& pair : kPairs)
    for (int side = 0; side < 2; ++side)
      if (word == pair[side]) return pair[1 - side];
  return {};
}

/// As the pattern is written: small, capital or with a capital; anything else counts as small.
std::string writtenAs(const std::string& word, const std::string& pattern) {
  if (pattern == upper(pattern)) return upper(word);
  if (pattern[0] >= 'A' && pattern[0] <= 'Z') return upper(word.substr(0, 1)) + word.substr(1);
  return word;
}
bool isPlainlyWritten(const std::string& word) {
  const std::string small = lower(word);
  return word == small || word == upper(word) || word == upper(small.substr(0, 1)) + small.substr(1);
}

}  // namespace

std::string otherSideIn(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && isLetter(text[end])) ++end;
    if (end == i) {
      out += text[i++];
      continue;
    }
    const std::string word = text.substr(i, end - i), other = isPlainlyWritten(word) ? opposite(lower(word)) : std::string();
    out += other.empty() ? word : writtenAs(other, word);
    i = end;
  }
  return out;
}

SideWords sideWordsOf(const Joint& joint) {
  SideWords words;
  std::vector<std::string>* into = &words.names;
  const auto look = [&](const std::string& text) {
    if (otherSideIn(text) != text) into->push_back(text);
  };
  eachName(joint, look);
  into = &words.sentences;
  look(joint.description);
  for (const Coupling& coupling : joint.couplings) look(coupling.reason);
  for (const Exclusion& exclusion : joint.exclusions) look(exclusion.reason);
  into = &words.ids;
  look(joint.id);
  for (const Part& part : joint.parts) {
    look(part.id);
    for (const Region& region : part.regions) look(region.id);
    for (const Landmark& landmark : part.landmarks) look(landmark.id);
  }
  for (const Coupling& coupling : joint.couplings) look(coupling.id);
  for (const Bursa& bursa : joint.bursae) look(bursa.id);
  for (const Cage& cage : joint.cages) look(cage.id);
  return words;
}

Joint mirroredJoint(const Joint& joint) {
  Joint out = movedJoint(joint, {Vec3(1, 1, -1).asDiagonal(), Vec3::Zero()});
  out.side = otherSide(joint.side);
  eachName(out, [](std::string& text) { text = otherSideIn(text); });
  return out;
}

Pose mirroredTool(const Pose& pose) {
  // S R S' with S = diag(1, 1, −1) of W and S' = diag(1, −1, 1) of the tool: a rotation, by k q j of its quaternion.
  const Quat& q = pose.q_WB;
  return {mirrored(pose.p_WB), Quat(q.x(), q.w(), q.z(), q.y())};
}

Scenario mirroredScenario(const Scenario& scenario) {
  Scenario out = scenario;
  out.name = otherSideIn(out.name);
  out.gravity_W = mirrored(out.gravity_W);
  for (Load& load : out.loads) {
    load.force_W = mirrored(load.force_W);
    load.torque_W = mirroredAxial(load.torque_W);
    if (load.point_W) load.point_W = mirrored(*load.point_W);
  }
  for (Motion& motion : out.motions) {
    motion.centre_W = mirrored(motion.centre_W);
    for (MotionKey& key : motion.keys) {
      key.displacement_W = mirrored(key.displacement_W);
      key.turn_W = mirroredTurn(key.turn_W);
    }
  }
  for (Tool& tool : out.tools) {
    tool.name = otherSideIn(tool.name);
    tool.home = mirroredTool(tool.home);
    tool.lensTurn = -tool.lensTurn;
  }
  out.training.text = otherSideIn(out.training.text);
  for (Task& task : out.training.tasks) {
    for (std::string* text : {&task.name, &task.text, &task.hint}) *text = otherSideIn(*text);
    for (TaskPlace& place : task.places) {
      if (place.point_W) place.point_W = mirrored(*place.point_W);
      if (place.normal_W) place.normal_W = mirrored(*place.normal_W);
    }
    for (FollowKey& key : task.keys) key.displacement_W = mirrored(key.displacement_W);
  }
  for (ForceLimit& limit : out.training.limits) limit.name = otherSideIn(limit.name);
  for (Camera& camera : out.cameras) {
    camera.name = otherSideIn(camera.name);
    camera.eye_W = mirrored(camera.eye_W);
    camera.target_W = mirrored(camera.target_W);
    camera.up_W = mirrored(camera.up_W);
  }
  return out;
}

Recording mirroredRecording(const Recording& recording) {
  Recording out = recording;
  for (HandTrack& track : out.tracks)
    for (HandKey& key : track.keys) key.hand = mirroredTool(key.hand);
  out.jointHash = out.build = out.isa = out.stateHash = {};
  return out;
}

}  // namespace glenoid
