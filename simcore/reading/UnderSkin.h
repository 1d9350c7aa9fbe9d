// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>
#include <vector>

#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// Keeps what lies beneath a skin beneath it in pictures. Skin and muscle collide by coarse surfaces, which hold; the fine
/// visual ones ride on cells that are larger than the bends beside a finger, and pressed hard they lie millimetres in each
/// other, until muscle shows through the skin. A vertex that began on one side of a skin is shown on that side of the skin as
/// it is shown, dents included: as far off as it began, at most a millimetre. The state knows nothing of it, and nothing
/// is shifted at the start. Skin: parts whose default material looks like skin. Wrong for measuring what the solver did: that is what
/// collision surfaces are for. Frame W, m. Keeps scratch: for one thread at a time.
class UnderSkin {
 public:
  UnderSkin() = default;
  explicit UnderSkin(const Model& model);

  /// Whether the model has no skin with anything beneath.
  bool empty() const { return m_skins.empty(); }

  /// Shifts for a state and the dents shown with it, of the skins that are shown (by object; empty: all).
  void look(const VecX& q, std::span<const DentView> dents, std::span<const char> shown = {});

  /// Of one object's visual vertices, from the last look; empty where none of them is shifted.
  std::span<const Vec3> shifts(int object) const;

 private:
  /// A vertex and where the skin was nearest to it at the start.
  struct Beneath {
    int vertex = 0, triangle = 0;
    double room = 0;  ///< m, what is kept between
  };
  struct Layer {
    int object = 0;
    std::vector<Beneath> vertices;
  };
  struct Skin {
    int object = 0;
    std::vector<int> firstNear;  ///< by triangle, in `near`; one more entry for the end
    std::vector<int> near;       ///< triangles that share a vertex with one
    std::vector<Layer> layers;
  };
  /// What has to be kept of an object.
  struct Surface {
    SurfaceBinding binding;
    ObjectLayout layout;
  };
  struct Foot {
    int triangle = 0;
    double squared = 0;  ///< m², distance
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitY();
  };

  static Skin beneathOf(const Model& model, int object);
  void place(int object, const VecX& q, std::span<const DentView> dents, std::vector<Vec3>& out) const;
  Foot footOf(const Skin& skin, const TriMesh& mesh, int from, const Vec3& p) const;
  Foot footOn(const TriMesh& mesh, int triangle, const Vec3& p) const;

  std::vector<Skin> m_skins;
  std::vector<Surface> m_surfaces;          ///< by object; empty ones of those that have no part in this
  std::vector<std::vector<Vec3>> m_shifts;  ///< by object
  std::vector<char> m_shifted;              ///< by object
  std::vector<Vec3> m_skinAt, m_normals, m_at;
};

}  // namespace glenoid
