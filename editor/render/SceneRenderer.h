// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "editor/render/Image.h"
#include "editor/render/Layers.h"
#include "editor/render/View.h"
#include "simcore/base/Error.h"
#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// Where a frame goes. `framebuffer` is the host's own (a QOpenGLWidget's is not 0).
struct Target {
  unsigned framebuffer = 0;
  int width = 0, height = 0;  ///< device pixels
};

/// What lies under a pixel.
struct PickHit {
  int object = -1;                            ///< in Model::objects
  SurfaceKind surface = SurfaceKind::Visual;  ///< which of its surfaces
  int triangle = -1;                          ///< of that surface
  Vec3 point_W = Vec3::Zero();                ///< m
  Vec3 normal_W = Vec3::UnitY();              ///< of the flat triangle, towards the viewer
};

/// Draws a scene with OpenGL 3.3 core. It makes no context and knows no window: every member function, the
/// destructor too, needs the context current under which the renderer was created. One renderer, two hosts.
///
/// Topology, bindings and adjacency go to the GPU once (setScene); a frame sends q alone, as a buffer
/// texture. The GPU evaluates the point entities (rigid p = c + R r_B, soft p = Σ wᵢ qᵢ) by transform
/// feedback, then area-weighted normals from each vertex' incident triangles. Source: Otaduy et al. 2010,
/// section 3.2 ("we simply need to send the state vector q to the GPU").
///
/// Leaves behind: the target bound, depth test, blending, culling and scissor off, program and vertex array
/// 0.
class SceneRenderer {
 public:
  /// Fails with NoGraphics (no context, below 3.3) or Internal (a shader does not build; detail holds the
  /// log).
  static Result<std::unique_ptr<SceneRenderer>> create();
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Takes what it needs; the model may go afterwards. Fails with BadIndex (a triangle, node or q range
  /// outside its array, naming the object) or NoGraphics (the scene exceeds the driver's buffer textures);
  /// the old scene stays.
  Result<Done> setScene(const Model& model);

  /// Draws one frame, for up to a second after setScene without darker hollows, which are found beside; the background alone when q has not the scene's size (a state of another model).
  void draw(const View& view, const VecX& q, const Layers& layers, std::span<const ContactView> contacts,
            const Look& look, const Target& target);

  /// The same into a picture of its own; waits until hollows are found.
  Result<Image> picture(const View& view, const VecX& q, const Layers& layers,
                        std::span<const ContactView> contacts, const Look& look, int width, int height);

  /// What is seen at (x, y), pixels from the top left, among the shown surfaces with opacity above zero.
  std::optional<PickHit> pick(const View& view, const VecX& q, const Layers& layers, const Target& target,
                              double x, double y);

  /// Every triangle that is seen within the rectangle [x0, x1] × [y0, y1]: object and triangle, ascending,
  /// once each.
  std::vector<PickHit> pickRectangle(const View& view, const VecX& q, const Layers& layers,
                                     const Target& target, int x0, int y0, int x1, int y1);

  /// Whether the next frame may look better although nothing changes: hollows are still being found.
  bool settling() const;

  /// Box around the objects that are shown, W; empty without any.
  Box3 bounds(const VecX& q, const Layers& layers) const;

  /// As the GPU evaluated them for q, by surface vertex of one object: for tests and measuring tools.
  struct Evaluated {
    std::vector<Eigen::Vector3f> positions_W, normals_W;  ///< normals: unit; mean of the parts at a crease
  };
  Evaluated evaluated(int object, SurfaceKind surface, const VecX& q, std::span<const DentView> dents = {});

 private:
  SceneRenderer();
  struct Inside;
  std::unique_ptr<Inside> m_inside;
};

/// One picture, no window and no display: a context, a renderer, a frame; automatic samples are 4 here on any
/// renderer. Fails with NoGraphics, BadIndex, OutOfRange.
Result<Image> renderPicture(const Model& model, const State& state, const View& view, const Layers& layers,
                            int width, int height, const Look& look = {},
                            std::span<const ContactView> contacts = {});

/// Box around a model's visual surfaces in a state, W, without any graphics: for framing a first view.
Box3 sceneBounds(const Model& model, const VecX& q);

}  // namespace glenoid
