// SPDX-License-Identifier: GPL-3.0-or-later
/// `bullet_peer [LIMIT] < SCENE`: runs the scene of the peers in Bullet's deformable world (corotational linear
/// elasticity, backward Euler, contacts of nodes with rigid shapes, which of its kinds were the steadiest) and prints
/// one JSON line with the fields of peers::Row. Stops after LIMIT seconds of computing, or once it has blown up.
/// Exit status 0 a row was printed, 2 no scene.
#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableLinearElasticityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include "SceneReader.h"

namespace bullet_peer {
namespace {

constexpr double kMargin = 0.0005;   // m, of every shape
constexpr double kTooFar = 0.05;     // m from rest: not stable any more
constexpr double kBlownUp = 1;       // m from rest: no use in going on
constexpr int kTouchable = 1, kDriven = 2, kUntouched = 4;  // groups of the broad phase

btVector3 toBullet(const Point& p) { return {p[0], p[1], p[2]}; }

double threadMs() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// The limits of the Krylov solver are members that only a subclass reaches. Its own, machine epsilon within 300
/// iterations, are never met.
struct Solver : btDeformableBodySolver {
  Solver() {
    m_cg.m_maxIterations = m_cr.m_maxIterations = 300;
    m_cg.m_tolerance = m_cr.m_tolerance = 1e-8;
    m_maxNewtonIterations = 1;  // one linearisation a step, as in ours
  }
};

/// Everything lives until the process ends: it ends right after its one row.
class World {
 public:
  explicit World(const SceneNumbers& scene) : m_scene(scene) {
    m_constraints.setDeformableSolver(&m_solver);
    m_world = new btDeformableMultiBodyDynamicsWorld(&m_dispatcher, &m_broadphase, &m_constraints, &m_configuration, &m_solver);
    const btVector3 gravity = toBullet(scene.gravity);
    m_world->setGravity(gravity);
    m_world->getWorldInfo().m_gravity = gravity;
    m_world->getWorldInfo().m_sparsesdf.setDefaultVoxelsz(0.0025);
    m_world->getWorldInfo().m_maxDisplacement = 0.02;
    m_world->setImplicit(true);
    m_world->setLineSearch(false);
    m_world->setUseProjection(true);
    btContactSolverInfo& info = m_world->getSolverInfo();
    info.m_deformable_erp = 0.2;
    info.m_deformable_cfm = 0;
    info.m_deformable_maxErrorReduction = 20;
    info.m_leastSquaresResidualThreshold = 1e-6;
    info.m_splitImpulse = true;
    info.m_numIterations = 50;

    m_fixed = addBody(0, new btBoxShape(toBullet(scene.boneHalf)), toBullet(scene.fixedCentre), kUntouched);
    m_moving = addBody(2, new btBoxShape(toBullet(scene.boneHalf)), toBullet(scene.movingCentre), kUntouched);
    m_ridge = addBody(0, new btBoxShape(toBullet(scene.ridgeHalf)), toBullet(scene.ridge[0]), kDriven);
    m_ball = addBody(0, new btSphereShape(scene.radius), toBullet(scene.ball[0]), kDriven);
    hold(*m_moving);
    for (const BlockNumbers& block : scene.blocks) addBlock(block);
    auto* weight = new btDeformableGravityForce(gravity);
    for (btSoftBody* soft : m_soft) m_world->addForce(soft, weight);
  }

  void step(long index) {
    place(*m_ball, m_scene.ball[index]);
    place(*m_ridge, m_scene.ridge[index]);
    m_world->stepSimulation(m_scene.dt, 1, m_scene.dt);
  }

  btVector3 node(std::size_t block, int index) const { return m_soft[block]->m_nodes[index].m_x; }

  int contacts() const {
    int count = 0;
    for (const btSoftBody* soft : m_soft) count += soft->m_nodeRigidContacts.size() + soft->m_faceRigidContacts.size();
    return count;
  }

  double bindingGap() const {
    double gap = 0;
    for (const btSoftBody* soft : m_soft)
      for (int i = 0; i < soft->m_deformableAnchors.size(); ++i) {
        const btSoftBody::DeformableNodeRigidAnchor& anchor = soft->m_deformableAnchors[i];
        const auto* bone = static_cast<const btRigidBody*>(anchor.m_cti.m_colObj);
        gap = std::max(gap, (bone->getWorldTransform() * anchor.m_local - anchor.m_node->m_x).length());
      }
    return gap;
  }

