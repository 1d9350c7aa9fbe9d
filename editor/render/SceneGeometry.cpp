// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/SceneGeometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace glenoid {
namespace {

Error badIndex(const std::string& object, long index, long size, const char* what) {
  return Error{Fault::BadIndex, {{}, {}, object, index}, {std::to_string(index), std::to_string(size)}, what};
}

Vec3 faceNormal(const TriMesh& mesh, int triangle) {
  const auto& t = mesh.triangles[triangle];
  const Vec3 n = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

/// For each corner of each triangle the side of the crease it belongs to at its vertex: 0, 1, …
/// Corners around a vertex belong together when their triangles share an edge that is no crease.
class CreaseSides {
 public:
  explicit CreaseSides(const TriMesh& mesh) : m_parent(3 * mesh.triangles.size()) {
    std::iota(m_parent.begin(), m_parent.end(), 0);
    struct HalfEdge {
      int low, high, triangle, cornerLow, cornerHigh;
    };
    std::vector<HalfEdge> edges;
    edges.reserve(m_parent.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
      for (int k = 0; k < 3; ++k) {
        int a = k, b = (k + 1) % 3;
        if (mesh.triangles[t][a] > mesh.triangles[t][b]) std::swap(a, b);
        edges.push_back({mesh.triangles[t][a], mesh.triangles[t][b], t, 3 * t + a, 3 * t + b});
      }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
      return std::tie(x.low, x.high, x.triangle) < std::tie(y.low, y.high, y.triangle);
    });
    const double cosine = std::cos(kCreaseAngle);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      const HalfEdge &x = edges[i], &y = edges[i + 1];
      if (x.low != y.low || x.high != y.high) continue;
      const Vec3 nx = faceNormal(mesh, x.triangle), ny = faceNormal(mesh, y.triangle);
      if (nx.dot(ny) < cosine && !nx.isZero() && !ny.isZero()) continue;
      join(x.cornerLow, y.cornerLow);
      join(x.cornerHigh, y.cornerHigh);
    }
  }
  int groupOf(int corner) {
    while (m_parent[corner] != corner) corner = m_parent[corner] = m_parent[m_parent[corner]];
    return corner;
  }

 private:
  void join(int a, int b) {
    a = groupOf(a), b = groupOf(b);
    m_parent[std::max(a, b)] = std::min(a, b);  // the smallest corner names the group
  }
  std::vector<int> m_parent;
};

class Builder {
 public:
  explicit Builder(const Model& model) : m_model(model) {
    m_out.qSize = static_cast<int>(model.start.q.size());
  }

  Result<SceneGeometry> build() {
    for (int i = 0; i < static_cast<int>(m_model.objects.size()); ++i)
      if (auto added = addObject(i); !added) return added.error();
    for (int i = 0; i < static_cast<int>(m_model.objects.size()); ++i) addRegions(i);
    if (auto added = addSprings(); !added) return added.error();
    return std::move(m_out);
  }

 private:
  Result<Done> addObject(int i) {
    const SceneObject& object = m_model.objects[i];
    const ObjectLayout& l = object.layout;
    const int expected = l.rigid ? 7 : 3 * l.nodeCount;
    if (l.qOffset < 0 || l.qSize != expected || l.nodeCount < 0 || l.qOffset + l.qSize > m_out.qSize)
      return badIndex(object.id, l.qOffset + l.qSize, m_out.qSize, "state range");
    m_out.objects.emplace_back();
    ObjectGeometry& geometry = m_out.objects.back();
    geometry.id = object.id;
    geometry.name = object.name;
    geometry.tool = object.tool;
    geometry.color = object.color;
    geometry.layout = l;
    if (auto good = checkRegions(object); !good) return good;
    if (auto added = addSurface(object, object.visual, geometry.visual); !added) return added;
    if (auto added = addSurface(object, object.collision, geometry.collision); !added) return added;
    if (geometry.visual.present) addTissue(object, geometry);
    if (geometry.visual.present && object.tool) geometry.shaft = shaftOf(object.visual);
    if (!l.rigid && object.volume) return addTetrahedra(object, geometry);
    return Done{};
  }

  /// A tool's own frame has its origin at the tip and +Z along the shaft; Y is across it.
  static ToolShaft shaftOf(const SurfaceBinding& visual) {
    const TriMesh& mesh = *visual.mesh;
    const Vec3 centre = mesh.vertices[0] - visual.vertices[0].r_B;
    double length = 0;
    Vec3 across = Vec3::Zero();
    for (const Vec3& x : mesh.vertices) length = std::max(length, x.z()), across = across.cwiseMax(x.cwiseAbs());
    const double radius = std::min(across.x(), across.y());  // a hook or a bend leads to one side only
    const Vec3 from = Vec3(0, 0, std::min(radius, length)) - centre, to = Vec3(0, 0, length) - centre;
    return {from.cast<float>(), to.cast<float>(), static_cast<float>(radius)};
  }

