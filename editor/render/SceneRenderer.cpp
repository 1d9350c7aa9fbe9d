// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/SceneRenderer.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "editor/render/Marker.h"
#include "editor/render/SceneRendererInside.h"
#include "editor/render/ScopeView.h"

namespace glenoid {
namespace {

bool anyChosen(const Layers& layers) {
  return std::any_of(layers.objects.begin(), layers.objects.end(),
                     [](const ObjectLook& o) { return o.visible && (o.selected || o.hovered); });
}

/// Pixels of the corner that the orientation marker takes.
double markerSize(const Look& look, const Target& target) {
  return std::min(96 * look.pixelRatio, 0.28 * std::min(target.width, target.height));
}

}  // namespace

SceneRenderer::SceneRenderer() : m_inside(std::make_unique<Inside>()) {}
SceneRenderer::~SceneRenderer() = default;

Result<std::unique_ptr<SceneRenderer>> SceneRenderer::create() {
  std::unique_ptr<SceneRenderer> renderer(new SceneRenderer);
  Inside& in = *renderer->m_inside;
  in.info = glInfo();
  if (!in.info.usable) return Error{Fault::NoGraphics, {}, {}, "OpenGL '" + in.info.version + "'"};
  struct Wanted {
    Program* program;
    const char *vertex, *fragment;
  };
  for (const Wanted& wanted : {Wanted{&in.plainSurface, "surface.vert.glsl", "surface.frag.glsl"},
                               Wanted{&in.mask, "surface.vert.glsl", "mask.frag.glsl"},
                               Wanted{&in.pick, "surface.vert.glsl", "pick.frag.glsl"}}) {
    auto program = Program::build({wanted.vertex, wanted.fragment});
    if (!program) return program.error();
    *wanted.program = std::move(*program);
  }
  auto detailed = Program::build({"surface.vert.glsl", "surface.frag.glsl"}, nullptr, "#define DETAIL\n");
  if (!detailed) return detailed.error();
  in.detailedSurface = std::move(*detailed);
  auto field = Program::build({"surface.vert.glsl", "surface.frag.glsl"}, nullptr, "#define FIELD\n");
  if (!field) return field.error();
  in.fieldSurface = std::move(*field);
  for (const int outline : {0, 1}) {
    auto program = Program::build({"screen.vert.glsl", "compose.frag.glsl"}, nullptr, outline ? "#define WITH_OUTLINE\n" : "");
    if (!program) return program.error();
    in.compose[outline] = std::move(*program);
  }
  auto scopeSurface = Program::build({"surface.vert.glsl", "surface.frag.glsl"}, nullptr, "#define DETAIL\n#define SCOPE\n");
  if (!scopeSurface) return scopeSurface.error();
  in.scopeSurface = std::move(*scopeSurface);
  auto scopeCompose = Program::build({"screen.vert.glsl", "compose.frag.glsl"}, nullptr, "#define SCOPE\n");
  if (!scopeCompose) return scopeCompose.error();
  in.scopeCompose = std::move(*scopeCompose);
  if (auto built = in.evaluator.build(); !built) return built.error();
  if (auto built = in.painter.build(); !built) return built.error();
  if (auto built = in.labelPainter.build(); !built) return built.error();
  if (auto built = in.legendPainter.build(); !built) return built.error();
  return renderer;
}

Result<Done> SceneRenderer::setScene(const Model& model) {
  Inside& in = *m_inside;
  auto geometry = buildSceneGeometry(model);
  if (!geometry) return geometry.error();
  if (auto set = in.evaluator.setScene(*geometry); !set) return set;
  in.scene = std::move(*geometry);
  in.side = model.joint.side;
  in.underSkin = UnderSkin(model);
  in.shiftedQ.resize(0);
  in.shifts.clear();
  in.boxedQ.resize(0);
  in.boxes.clear();
  in.presence.clear();
  in.fieldSent.reset();
  in.valued.clear();
  // An edit that moves no surface keeps what was cast.
  if (in.occlusion && in.occlusion->holdsFor(in.scene, model.start.q)) return Done{};
  in.occlusion.reset();
  in.occlusionJob.start(in.scene, model.start.q);
  return Done{};
}

bool SceneRenderer::settling() const {
  return m_inside->occlusionJob.running();
}

void SceneRenderer::Inside::updateOcclusion(const VecX& q, const Layers& layers) {
  if (auto answer = occlusionJob.take(false)) occlusion = std::move(answer);
  if (!occlusion) return;
  std::vector<float> opacity(scene.objects.size(), 0.0f);
  for (const Shown& s : shownSurfaces(layers))
    if (s.kind == SurfaceKind::Visual) opacity[s.object] = std::clamp(layers.lookOf(s.object).opacity, 0.0f, 1.0f);
  std::vector<float> now = occlusion->presence(scene, q, opacity);
  if (now == presence) return;
  presence = std::move(now);
  evaluator.setOpenness(occlusion->openness(scene, presence));
}

/// Tools that are shown, as shafts in camera axes, to the program that draws surfaces.
void SceneRenderer::Inside::placeShafts(const VecX& q, const Eye& eye, const Layers& layers) {
  constexpr const char* kNames[][2] = {
      {"shaftFrom[0]", "shaftTo[0]"}, {"shaftFrom[1]", "shaftTo[1]"}, {"shaftFrom[2]", "shaftTo[2]"}, {"shaftFrom[3]", "shaftTo[3]"}};
  shafts = 0;
  surface->use();
  for (const Shown& s : shownSurfaces(layers)) {
    const ObjectGeometry& object = scene.objects[s.object];
    if (!object.tool || s.kind != SurfaceKind::Visual || layers.lookOf(s.object).opacity < 1 || shafts == static_cast<int>(std::size(kNames))) continue;
    const auto inView = [&](const Eigen::Vector3f& r_B) -> Eigen::Vector3f {
      GpuVertex vertex;
      vertex.node = {object.layout.qOffset, -1, 0, 0};
      vertex.weight = {r_B.x(), r_B.y(), r_B.z(), 0};
      return (eye.worldToView * positionOf(vertex, q).cast<float>().homogeneous()).head<3>();
    };
    const Eigen::Vector3f from = inView(object.shaft.from_B), to = inView(object.shaft.to_B);
    surface->set(kNames[shafts][0], Eigen::Vector4f(from.x(), from.y(), from.z(), object.shaft.radius));
    surface->set(kNames[shafts][1], to);
    ++shafts;
  }
}

void SceneRenderer::Inside::updateBoxes(const VecX& q) {
  if (boxedQ.size() == q.size() && boxedQ == q) return;
  boxedQ = q;
  boxes.assign(scene.objects.size(), Box3());
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    for (const SurfaceRanges* ranges : {&scene.objects[i].visual, &scene.objects[i].collision})
      for (int v = ranges->vertices.first; v < ranges->vertices.first + ranges->meshVertices; ++v) {
        const Vec3 p = positionOf(scene.vertices[v], q);
        if (p.allFinite()) boxes[i].extend(p);
      }
}

std::vector<Shown> SceneRenderer::Inside::shownSurfaces(const Layers& layers) const {
  std::vector<Shown> shown;
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
    const ObjectLook look = layers.lookOf(i);
    if (!look.visible || look.opacity <= 0) continue;
    const ObjectGeometry& object = scene.objects[i];
    const bool visual = object.visual.present && (object.tool ? layers.tools : layers.visual);
    const bool collision = object.collision.present && layers.collision && (layers.tools || !object.tool);
    if (visual) shown.push_back({i, SurfaceKind::Visual, true, false});
    if (collision) shown.push_back({i, SurfaceKind::Collision, !visual, true});
  }
  return shown;
}

