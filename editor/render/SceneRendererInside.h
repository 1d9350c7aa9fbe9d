// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "editor/render/FrameBuffers.h"
#include "editor/render/GlContext.h"
#include "editor/render/GlResources.h"
#include "editor/render/LabelPainter.h"
#include "editor/render/LegendPainter.h"
#include "editor/render/LinePainter.h"
#include "editor/render/OcclusionJob.h"
#include "editor/render/SceneGeometry.h"
#include "editor/render/SceneRenderer.h"
#include "editor/render/StateEvaluator.h"
#include "simcore/reading/UnderSkin.h"

/// What SceneRenderer's files share; private to this folder.
namespace glenoid {

/// Matrices and depth range of one frame.
struct Eye {
  Eigen::Matrix4f worldToView, viewToClip, worldToClip;
  Eigen::Vector3f up_V;  ///< the world's vertical
  double nearPlane, farPlane;
  double tanHalfX, tanHalfY;
  double depthScale() const { return 2 * farPlane * nearPlane / (farPlane - nearPlane); }
};

/// One surface that is to be drawn filled, with edges, or both.
struct Shown {
  int object;
  SurfaceKind kind;
  bool filled, edges;
};

struct SceneRenderer::Inside {
  GlInfo info;
  StateEvaluator evaluator;
  LinePainter painter;
  LabelPainter labelPainter;
  LegendPainter legendPainter;
  FrameBuffers frame;
  PickTarget pickTarget;
  Program plainSurface, detailedSurface, fieldSurface, mask, pick;
  const Program* surface = &plainSurface;  ///< of the frame that is being drawn
  bool occluded = true;                    ///< whether that frame darkens hollows
  int shafts = 0;                          ///< tools that darken tissue near them in that frame
  Program compose[2];                      ///< [with outline]
  Program scopeSurface, scopeCompose;      ///< as through an arthroscope
  std::optional<ScopeLook> scope;          ///< of the frame that is being drawn
  GlVertexArray empty;                     ///< for passes that need no attribute

  SceneGeometry scene;
  JointSide side = JointSide::Unsaid;  ///< of the joint, for the marker
  UnderSkin underSkin;
  VecX shiftedQ;                       ///< state, dents and shown objects for which shifts hold
  std::vector<DentView> shiftedDents;
  std::vector<char> shiftedShown;
  std::vector<float> shifts;           ///< by vertex of the scene, as the evaluator takes them
  VecX boxedQ;              ///< q for which boxes hold
  std::vector<Box3> boxes;  ///< by object, W, all its surfaces

  OcclusionJob occlusionJob;
  std::shared_ptr<const Occlusion> occlusion;  ///< of the scene, once it is there
  std::vector<float> presence;                 ///< for which openness was last sent

  std::shared_ptr<const std::vector<std::vector<float>>> fieldSent;  ///< values as the GPU has them
  std::vector<char> valued;                                          ///< by object: has some of them
  GlTexture scaleTexture;
  std::optional<std::array<double, 3>> scaleSent;                    ///< low, high and whether low is nothing, of that texture

  bool fits(const VecX& q) const { return q.size() == scene.qSize; }
  void updateBoxes(const VecX& q);
  /// The deepest dents, as the evaluator takes them.
  std::vector<ShownDent> shownDents(std::vector<DentView> dents) const;
  /// Positions of all vertices; what a shown skin covers stays beneath it. `shown`: by object; empty: all.
  void evaluate(const VecX& q, std::span<const DentView> dents, std::vector<char> shown = {});
  /// By object: whether its visual surface is drawn.
  std::vector<char> visuallyShown(const Layers& layers) const;
  void updateShifts(const VecX& q, std::span<const DentView> dents, std::vector<char> shown);
  Eye eyeFor(const View& view, const Layers& layers, double aspect) const;
  std::vector<Shown> shownSurfaces(const Layers& layers) const;

  /// Values and scale to the GPU, where they are new.
  void updateField(const FieldLook& field);
  bool hasFieldLook(const Shown& shown, const Layers& layers) const;
  void drawScene(const Eye& eye, const Layers& layers, std::span<const ContactView> contacts,
                 double strokeScale);
  void drawFilled(const Shown& shown, const Eye& eye, const Layers& layers);
  void drawOverlays(const Shown& shown, const Layers& layers, const Program& program);
  void drawEdges(const std::vector<Shown>& shown, const Layers& layers, double scale);
  void drawSprings(const Layers& layers, double scale, float strength);
  void drawContacts(const Layers& layers, std::span<const ContactView> contacts, double scale,
                    float strength);
  void drawStrokes(const Layers& layers, double scale, bool hidden);
  void drawScreenStrokes(const Layers& layers, const Look& look, const Target& target);
  void drawMask(const Eye& eye, const Layers& layers);
  void updateOcclusion(const VecX& q, const Layers& layers);
  void placeShafts(const VecX& q, const Eye& eye, const Layers& layers);
  void drawScoped(const ScopeLook& look, const Target& target);
  void drawComposed(const Layers& layers, const Look& look, const Target& target);
  void drawMarker(const View& view, const Look& look, const Target& target);
  std::vector<LabelPainter::Label> labelsFor(const View& view, const VecX& q, const Layers& layers, const Target& target);
  void triangles(Range indices);
  bool pickInto(const View& view, const VecX& q, const Layers& layers, const Target& target, int x0, int y0,
                int width, int height);
};

}  // namespace glenoid