 private:
  btRigidBody* addBody(double mass, btCollisionShape* shape, const btVector3& centre, int group) {
    shape->setMargin(kMargin);
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    btTransform pose = btTransform::getIdentity();
    pose.setOrigin(centre);
    auto* body = new btRigidBody(
        btRigidBody::btRigidBodyConstructionInfo(mass, new btDefaultMotionState(pose), shape, inertia));
    body->setFriction(0);
    body->setActivationState(DISABLE_DEACTIVATION);
    if (group == kDriven) body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    m_world->addRigidBody(body, group, group == kDriven ? kTouchable : 0);
    if (mass > 0) {  // its weight is left out, as in the published figures
      body->setGravity({0, 0, 0});
      body->setFlags(body->getFlags() | BT_DISABLE_WORLD_GRAVITY);
    }
    return body;
  }

  /// The moving bone hangs on springs to where it starts.
  void hold(btRigidBody& bone) {
    const btTransform centre = btTransform::getIdentity();
    auto* springs = new btGeneric6DofSpring2Constraint(bone, centre);
    springs->setFrames(bone.getWorldTransform(), centre);
    for (int axis = 0; axis < 6; ++axis) {
      const bool linear = axis < 3;
      springs->setLimit(axis, 1, -1);  // low above high: free
      springs->enableSpring(axis, true);
      springs->setStiffness(axis, linear ? 2e4 : 50);
      springs->setDamping(axis, linear ? 100 : 0.5);
    }
    m_world->addConstraint(springs, true);
  }

  static void place(btRigidBody& body, const Point& centre) {
    btTransform pose = body.getWorldTransform();
    pose.setOrigin(toBullet(centre));
    body.getMotionState()->setWorldTransform(pose);
  }

  void addBlock(const BlockNumbers& block) {
    std::vector<btVector3> places;
    for (const Point& p : block.nodes) places.push_back(toBullet(p));
    std::vector<btScalar> mass(block.mass.begin(), block.mass.end());
    auto* soft = new btSoftBody(&m_world->getWorldInfo(), static_cast<int>(places.size()), places.data(), mass.data());
    for (const auto& t : block.tets) {
      soft->appendTetra(t[0], t[1], t[2], t[3]);
      // Links have no stiffness here; the tree of nodes is built along them and never ends without.
      for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b) soft->appendLink(t[a], t[b], nullptr, true);
    }
    for (const auto& f : block.faces) soft->appendFace(f[0], f[1], f[2]);
    soft->initializeDmInverse();
    soft->m_tetraScratches.resize(soft->m_tetras.size());
    soft->m_tetraScratchesTn.resize(soft->m_tetras.size());
    soft->getCollisionShape()->setMargin(kMargin);
    soft->m_cfg.kKHR = soft->m_cfg.kCHR = 1;
    soft->m_cfg.kDF = soft->m_cfg.kDP = 0;
    soft->m_cfg.collisions = btSoftBody::fCollision::SDF_RD | btSoftBody::fCollision::SDF_RDN;
    soft->setSelfCollision(false);
    soft->m_sleepingThreshold = 0;
    soft->setActivationState(DISABLE_DEACTIVATION);
    m_world->addSoftBody(soft, kTouchable, kDriven);
    for (const int node : block.fixed) soft->appendDeformableAnchor(node, m_fixed);
    for (const int node : block.moving) soft->appendDeformableAnchor(node, m_moving);
    m_soft.push_back(soft);

    const double shear = block.young / (2 * (1 + block.poisson));
    const double lambda = block.young * block.poisson / ((1 + block.poisson) * (1 - 2 * block.poisson));
    auto* elastic = new btDeformableLinearElasticityForce(shear, lambda, 0, 0);
    // addForce would merge forces of one type and with them the blocks' stiffnesses.
    elastic->addSoftBody(soft);
    elastic->setIndices(m_solver.getIndices());
    m_solver.getLagrangianForceArray()->push_back(elastic);
  }