Eye SceneRenderer::Inside::eyeFor(const View& view, const Layers& layers, double aspect) const {
  const ViewAxes axes = axesOf(view);
  double nearest = 1e30, farthest = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].isEmpty() || !layers.lookOf(static_cast<int>(i)).visible) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const double depth =
          (view.eye_W - boxes[i].corner(static_cast<Box3::CornerType>(corner))).dot(axes.back_W);
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  }
  Eye eye;
  // A margin for what has no surface: springs, normals, nodes of the cells outside.
  eye.farPlane = farthest > 0 ? 1.1 * farthest + 0.02 : 1;
  eye.nearPlane = std::max(0.8 * nearest - 0.02, eye.farPlane / 2000);
  if (!(eye.nearPlane < 0.9 * eye.farPlane)) eye.nearPlane = eye.farPlane / 2000;
  eye.tanHalfY = std::tan(view.fieldOfView / 2);
  eye.tanHalfX = eye.tanHalfY * aspect;
  const Eigen::Matrix4d world = viewMatrix(view),
                        clip = projectionMatrix(view, aspect, eye.nearPlane, eye.farPlane);
  eye.worldToView = world.cast<float>();
  eye.viewToClip = clip.cast<float>();
  eye.worldToClip = (clip * world).cast<float>();
  eye.up_V = world.block<3, 1>(0, 1).cast<float>();
  return eye;
}