  const Part* partOf(const SceneObject& object) const {
    const int part = object.tool ? -1 : findPart(m_model.joint, object.id);
    return part < 0 ? nullptr : &m_model.joint.parts[part];
  }

  Result<Done> checkRegions(const SceneObject& object) const {
    const Part* part = partOf(object);
    if (!part) return Done{};
    for (const Region& region : part->regions) {
      const SurfaceBinding& surface =
          region.surface == SurfaceKind::Visual ? object.visual : object.collision;
      const int triangles = surface.mesh ? static_cast<int>(surface.mesh->triangles.size()) : 0;
      for (const TriangleRun& run : region.triangles)
        if (run.first < 0 || run.count < 0 || run.first > triangles - run.count)
          return badIndex(object.id, long{run.first} + run.count, triangles, "triangles of a region");
    }
    return Done{};
  }

  void addTissue(const SceneObject& object, ObjectGeometry& geometry) {
    const Part* part = partOf(object);
    Tissue tissue =
        tissueOf(*object.visual.mesh, part, part ? appearanceOf(m_model.joint, *part) : Appearance::Plain);
    if (object.tool && object.toolIndex >= 0 && object.toolIndex < static_cast<int>(m_model.scenario.tools.size()))
      addFinger(m_model.scenario.tools[object.toolIndex], *object.visual.mesh, tissue);
    geometry.grain = tissue.grain;
    geometry.roughness = tissue.roughness;
    geometry.wet = tissue.wet;
    const Range range = geometry.visual.vertices;
    for (int v = range.first; v < range.first + range.count; ++v)
      m_out.tissue[v] = tissue.vertices[m_out.source[v]];
  }

  Result<GpuVertex> vertexOf(const SceneObject& object, const VertexBinding& binding) const {
    GpuVertex v;
    if (object.layout.rigid) {
      v.node = {object.layout.qOffset, -1, 0, 0};
      for (int k = 0; k < 3; ++k) v.weight[k] = static_cast<float>(binding.r_B[k]);
      return v;
    }
    for (int k = 0; k < 4; ++k) {
      if (binding.node[k] < 0 || binding.node[k] >= object.layout.nodeCount)
        return badIndex(object.id, binding.node[k], object.layout.nodeCount, "node of a binding");
      v.node[k] = object.layout.qOffset + 3 * binding.node[k];
      v.weight[k] = static_cast<float>(binding.weight[k]);
    }
    return v;
  }

  Result<Done> addSurface(const SceneObject& object, const SurfaceBinding& surface, SurfaceRanges& ranges) {
    if (!surface.mesh || surface.mesh->triangles.empty()) return Done{};
    const TriMesh& mesh = *surface.mesh;
    const int count = static_cast<int>(mesh.vertices.size());
    if (surface.vertices.size() != mesh.vertices.size())
      return badIndex(object.id, static_cast<long>(surface.vertices.size()), count, "bindings of a surface");
    for (const auto& t : mesh.triangles)
      for (const int corner : t)
        if (corner < 0 || corner >= count) return badIndex(object.id, corner, count, "corner of a triangle");

    ranges.present = true;
    ranges.meshVertices = count;
    const int first = ranges.vertices.first = static_cast<int>(m_out.vertices.size());
    for (int v = 0; v < count; ++v) {
      auto vertex = vertexOf(object, surface.vertices[v]);
      if (!vertex) return vertex.error();
      addVertex(*vertex, v);
    }
    // The first side of a crease keeps the vertex; each other one gets a copy behind them.
    CreaseSides sides(mesh);
    std::vector<int> ownerOfVertex(count, -1), copyOfGroup(3 * mesh.triangles.size(), -1);
    std::vector<std::array<std::int32_t, 3>> corners(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int group = sides.groupOf(static_cast<int>(3 * t) + k), v = mesh.triangles[t][k];
        if (copyOfGroup[group] < 0) {
          if (ownerOfVertex[v] < 0) {
            ownerOfVertex[v] = group;
            copyOfGroup[group] = first + v;
          } else {
            copyOfGroup[group] = static_cast<int>(m_out.vertices.size());
            addVertex(GpuVertex(m_out.vertices[first + v]), v);
          }
        }
        corners[t][k] = copyOfGroup[group];
      }
    ranges.vertices.count = static_cast<int>(m_out.vertices.size()) - first;
    addRings(corners, first, ranges.vertices.count);
    ranges.triangles.first = static_cast<int>(m_out.indices.size());
    for (const auto& t : corners) m_out.indices.insert(m_out.indices.end(), t.begin(), t.end());
    ranges.triangles.count = static_cast<int>(m_out.indices.size()) - ranges.triangles.first;
    std::vector<std::array<int, 2>> edges;
    for (const auto& t : mesh.triangles)
      for (int k = 0; k < 3; ++k)
        edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    ranges.edges = addEdges(edges, first);
    return Done{};
  }

