// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/embed/Binding.h"
#include "simcore/embed/CageWeights.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// A soft part that follows its cage while handles move: the coordinates are computed once, for the cage at
/// rest. Frames: W, m. Constant once made; any number of threads may ask.
class CageFollower {
 public:
  /// Fails as cageWeights does; the place names the part. The part needs a volume.
  static Result<std::shared_ptr<const CageFollower>> make(const Part& part, const Cage& cage);

  /// Whether it holds for this part and the rest of this cage.
  bool isFor(const Part& part, const Cage& cage) const;
  std::vector<Vec3> nodes(const std::vector<Vec3>& moved_W) const;
  TriMesh collision(const std::vector<Vec3>& moved_W) const;

 private:
  CageFollower() = default;
  std::shared_ptr<const TetMesh> m_volume;
  std::shared_ptr<const TriMesh> m_collision;
  std::vector<std::array<int, 3>> m_triangles;
  std::vector<Vec3> m_rest_W;
  CageWeights m_weights;
  std::vector<VertexBinding> m_bound;
};

/// Followers of a joint's parts, kept while their cages at rest stay, for asking again and again with other
/// handles. Threads: any; one works at a time.
class StartSurfaces {
 public:
  /// Fails as CageFollower::make does.
  Result<std::shared_ptr<const CageFollower>> follower(const Part& part, const Cage& cage);
  /// The collision surface of every part as it starts, in the joint's order.
  Result<std::vector<TriMesh>> of(const Joint& joint);

 private:
  std::mutex m_mutex;
  std::map<std::string, std::shared_ptr<const CageFollower>> m_followers;  ///< by part
};

}  // namespace glenoid