  const SceneNumbers& m_scene;
  btSoftBodyRigidBodyCollisionConfiguration m_configuration;
  btCollisionDispatcher m_dispatcher{&m_configuration};
  btDbvtBroadphase m_broadphase;
  Solver m_solver;
  btDeformableMultiBodyConstraintSolver m_constraints;
  btDeformableMultiBodyDynamicsWorld* m_world = nullptr;
  std::vector<btSoftBody*> m_soft;
  btRigidBody *m_fixed = nullptr, *m_moving = nullptr, *m_ridge = nullptr, *m_ball = nullptr;
};

/// Distance of p from the segment ab.
double toSegment(const btVector3& p, const btVector3& a, const btVector3& b) {
  const btVector3 d = b - a;
  const double s = std::clamp((p - a).dot(d) / d.length2(), 0.0, 1.0);
  return (a + s * d - p).length();
}

double toTriangle(const btVector3& p, const btVector3& a, const btVector3& b, const btVector3& c) {
  const btVector3 n = (b - a).cross(c - a);
  const bool within = n.dot((b - a).cross(p - a)) > 0 && n.dot((c - b).cross(p - b)) > 0 && n.dot((a - c).cross(p - c)) > 0;
  if (within) return std::abs(n.dot(p - a)) / n.length();
  return std::min({toSegment(p, a, b), toSegment(p, b, c), toSegment(p, c, a)});
}

double sixVolumes(const btVector3& a, const btVector3& b, const btVector3& c, const btVector3& d) {
  return (b - a).dot((c - a).cross(d - a));
}

struct Figures {
  std::vector<double> ms;
  double furthest = 0, sphereDepth = 0, volumeRatioMin = 1, bindingGap = 0, contacts = 0;
  int contactsMax = 0;
  bool finite = true;
};

void look(const SceneNumbers& scene, const World& world, long index, Figures& figures) {
  const btVector3 centre = toBullet(scene.ball[index]);
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const BlockNumbers& block = scene.blocks[k];
    for (std::size_t i = 0; i < block.nodes.size(); ++i) {
      const double moved = (world.node(k, static_cast<int>(i)) - toBullet(block.nodes[i])).length();
      figures.finite = figures.finite && std::isfinite(moved);
      figures.furthest = std::max(figures.furthest, moved);
    }
    const auto x = [&](int i) { return world.node(k, i); };
    const auto rest = [&](int i) { return toBullet(block.nodes[i]); };
    for (const auto& [a, b, c, d] : block.tets)
      figures.volumeRatioMin = std::min(figures.volumeRatioMin, sixVolumes(x(a), x(b), x(c), x(d)) /
                                                                    sixVolumes(rest(a), rest(b), rest(c), rest(d)));
    for (const auto& [a, b, c] : block.faces)
      figures.sphereDepth = std::max(figures.sphereDepth, scene.radius - toTriangle(centre, x(a), x(b), x(c)));
  }
  figures.bindingGap = std::max(figures.bindingGap, world.bindingGap());
  figures.contactsMax = std::max(figures.contactsMax, world.contacts());
  figures.contacts += world.contacts();
}

/// Nearest rank of sorted values.
double quantile(const std::vector<double>& sorted, double q) {
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

}  // namespace
}  // namespace bullet_peer

int main(int argc, char** argv) {
  using namespace bullet_peer;
  static SceneNumbers scene;
  if (!readScene(std::cin, scene)) {
    std::fprintf(stderr, "usage: bullet_peer [LIMIT] < SCENE\n");
    return 2;
  }
  const double limitMs = 1e3 * (argc > 1 ? std::atof(argv[1]) : 60);
  auto* world = new World(scene);
  Figures figures;
  double spent = 0;
  for (long i = 1; i <= scene.steps && spent < limitMs && figures.finite && figures.furthest < kBlownUp; ++i) {
    const double begin = threadMs();
    world->step(i);
    figures.ms.push_back(threadMs() - begin);
    spent += figures.ms.back();
    look(scene, *world, i, figures);
  }
  const auto steps = static_cast<double>(figures.ms.size());
  std::sort(figures.ms.begin(), figures.ms.end());
  const auto yes = [](bool value) { return value ? "true" : "false"; };
  const auto number = [](double value) { return std::isfinite(value) ? value : 1e30; };  // JSON has no other
  std::printf("{\"simulator\": \"bullet-%d.%02d\", \"dt\": %.17g, \"simulated\": %.17g, \"msMedian\": %.6g, \"msP95\": %.6g, "
              "\"msP99\": %.6g, \"finite\": %s, \"stable\": %s, \"ballDepth\": %.6g, \"sphereDepth\": %.6g, "
              "\"volumeRatioMin\": %.6g, \"bindingGap\": %.6g, \"contactsMean\": %.6g, \"contactsMax\": %d}\n",
              btGetVersion() / 100, btGetVersion() % 100, scene.dt, steps * scene.dt, quantile(figures.ms, 0.5),
              quantile(figures.ms, 0.95), quantile(figures.ms, 0.99), yes(figures.finite),
              yes(figures.finite && figures.furthest < kTooFar && figures.volumeRatioMin > 0), number(figures.sphereDepth),
              number(figures.sphereDepth), number(figures.volumeRatioMin), number(figures.bindingGap),
              figures.contacts / steps, figures.contactsMax);
  std::fflush(stdout);
  std::_Exit(0);
}