void SceneRenderer::draw(const View& view, const VecX& q, const Layers& layers,
                         std::span<const ContactView> contacts, const Look& look, const Target& target) {
  Inside& in = *m_inside;
  if (target.width < 1 || target.height < 1) return;
  const int factor = std::clamp(look.supersample, 1, 4);
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const int samples =
      std::clamp(look.samples < 0 ? (in.info.software ? 1 : 4) : look.samples, 1, std::max(most, 1));
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  if (!in.frame.resize(target.width, target.height, factor, samples) &&
      !in.frame.resize(target.width, target.height, 1, 1))
    return;
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);

  const bool fits = in.fits(q);
  std::vector<LabelPainter::Label> labels;
  if (fits && layers.labels && !look.scope) labels = in.labelsFor(view, q, layers, target);
  if (fits) {
    in.updateBoxes(q);
    in.evaluate(q, layers.dents, in.visuallyShown(layers));
  }
  const Eye eye = in.eyeFor(view, layers, static_cast<double>(target.width) / target.height);

  in.scope = look.scope;
  in.surface = look.scope ? &in.scopeSurface : look.detail ? &in.detailedSurface : &in.plainSurface;
  in.occluded = look.ambientOcclusion;
  if (fits && look.ambientOcclusion) in.updateOcclusion(q, layers);
  if (fits) in.placeShafts(q, eye, layers);
  if (fits && layers.field) in.updateField(*layers.field);
  in.frame.bindScene();
  if (fits) in.drawScene(eye, layers, contacts, std::max(look.pixelRatio, 0.1) * in.frame.factor());
  in.frame.resolveScene();
  if (look.scope) {
    in.drawScoped(*look.scope, target);
    glBindVertexArray(0);
    glUseProgram(0);
    return;
  }
  if (fits && anyChosen(layers)) in.drawMask(eye, layers);
  in.drawComposed(layers, look, target);
  if (layers.marker) in.drawMarker(view, look, target);
  if (!layers.strokes.empty()) in.drawScreenStrokes(layers, look, target);
  LegendBox legend;
  const std::vector<Shown> shown = fits && layers.field ? in.shownSurfaces(layers) : std::vector<Shown>();
  if (std::any_of(shown.begin(), shown.end(), [&](const Shown& s) { return in.hasFieldLook(s, layers); }))
    legend = in.legendPainter.draw(*layers.field, target, in.scaleTexture.id(), look.pixelRatio, look.dark, in.labelPainter, in.painter);
  if (!labels.empty()) {
    LabelArea area;
    area.width = target.width;
    area.height = target.height;
    area.taken = layers.marker ? markerSize(look, target) : 0;
    area.takenRight = legend.height;
    in.labelPainter.draw(labels, area, look.pixelRatio, look.dark, in.painter);
  }
  glBindVertexArray(0);
  glUseProgram(0);
}

void SceneRenderer::Inside::drawComposed(const Layers& layers, const Look& look, const Target& target) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(0, 0, target.width, target.height);
  const bool outlined = anyChosen(layers);
  const Program& program = compose[outlined ? 1 : 0];
  program.use();
  const unsigned textures[] = {frame.color(), frame.mask()};
  const char* names[] = {"scene", "mask"};
  for (int unit = 0; unit < 2; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, textures[unit]);
    program.set(names[unit], unit);
  }
  program.set("factor", frame.factor());
  program.set("size", frame.width(), frame.height());
  program.set("outlinePx", std::clamp(static_cast<int>(std::lround(2 * look.pixelRatio)), 1, 5));
  program.set("outlineColor", look.dark ? linearColor(1.0f, 0.72f, 0.25f) : linearColor(0.93f, 0.45f, 0.05f));
  const Eigen::Vector3f top =
      look.dark ? linearColor(0.235f, 0.262f, 0.302f) : linearColor(0.955f, 0.965f, 0.975f);
  const Eigen::Vector3f bottom =
      look.dark ? linearColor(0.090f, 0.102f, 0.122f) : linearColor(0.800f, 0.830f, 0.860f);
  program.set("top", Eigen::Vector3f(top.cwiseSqrt()));
  program.set("bottom", Eigen::Vector3f(bottom.cwiseSqrt()));
  program.set("background", look.transparent ? 0 : 1);
  glBindVertexArray(empty.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  for (int unit = 1; unit >= 0; --unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, 0);
  }
}

