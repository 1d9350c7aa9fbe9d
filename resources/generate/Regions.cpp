// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/Regions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "resources/generate/Bones.h"
#include "resources/generate/Flesh.h"
#include "simcore/scene/Joint.h"

namespace glenoid::generate {

namespace {

/// How near a surface must lie to bone to count as attached, mm.
constexpr double kAttached = 0.9;
/// The humeral end of the coracohumeral ligament bridges the groove on the biceps tendon, 1 to 3 mm off bone.
constexpr double kBridging = 3.0;

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

/// Whether a point of the humerus lies in a muscle's footprint: `length` along the border of the cartilage,
/// `width` away from it, about the last station but two; the tendon's border lies at the last.
bool inFootprint(const std::vector<Station>& path, double length, double width, const Vec3& p) {
  const Station &before = path[path.size() - 4], &middle = path[path.size() - 3], &after = path[path.size() - 2];
  const Vec3 out = middle.up.normalized(), way = after.base - before.base;
  const Vec3 along = way.cross(out).normalized(), fibre = out.cross(along), d = p - middle.base;
  return std::abs(d.dot(along)) < length / 2 && std::abs(d.dot(fibre)) < width / 2 &&
         std::abs(d.dot(out)) < 12;
}

/// Cap of the head that is covered with cartilage, 19 mm high (Iannotti 1992), and what lies within `thickness` of it.
bool onCartilage(const Vec3& p, double thickness) {
  return p.dot(humerus::headAxis()) > humerus::kHeadRadius - 19 &&
         std::abs(p.norm() - humerus::kHeadRadius) < thickness;
}

std::vector<Region> scapulaRegions(const TriMesh& visual) {
  const Frame socket = scapula::glenoid();
  const std::vector<Vec2> rim = scapula::glenoidRim();
  const auto near = [](const Vec3& at, double radius) {
    return [=](const Vec3& p) { return (p - at).norm() < radius; };
  };
  const auto inBlade = [](const Vec3& p) { return scapula::blade().toLocal(p); };
  return {
      regionWhere(visual, "glenoid-cartilage", "Cavitas glenoidalis (glenoid cartilage)", "cartilage",
                  [&](const Vec3& p) {
                    const Vec3 q = socket.toLocal(p);
                    return polygonDistance(rim, q.head<2>()) < -0.4 &&
                           std::abs(q.z() - scapula::socketHeight(q.x(), q.y())) < 0.8;
                  }),
      regionWhere(visual, "acromion", "Acromion (roof of the shoulder)", "landmark",
                  [roof = scapula::acromionField()](const Vec3& p) { return roof(p) < 0.8; }),
      regionWhere(visual, "acromial-angle", "Angulus acromii (acromial angle)", "landmark",
                  near({-42.9, 22.5, 1.4}, 8)),
      regionWhere(visual, "coracoid", "Processus coracoideus (coracoid)", "landmark",
                  [hook = scapula::coracoidField()](const Vec3& p) { return hook(p) < 0.8; }),
      regionWhere(visual, "coracoid-tip", "Apex processus coracoidei (coracoid tip)", "landmark",
                  near({29.2, 11.1, -30.3}, 9)),
      regionWhere(visual, "biceps-anchor", "Tuberculum supraglenoidale (biceps anchor)", "footprint",
                  near({-10.5, 14.5, -24.9}, 7)),
      regionWhere(visual, "supraspinous-fossa", "Fossa supraspinata (hollow above the spine)", "other",
                  [&](const Vec3& p) {
                    const Vec3 q = inBlade(p);
                    return q.y() > 2 && q.x() < 92 && q.z() > -11 && q.z() < 12 && q.y() > 0.15 * q.x() - 2;
                  }),
      regionWhere(visual, "scapular-spine", "Spina scapulae (spine of the scapula)", "landmark",
                  [&](const Vec3& p) {
                    const Vec3 q = inBlade(p);
                    return q.x() > 0 && q.x() < 100 && q.z() > 0.3 * q.x() + 4;
                  }),
  };
}

std::vector<Region> humerusRegions(const TriMesh& visual) {
  const std::vector<Vec3> groove = humerus::groovePath();
  // Less than published (Curtis 2006) by what whole triangles stand over the border.
  const auto facet = [](const std::vector<Station>& path, double length, double width) {
    return [=](const Vec3& p) { return inFootprint(path, length - 2, width - 4.5, p); };
  };
  return {
      regionWhere(visual, "head-cartilage", "Caput humeri (cartilage of the humeral head)", "cartilage",
                  [](const Vec3& p) { return onCartilage(p, 0.6); }),
      regionWhere(visual, "bicipital-groove", "Sulcus intertubercularis (bicipital groove)", "groove",
                  [&](const Vec3& p) { return toPath(groove, p) < 4.5; }),
      regionWhere(visual, "greater-tubercle", "Tuberculum majus (greater tubercle)", "landmark",
                  [](const Vec3& p) {
                    return toPath({{6.5, 9.8, 16.8}, {-4.5, 4, 16.8}, {-4.5, -9, 16.2}}, p) < 12 &&
                           p.norm() > humerus::kHeadRadius + 0.8;
                  }),
      regionWhere(visual, "superior-facet", "Tuberculum majus, facies superior (supraspinatus facet)",
                  "footprint", facet(supraspinatusPath(), 23, 16)),
      regionWhere(visual, "middle-facet", "Tuberculum majus, facies media (infraspinatus facet)", "footprint",
                  facet(infraspinatusPath(), 29, 19)),
      regionWhere(
          visual, "inferior-facet", "Tuberculum majus, facies inferior (teres minor facet)", "footprint",
          [&](const Vec3& p) {
            return toPath({{-14, -11, 22}, {-4, -11, 27}}, p) < 7 && p.norm() > humerus::kHeadRadius + 0.5;
          }),
      regionWhere(visual, "lesser-tubercle", "Tuberculum minus (lesser tubercle)", "landmark",
                  [](const Vec3& p) {
                    return toPath({{19.2, 1.2, 0.2}, {17.4, -8, 3.4}}, p) < 9.5 &&
                           p.norm() > humerus::kHeadRadius + 0.8;
                  }),
      regionWhere(visual, "lesser-tubercle-facet", "Tuberculum minus, facies (subscapularis facet)",
                  "footprint", facet(subscapularisPath(), 40, 20)),
      regionWhere(visual, "bare-area", "Area nuda capitis humeri (bare area)", "landmark",
                  [&](const Vec3& p) {
                    return std::abs(p.norm() - humerus::kHeadRadius) < 1.2 && !onCartilage(p, 0.6) && p.x() < -8 &&
                           p.y() > -14 && p.z() > -2;
                  }),
      regionWhere(visual, "rotator-interval", "Intervallum rotatorum (rotator interval)", "landmark",
                  [&](const Vec3& p) {
                    return std::abs(p.norm() - humerus::kHeadRadius) < 1.5 && p.x() > 8 && p.y() > 10.5 &&
                           p.z() < 10 && p.y() < 21.5;
                  }),
  };
}

/// `bondedWidth`: mm of the tendon along its fibres that is bonded, chosen so that whole triangles give the
/// published width.
std::vector<Region> muscleRegions(const TriMesh& visual, const Bones& bones, const std::vector<Station>& path,
                                  double tendonFrom, double bondedWidth, const char* origin, const char* insertion) {
  const auto place = [path](const Vec3& p) { return placeAlong(path, p); };
  return {regionWhere(
              visual, "origin", origin, "footprint",
              [&](const Vec3& p) { return distance(bones.scapulaShape, p) < kAttached && place(p) < 0.62; }),
          regionWhere(visual, "insertion", insertion, "footprint",
                      [&](const Vec3& p) {
                        return !onCartilage(p, 1) && distance(bones.humerusShape, p) < kAttached &&
                               inFootprint(path, 100, bondedWidth, p);
                      }),
          regionWhere(visual, "tendon", "Tendo (tendon)", "tendon",
                      [&](const Vec3& p) { return place(p) > tendonFrom; })};
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

std::vector<Region> labrumTendonRegions(const TriMesh& visual, int around, int along) {
  return {regionAlong(visual, around, along, "root", "Radix (root in the labrum)", "footprint", 0, 0.3),
          regionAlong(visual, around, along, "tendon-end", "Finis (end in the biceps tendon)", "footprint", 0.72, 1)};
}

std::vector<Region> regionsOf(const std::string& id, const TriMesh& visual, const Bones& bones) {
  const auto nearScapula = [&](const Vec3& p) { return distance(bones.scapulaShape, p) < kAttached; };
  const auto nearHumerus = [&](const Vec3& p) { return distance(bones.humerusShape, p) < kAttached; };
  if (id == "scapula") return scapulaRegions(visual);
  if (id == "humerus") return humerusRegions(visual);
  if (id == "supraspinatus")
    return muscleRegions(visual, bones, supraspinatusPath(), 0.76, 16,
                         "Origo: fossa supraspinata (origin above the spine)",
                         "Insertio: tuberculum majus (insertion, superior facet)");
  if (id == "infraspinatus")
    return muscleRegions(visual, bones, infraspinatusPath(), 0.76, 20.5,
                         "Origo: fossa infraspinata (origin below the spine)",
                         "Insertio: tuberculum majus (insertion, middle facet)");
  if (id == "subscapularis")
    return muscleRegions(visual, bones, subscapularisPath(), 0.76, 16.5,
                         "Origo: fossa subscapularis (origin in front)",
                         "Insertio: tuberculum minus (insertion, lesser tubercle)");
  if (id == "teres-minor")
    return muscleRegions(visual, bones, teresMinorPath(), 0.76, 14,
                         "Origo: margo lateralis scapulae (origin on the lateral border)",
                         "Insertio: tuberculum majus (insertion, inferior facet)");
  if (id == "coracoacromial-ligament")
    return {common(regionWhere(visual, "acromial-end", "Acromion (end on the acromion)", "footprint",
                               nearScapula),
                   regionAlong(visual, 24, 34, "", "", "", 0, 0.45)),
            common(regionWhere(visual, "coracoid-end", "Processus coracoideus (end on the coracoid)",
                               "footprint", nearScapula),
                   regionAlong(visual, 24, 34, "", "", "", 0.55, 1))};
  if (id == "coracohumeral-ligament")
    return {common(regionWhere(visual, "coracoid-end", "Processus coracoideus (end on the coracoid)",
                               "footprint", nearScapula),
                   regionAlong(visual, 20, 13, "", "", "", 0, 0.4)),
            common(regionWhere(visual, "humeral-end", "Tubercula (end on both tubercles)", "footprint",
                               [&](const Vec3& p) { return distance(bones.humerusShape, p) < kBridging; }),
                   regionAlong(visual, 20, 13, "", "", "", 0.7, 1))};
  if (id == "transverse-humeral-ligament")
    return {common(regionWhere(visual, "lesser-end", "Tuberculum minus (end on the lesser tubercle)",
                               "footprint", nearHumerus),
                   regionAlong(visual, 10, 13, "", "", "", 0, 0.35)),
            common(regionWhere(visual, "greater-end", "Tuberculum majus (end on the greater tubercle)",
                               "footprint", nearHumerus),
                   regionAlong(visual, 10, 13, "", "", "", 0.65, 1))};
  if (id == "labrum")
    return {regionWhere(visual, "base", "Labrum glenoidale, basis (base on the glenoid rim)", "footprint",
                        nearScapula),
            regionWhere(visual, "biceps-anchor", "Labrum glenoidale, pars superior (biceps anchor)",
                        "landmark", [at = scapula::glenoid().toWorld({0.2, 19.5, 5.8})](const Vec3& p) {
                          return (p - at).norm() < 8;
                        })};
  if (id == "labrum-tendon") return labrumTendonRegions(visual, kAnchorAround, kAnchorAlong);
  if (id == "biceps-tendon")
    return {regionAlong(visual, 6, 22, "intra-articular", "Pars intraarticularis (part over the head)",
                        "tendon", 0, 0.36),
            regionAlong(visual, 6, 22, "in-groove", "Pars intertubercularis (part in the groove)", "tendon",
                        0.4, 0.66),
            regionAlong(visual, 6, 22, "distal-end", "Finis distalis (distal end below the groove)",
                        "footprint", 0.9, 1)};
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
      return onScapula(socket.toWorld({x, y, scapula::socketHeight(x, y)}));
    };
    add("trigonum-spinae", "Trigonum spinae (root of the spine, TS)", onScapula({-77.8, -15.9, -113.5}));
    add("inferior-angle", "Angulus inferior (lower tip, AI)", onScapula({-78.4, -136.1, -78.3}));
    add("superior-angle", "Angulus superior (upper corner)", onScapula({-56.2, 28.9, -93.1}));
    add("acromial-angle", "Angulus acromii (acromial angle, AA)", onScapula({-42.9, 22.5, 1.4}));
    add("acromion-tip", "Acromion, apex (front tip of the acromion)", onScapula({4.6, 37.6, -5.8}));
    add("acromion-anterolateral", "Acromion, angulus anterior (front corner)", onScapula({1.1, 37.4, -0.6}));
    add("acromion-lateral", "Acromion, margo lateralis (side edge)", onScapula({-19.5, 34.4, 6.6}));
    add("coracoid-tip", "Apex processus coracoidei (coracoid tip, PC)", onScapula({29.2, 11.1, -30.3}));
    add("glenoid-centre", "Cavitas glenoidalis (centre of the glenoid)", socket.origin);
    add("glenoid-superior", "Cavitas glenoidalis, superior (upper end)", rim(1.6, 18.7));
    add("glenoid-inferior", "Cavitas glenoidalis, inferior (lower end)", rim(1.6, -17.9));
    add("glenoid-anterior", "Cavitas glenoidalis, anterior (front)", rim(15, -5.2));
    add("glenoid-posterior", "Cavitas glenoidalis, posterior (back)", rim(-12.4, -5.2));
    add("supraglenoid-tubercle", "Tuberculum supraglenoidale (biceps anchor)",
        onScapula({-10.5, 14.5, -24.9}));
  }
  if (id == "humerus") {
    add("head-centre", "Centrum capitis (centre of the humeral head, GH)", Vec3::Zero());
    add("head-top", "Caput humeri, superior (top of the head)", onHumerus({-1.1, 24.1, 0.4}));
    add("head-apex", "Caput humeri, apex (middle of the cartilage)",
        onHumerus(humerus::kHeadRadius * humerus::headAxis()));
    add("greater-tubercle-lateral", "Tuberculum majus, lateralis (side of the greater tubercle)",
        onHumerus({2.0, 16.9, 26.7}));
    add("greater-tubercle-top", "Tuberculum majus, apex (top of the greater tubercle)",
        onHumerus({8.3, 22.2, 9.8}));
    add("superior-facet", "Facies superior (supraspinatus facet)", onHumerus({9.0, 15.7, 23.3}));
    add("middle-facet", "Facies media (infraspinatus facet)", onHumerus({-8.2, 9.7, 24.7}));
    add("inferior-facet", "Facies inferior (teres minor facet)", onHumerus({-5.5, -5.5, 26.2}));
    add("lesser-tubercle", "Tuberculum minus (front of the lesser tubercle)", onHumerus({27.3, -0.8, 3.9}));
    add("lesser-tubercle-facet", "Tuberculum minus, facies (subscapularis facet)",
        onHumerus({23.8, 1.4, -2.2}));
    add("groove-top", "Sulcus intertubercularis, superior (upper end of the groove)",
        onHumerus(humerus::groovePath().front()));
    add("groove-middle", "Sulcus intertubercularis, medius (middle of the groove)",
        onHumerus({17.7, 3.2, 13.0}));
    add("groove-bottom", "Sulcus intertubercularis, inferior (lower end of the groove)",
        onHumerus(humerus::groovePath()[4]));
    add("deltoid-tuberosity", "Tuberositas deltoidea (deltoid tuberosity)", onHumerus({-3.7, -99.5, 42.8}));
    add("lateral-epicondyle", "Epicondylus lateralis (outer elbow, EL)",
        onHumerus(humerus::lateralEpicondyle()));
    add("medial-epicondyle", "Epicondylus medialis (inner elbow, EM)",
        onHumerus(humerus::medialEpicondyle()));
  }
  return landmarks;
}

}  // namespace glenoid::generate
