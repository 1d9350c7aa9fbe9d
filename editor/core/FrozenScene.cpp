// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/FrozenScene.h"

#include <algorithm>

#include "editor/core/SameScene.h"

namespace glenoid {
namespace {

template <class T, class Same>
std::vector<std::shared_ptr<const T>> frozen(const std::vector<T>& values, const std::vector<std::shared_ptr<const T>>* before,
                                             Same same) {
  std::vector<std::shared_ptr<const T>> kept;
  kept.reserve(values.size());
  for (const T& value : values) {
    const auto sameId = [&](const std::shared_ptr<const T>& old) { return old->id == value.id; };
    if (before)
      if (const auto old = std::find_if(before->begin(), before->end(), sameId); old != before->end() && same(**old, value)) {
        kept.push_back(*old);
        continue;
      }
    kept.push_back(std::make_shared<const T>(value));
  }
  return kept;
}

}  // namespace

std::shared_ptr<const FrozenScene> FrozenScene::of(const Scene& scene, const FrozenScene* near) {
  auto made = std::make_shared<FrozenScene>();
  made->m_parts = frozen(scene.joint.parts, near ? &near->m_parts : nullptr, samePart);
  made->m_cages = frozen(scene.joint.cages, near ? &near->m_cages : nullptr, [](const Cage& a, const Cage& b) { return a == b; });
  const Joint& joint = scene.joint;
  made->m_rest = {{joint.id, joint.name, joint.description, joint.side, joint.axes_W, joint.materials, {}, joint.couplings, joint.exclusions, joint.bursae, {}, joint.startProof,
                   joint.provenance},
                  scene.scenario, scene.input};
  return made;
}

Scene FrozenScene::thaw() const {
  Scene scene = m_rest;
  scene.joint.parts.reserve(m_parts.size());
  for (const auto& part : m_parts) scene.joint.parts.push_back(*part);
  for (const auto& cage : m_cages) scene.joint.cages.push_back(*cage);
  return scene;
}

}  // namespace glenoid