  void addVertex(const GpuVertex& vertex, int source) {
    m_out.vertices.push_back(vertex);
    m_out.source.push_back(source);
    m_out.tissue.push_back({});
    m_out.rings.push_back({0, 0});
  }

  void addRings(const std::vector<std::array<std::int32_t, 3>>& corners, int first, int count) {
    for (const auto& t : corners)
      for (const int v : t) ++m_out.rings[v][1];
    int at = static_cast<int>(m_out.neighbours.size());
    for (int v = first; v < first + count; ++v) {
      m_out.rings[v][0] = at;
      at += m_out.rings[v][1];
    }
    m_out.neighbours.resize(at);
    std::vector<int> next(count);
    for (int v = 0; v < count; ++v) next[v] = m_out.rings[first + v][0];
    for (const auto& t : corners)
      for (int k = 0; k < 3; ++k) m_out.neighbours[next[t[k] - first]++] = {t[(k + 1) % 3], t[(k + 2) % 3]};
  }

  Range addEdges(std::vector<std::array<int, 2>>& edges, int first) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    Range range{static_cast<int>(m_out.indices.size()), 2 * static_cast<int>(edges.size())};
    for (const auto& e : edges)
      for (const int v : e) m_out.indices.push_back(static_cast<std::uint32_t>(first + v));
    return range;
  }

  Result<Done> addTetrahedra(const SceneObject& object, ObjectGeometry& geometry) {
    const int first = static_cast<int>(m_out.vertices.size()), count = object.layout.nodeCount;
    std::vector<std::array<int, 2>> edges;
    for (const auto& tet : object.volume->tets) {
      for (const int node : tet)
        if (node < 0 || node >= count) return badIndex(object.id, node, count, "node of a tetrahedron");
      for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b) edges.push_back({std::min(tet[a], tet[b]), std::max(tet[a], tet[b])});
    }
    for (int node = 0; node < count; ++node) {
      GpuVertex v;
      v.node.fill(object.layout.qOffset + 3 * node);
      v.weight = {1, 0, 0, 0};
      addVertex(v, -1);
    }
    geometry.tetEdges = addEdges(edges, first);
    return Done{};
  }

  void addRegions(int i) {
    const SceneObject& object = m_model.objects[i];
    const Part* part = partOf(object);
    if (!part) return;
    for (const Region& region : part->regions) {
      const SurfaceRanges& surface = m_out.objects[i].surface(region.surface);
      if (!surface.present) continue;
      RegionRanges ranges{
          i, region.surface, region.id, region.kind, region.name, region.triangles, {static_cast<int>(m_out.indices.size()), 0}};
      for (const TriangleRun& run : region.triangles)
        for (int k = 3 * run.first; k < 3 * (run.first + run.count); ++k)
          m_out.indices.push_back(std::uint32_t(m_out.indices[surface.triangles.first + k]));
      ranges.triangles.count = static_cast<int>(m_out.indices.size()) - ranges.triangles.first;
      m_out.regions.push_back(ranges);
    }
  }

  Result<Done> addSprings() {
    m_out.springs.first = static_cast<int>(m_out.vertices.size());
    const int objects = static_cast<int>(m_model.objects.size());
    for (const SpringView& spring : m_model.springs) {
      m_out.springObjects.push_back({spring.objectA, spring.objectB});
      for (const auto& [object, binding] :
           {std::pair(spring.objectA, &spring.a), std::pair(spring.objectB, &spring.b)}) {
        if (object < 0 || object >= objects) return badIndex("", object, objects, "object of a spring");
        auto vertex = vertexOf(m_model.objects[object], *binding);
        if (!vertex) return vertex.error();
        addVertex(*vertex, -1);
      }
    }
    m_out.springs.count = static_cast<int>(m_out.vertices.size()) - m_out.springs.first;
    return Done{};
  }

  const Model& m_model;
  SceneGeometry m_out;
};

}  // namespace

Result<SceneGeometry> buildSceneGeometry(const Model& model) {
  return Builder(model).build();
}

Vec3 positionOf(const GpuVertex& vertex, const VecX& q) {
  const auto three = [&q](int at) -> Vec3 { return q.segment<3>(at); };
  if (vertex.node[1] < 0) {
    const int at = vertex.node[0];
    const Quat rotation(q[at + 6], q[at + 3], q[at + 4], q[at + 5]);
    return three(at) + rotation * Vec3(vertex.weight[0], vertex.weight[1], vertex.weight[2]);
  }
  Vec3 p = Vec3::Zero();
  for (int k = 0; k < 4; ++k) p += double{vertex.weight[k]} * three(vertex.node[k]);
  return p;
}

}  // namespace glenoid
