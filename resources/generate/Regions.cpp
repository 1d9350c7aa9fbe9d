// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/Regions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "resources/generate/Bones.h"
#include "simcore/scene/Joint.h"

namespace glenoid::generate {

namespace {

/// How near a surface must lie to bone to count as attached, mm.
constexpr double kAttached = 0.9;

Region make(std::string id, std::string name, std::string kind, std::vector<int> triangles) {
  Region region;
  region.id = std::move(id);
  region.name = std::move(name);
  region.kind = std::move(kind);
  region.triangles = runsOf(std::move(triangles));
  return region;
}

double toPath(const std::vector<Vec3>& path, const Vec3& p) {
  double best = 1e9;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec3 d = path[i + 1] - path[i];
    const double t = std::clamp((p - path[i]).dot(d) / d.squaredNorm(), 0.0, 1.0);
    best = std::min(best, (p - path[i] - t * d).norm());
  }
  return best;
}

std::vector<Region> scapulaRegions(const TriMesh& visual) {
  const Frame socket = scapula::glenoid();
  const std::vector<Vec2> rim = scapula::glenoidRim();
  return {
      regionWhere(visual, "glenoid-cartilage", "Glenoid cartilage", "cartilage",
                  [&](const Vec3& p) {
                    const Vec3 q = socket.toLocal(p);
                    const double depth = 30 - std::sqrt(std::max(900 - q.head<2>().squaredNorm(), 0.0));
                    return polygonDistance(rim, q.head<2>()) < -0.6 && std::abs(q.z() - depth) < 0.8;
                  }),
      regionWhere(visual, "acromion", "Acromion", "landmark",
                  [roof = scapula::acromionField()](const Vec3& p) { return roof(p) < 0.8; }),
      regionWhere(visual, "coracoid", "Coracoid process", "landmark",
                  [hook = scapula::coracoidField()](const Vec3& p) { return hook(p) < 0.8; }),
  };
}

std::vector<Region> humerusRegions(const TriMesh& visual) {
  const Vec3 axis = humerus::headAxis();
  const std::vector<Vec3> groove = humerus::groovePath();
  return {
      regionWhere(visual, "head-cartilage", "Cartilage of the humeral head", "cartilage",
                  [&](const Vec3& p) {
                    return p.dot(axis) > humerus::kHeadRadius - 19 &&
                           std::abs(p.norm() - humerus::kHeadRadius) < 0.6;
                  }),
      regionWhere(visual, "bicipital-groove", "Bicipital groove", "groove",
                  [&](const Vec3& p) { return toPath(groove, p) < 4.5; }),
      regionWhere(visual, "greater-tubercle", "Greater tubercle", "landmark",
                  [](const Vec3& p) {
                    return toPath({{6.5, 9.8, 16.8}, {-4.5, 4, 16.8}, {-4.5, -9, 16.2}}, p) < 12 &&
                           p.norm() > humerus::kHeadRadius + 0.8;
                  }),
      regionWhere(visual, "lesser-tubercle", "Lesser tubercle", "landmark",
                  [](const Vec3& p) {
                    return toPath({{19.2, 1.2, 0.2}, {17.4, -8, 3.4}}, p) < 9.5 &&
                           p.norm() > humerus::kHeadRadius + 0.8;
                  }),
  };
}

std::vector<Region> muscleRegions(const TriMesh& visual, const Bones& bones, int around, int along,
                                  double tendonFrom) {
  const Region onScapula =
      regionWhere(visual, "origin", "Origin on the scapula", "footprint",
                  [&](const Vec3& p) { return distance(bones.scapulaShape, p) < kAttached; });
  const Region onHumerus = regionWhere(visual, "insertion", "Insertion on the humerus", "footprint",
                                       [&](const Vec3& p) { return distance(bones.humerusShape, p) < 0.7; });
  return {common(onScapula, regionAlong(visual, around, along, "", "", "", 0, 0.55)),
          common(onHumerus, regionAlong(visual, around, along, "", "", "", 0.92, 1)),
          regionAlong(visual, around, along, "tendon", "Tendon", "tendon", tendonFrom, 1)};
}

}  // namespace

Region regionWhere(const TriMesh& visual, std::string id, std::string name, std::string kind,
                   const std::function<bool(const Vec3& centroid)>& rule) {
  std::vector<int> triangles;
  for (std::size_t t = 0; t < visual.triangles.size(); ++t) {
    const auto& v = visual.triangles[t];
    if (rule((visual.vertices[v[0]] + visual.vertices[v[1]] + visual.vertices[v[2]]) / 3))
      triangles.push_back(int(t));
  }
  return make(std::move(id), std::move(name), std::move(kind), std::move(triangles));
}

Region regionAlong(const TriMesh& visual, int around, int along, std::string id, std::string name,
                   std::string kind, double from, double to) {
  std::vector<int> triangles;
  const int rings = around * along;
  for (std::size_t t = 0; t < visual.triangles.size(); ++t) {
    double place = 0;
    for (const int v : visual.triangles[t])
      place += v < rings ? double(v / around) / (along - 1) : double(v - rings);
    if (place / 3 >= from && place / 3 <= to) triangles.push_back(int(t));
  }
  return make(std::move(id), std::move(name), std::move(kind), std::move(triangles));
}

Region common(const Region& a, const Region& b) {
  const std::vector<int> x = trianglesOf(a), y = trianglesOf(b);
  std::vector<int> both;
  std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(both));
  return make(a.id, a.name, a.kind, std::move(both));
}