void SceneRenderer::Inside::drawScoped(const ScopeLook& look, const Target& target) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(0, 0, target.width, target.height);
  scopeCompose.use();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, frame.color());
  scopeCompose.set("scene", 0);
  scopeCompose.set("factor", frame.factor());
  scopeCompose.set("size", frame.width(), frame.height());
  scopeCompose.set("field", Eigen::Vector4f(0.5f * static_cast<float>(target.width), 0.5f * static_cast<float>(target.height),
                                            static_cast<float>(scopeRadius(target.width, target.height)), static_cast<float>(look.distortion)));
  scopeCompose.set("notch", Eigen::Vector3f(static_cast<float>(std::sin(look.notch)), static_cast<float>(std::cos(look.notch)), look.hasNotch ? 1.0f : 0.0f));
  scopeCompose.set("blood", static_cast<float>(std::clamp(look.bleeding, 0.0, 1.0)));
  scopeCompose.set("haze", static_cast<float>(std::clamp(look.haze, 0.0, 1.0)));
  glBindVertexArray(empty.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void SceneRenderer::Inside::drawMarker(const View& view, const Look& look, const Target& target) {
  const double size = markerSize(look, target);
  const MarkerLines marker = markerLines(view, size, look.dark, side);
  painter.beginPixels(target.width, target.height);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const float width = static_cast<float>(std::max(1.0, size / 48));
  painter.lines(marker.axes, {width, 0, 1});
  painter.lines(marker.letters, {0.8f * width, 0, 1});
  glDisable(GL_BLEND);
}

Box3 SceneRenderer::bounds(const VecX& q, const Layers& layers) const {
  Inside& in = *m_inside;
  Box3 box;
  if (!in.fits(q)) return box;
  in.updateBoxes(q);
  for (const Shown& shown : in.shownSurfaces(layers)) box.extend(in.boxes[shown.object]);
  if (!box.isEmpty()) return box;
  for (std::size_t i = 0; i < in.boxes.size(); ++i)  // only edges or springs are shown
    if (layers.lookOf(static_cast<int>(i)).visible) box.extend(in.boxes[i]);
  return box;
}

std::vector<ShownDent> SceneRenderer::Inside::shownDents(std::vector<DentView> dents) const {
  std::stable_sort(dents.begin(), dents.end(), [](const DentView& a, const DentView& b) { return a.depth > b.depth; });
  std::vector<ShownDent> shown;
  for (const DentView& dent : dents) {
    if (dent.object < 0 || dent.object >= static_cast<int>(scene.objects.size()) || !(dent.radius > 0)) continue;
    if (shown.size() == StateEvaluator::kDentsMost) break;
    ShownDent& one = shown.emplace_back();
    one.vertices = scene.objects[static_cast<std::size_t>(dent.object)].visual.vertices;
    one.place_W << dent.point_W.cast<float>(), static_cast<float>(dent.radius);
    one.way_W = (-dent.depth * dent.normal_W).cast<float>();
  }
  return shown;
}

std::vector<char> SceneRenderer::Inside::visuallyShown(const Layers& layers) const {
  std::vector<char> shown(scene.objects.size(), 0);
  for (const Shown& s : shownSurfaces(layers))
    if (s.kind == SurfaceKind::Visual) shown[s.object] = 1;
  return shown;
}

void SceneRenderer::Inside::updateShifts(const VecX& q, std::span<const DentView> dents, std::vector<char> shown) {
  if (underSkin.empty()) return;
  if (shiftedQ.size() == q.size() && shiftedQ == q && std::ranges::equal(shiftedDents, dents) && shiftedShown == shown) return;
  shiftedQ = q;
  shiftedDents.assign(dents.begin(), dents.end());
  shiftedShown = std::move(shown);
  underSkin.look(q, dents, shiftedShown);
  shifts.clear();
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
    const std::span<const Vec3> those = underSkin.shifts(i);
    if (those.empty()) continue;
    shifts.resize(3 * scene.vertices.size(), 0.0f);
    const Range range = scene.objects[i].visual.vertices;
    for (int v = range.first; v < range.first + range.count; ++v)
      for (int k = 0; k < 3; ++k) shifts[3 * static_cast<std::size_t>(v) + k] = static_cast<float>(those[scene.source[v]][k]);
  }
}

void SceneRenderer::Inside::evaluate(const VecX& q, std::span<const DentView> dents, std::vector<char> shown) {
  updateShifts(q, dents, std::move(shown));
  evaluator.evaluate(q, shownDents({dents.begin(), dents.end()}), shifts);
}

SceneRenderer::Evaluated SceneRenderer::evaluated(int object, SurfaceKind kind, const VecX& q, std::span<const DentView> dents) {
  Inside& in = *m_inside;
  Evaluated out;
  if (!in.fits(q) || object < 0 || object >= static_cast<int>(in.scene.objects.size())) return out;
  const SurfaceRanges& surface = in.scene.objects[object].surface(kind);
  if (!surface.present) return out;
  in.evaluate(q, dents);
  const auto positions = in.evaluator.readPositions(surface.vertices),
             normals = in.evaluator.readNormals(surface.vertices);
  out.positions_W.resize(surface.meshVertices);
  out.normals_W.assign(surface.meshVertices, Eigen::Vector3f::Zero());
  for (int i = 0; i < surface.vertices.count; ++i) {
    const int v = in.scene.source[surface.vertices.first + i];
    out.positions_W[v] = positions[i].head<3>();
    out.normals_W[v] += normals[i].head<3>();
  }
  for (Eigen::Vector3f& n : out.normals_W)
    if (n.norm() > 0) n.normalize();
  return out;
}

}  // namespace glenoid