std::vector<Region> regionsOf(const std::string& id, const TriMesh& visual, const Bones& bones) {
  const auto nearScapula = [&](const Vec3& p) { return distance(bones.scapulaShape, p) < kAttached; };
  const auto nearHumerus = [&](const Vec3& p) { return distance(bones.humerusShape, p) < kAttached; };
  if (id == "scapula") return scapulaRegions(visual);
  if (id == "humerus") return humerusRegions(visual);
  if (id == "supraspinatus") return muscleRegions(visual, bones, 26, 33, 0.72);
  if (id == "infraspinatus") return muscleRegions(visual, bones, 33, 32, 0.70);
  if (id == "subscapularis") return muscleRegions(visual, bones, 36, 34, 0.70);
  if (id == "coracoacromial-ligament")
    return {common(regionWhere(visual, "acromial-end", "End on the acromion", "footprint", nearScapula),
                   regionAlong(visual, 24, 34, "", "", "", 0, 0.45)),
            common(regionWhere(visual, "coracoid-end", "End on the coracoid", "footprint", nearScapula),
                   regionAlong(visual, 24, 34, "", "", "", 0.55, 1))};
  if (id == "coracohumeral-ligament")
    return {common(regionWhere(visual, "coracoid-end", "End on the coracoid", "footprint", nearScapula),
                   regionAlong(visual, 20, 13, "", "", "", 0, 0.4)),
            common(regionWhere(visual, "humeral-end", "End on both tubercles", "footprint", nearHumerus),
                   regionAlong(visual, 20, 13, "", "", "", 0.7, 1))};
  if (id == "transverse-humeral-ligament")
    return {
        common(regionWhere(visual, "lesser-end", "End on the lesser tubercle", "footprint", nearHumerus),
               regionAlong(visual, 12, 11, "", "", "", 0, 0.35)),
        common(regionWhere(visual, "greater-end", "End on the greater tubercle", "footprint", nearHumerus),
               regionAlong(visual, 12, 11, "", "", "", 0.65, 1))};
  if (id == "labrum")
    return {regionWhere(visual, "base", "Base on the glenoid rim", "footprint", nearScapula)};
  if (id == "labrum-tendon")
    return {regionAlong(visual, 8, 8, "root", "Root in the labrum", "footprint", 0, 0.3),
            regionAlong(visual, 8, 8, "tendon-end", "End in the biceps tendon", "footprint", 0.72, 1)};
  if (id == "biceps-tendon")
    return {regionAlong(visual, 6, 22, "distal-end", "Distal end below the groove", "footprint", 0.9, 1)};
  return {};
}

std::vector<Landmark> landmarksOf(const std::string& id, const Bones& bones) {
  std::vector<Landmark> landmarks;
  const auto add = [&](const char* slug, const char* name, const Vec3& mm) {
    landmarks.push_back({slug, name, 1e-3 * mm});
  };
  const auto onScapula = [&](const Vec3& p) { return project(bones.scapulaShape, p); };
  const auto onHumerus = [&](const Vec3& p) { return project(bones.humerusShape, p); };
  if (id == "scapula") {
    const Frame socket = scapula::glenoid();
    const auto rim = [&](double x, double y) {
      return onScapula(socket.toWorld({x, y, 30 - std::sqrt(900 - x * x - y * y)}));
    };
    add("trigonum-spinae", "Trigonum spinae (TS)", onScapula({-77.8, -15.9, -113.5}));
    add("inferior-angle", "Inferior angle (AI)", onScapula({-78.4, -136.1, -78.3}));
    add("superior-angle", "Superior angle", onScapula({-56.2, 28.9, -93.1}));
    add("acromial-angle", "Acromial angle (AA)", onScapula({-42.9, 23.3, 1.4}));
    add("acromion-tip", "Anterior tip of the acromion", onScapula({4.6, 38.0, -5.8}));
    add("coracoid-tip", "Tip of the coracoid process", onScapula({29.2, 11.1, -30.3}));
    add("glenoid-centre", "Centre of the glenoid", socket.origin);
    add("glenoid-superior", "Upper end of the glenoid", rim(0, 18.5));
    add("glenoid-inferior", "Lower end of the glenoid", rim(0, -18.4));
    add("glenoid-anterior", "Front of the glenoid", rim(14, -6));
    add("glenoid-posterior", "Back of the glenoid", rim(-13.8, -6));
  }
  if (id == "humerus") {
    add("head-centre", "Centre of the humeral head (GH)", Vec3::Zero());
    add("greater-tubercle-lateral", "Lateral point of the greater tubercle", onHumerus({2.0, 16.9, 26.7}));
    add("greater-tubercle-top", "Top of the greater tubercle", onHumerus({8.3, 22.2, 11.5}));
    add("lesser-tubercle", "Front of the lesser tubercle", onHumerus({27.3, -0.8, 4.0}));
    add("groove-top", "Upper end of the bicipital groove", onHumerus(humerus::groovePath().front()));
    add("groove-bottom", "Lower end of the bicipital groove", onHumerus(humerus::groovePath()[4]));
    add("lateral-epicondyle", "Lateral epicondyle (EL)", onHumerus(humerus::lateralEpicondyle()));
    add("medial-epicondyle", "Medial epicondyle (EM)", onHumerus(humerus::medialEpicondyle()));
  }
  return landmarks;
}

}  // namespace glenoid::generate
