// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "simcore/base/ThreadClock.h"
#include "simcore/base/Worker.h"
#include "simcore/collide/ProximityFinder.h"
#include "simcore/contact/ContactIslands.h"
#include "simcore/contact/ContactRows.h"
#include "simcore/contact/Coulomb.h"
#include "simcore/contact/ImpulseResponse.h"
#include "simcore/contact/Lcp.h"
#include "simcore/contact/VelocitySystem.h"
#include "simcore/linear/ConjugateGradients.h"
#include "simcore/linear/RowPanels.h"
#include "simcore/step/Actions.h"
#include "simcore/step/ContactBudget.h"
#include "simcore/step/IslandViews.h"
#include "simcore/step/StepModel.h"
#include "simcore/step/Stepper.h"
#include "simcore/step/TipLaw.h"

namespace glenoid {

/// D of the splitting A = D − L − U for one coupling island: a pattern of A's own blocks, and its factor.
struct Splitting {
  std::shared_ptr<const BlockSymbolic> symbolic;
  std::vector<std::array<int, 2>> slots;   ///< slot of D, slot of A, for the lower blocks that D keeps
  std::vector<char> transposed;            ///< the two store it turned
  VecX sharedMass;                         ///< of each block with blocks outside D, which D's diagonal takes, kg; empty: none
  std::unique_ptr<BlockMatrix> D;
  std::unique_ptr<ImpulseResponse> response;
};

/// Scratch of one coupling island.
struct IslandWork {
  explicit IslandWork(const CouplingIslandModel& model) : A(model.symbolic) {}
  BlockMatrix A;
  std::unique_ptr<ImpulseResponse> response;  ///< of A; none in the paper profile
  Splitting byNode, byObject;                 ///< paper profile only
  Splitting* splitting = nullptr;             ///< the one in use this step
  VecX b, v;                                  ///< right-hand side; velocities, first unconstrained
  VecX free;                                  ///< the unconstrained ones
  VecX residual, change;                      ///< scratch, as long as b
  IslandRows rows;                            ///< normal row of each contact
  IslandRows tangents;                        ///< two rows of each chosen contact that has friction
  std::vector<SparseRow> chosen;              ///< rows that are unknowns of the contact problem
  std::vector<int> chosenIds;                 ///< their places among its unknowns
  std::vector<double> lambda;                 ///< their impulses, N·s
  CgWork cg;
  PowerWork power;
};

/// One contact of the step: the detector's pair, as points of two objects.
struct StepContact {
  int objectA = -1, objectB = -1, islandA = -1, islandB = -1;
  const Proximity* near = nullptr;       ///< what the search found, valid in this step
  bool film = false;                     ///< of a bursa
  MaterialPoint a, b;
  double target = 0;                     ///< c of J v ≥ c, m/s
  Vec3 drift_W = Vec3::Zero();           ///< what prescribed motions add to the velocity of a against b, m/s
  double compliance = 0;                 ///< C of J v + C λ ≥ c, 1/kg; above zero for a film or a dent
  int touch = -1;                        ///< its place in Work::touches; −1: of two features, as hard as their elements
  bool bed = false;                      ///< the bottom of a dent, beside the contact that makes it
  double speed = 0;                      ///< J v + n·drift + C λ − c, m/s
  double coefficient = 0;                ///< Coulomb's; 0 where friction is off
  std::array<Vec3, 2> tangent_W;         ///< set where friction is on
  double impulse = 0;                    ///< along the normal, N·s: last step's, then this one's
  Vec3 friction_W = Vec3::Zero();        ///< tangential impulse on a, N·s, likewise
  bool chosen = false;                   ///< an unknown of the problem
  bool leftOut = false;                  ///< for the bound on a step's time, and not to be taken in again
  int unknown = -1;                      ///< its place in Work::unknowns
};

/// A round tool on a soft part that gives under it: one contact in place of all features that are near there, spread over
/// the patch that it presses. Touches.cpp has the law.
struct Touch {
  static constexpr int kPoints = 7;
  Proximity near;                             ///< features of the deepest contact; normal, gap and key of its own
  std::array<MaterialPoint, kPoints> points;  ///< of the part's visual surface, over which its force is spread
  MaterialPoint middle;                       ///< what it is about
  Vec3 place_W = Vec3::Zero();                ///< where that is
  MaterialPoint onTool;
  TipLaw law;
  double ownCompliance = 0;                   ///< of the part's own elements there at rest, m/N
  double lastImpulse = 0;                     ///< N·s
  Vec3 lastFriction_W = Vec3::Zero();
};
/// Shares of a touch's points in its force: those of Hertz' pressure, exact to the fourth moment.
inline constexpr std::array<double, Touch::kPoints> kTouchWeights{0.3, 0.7 / 6, 0.7 / 6, 0.7 / 6, 0.7 / 6, 0.7 / 6, 0.7 / 6};

/// Adds thread CPU time to a stage of the report while it lives.
class StageClock {
 public:
  StageClock(StepReport& report, Stage stage) : m_total(report.cpuMs[static_cast<int>(stage)]), m_begin(nowMs()) {}
  ~StageClock() { m_total += nowMs() - m_begin; }
  static double nowMs() { return threadCpuMs(); }

 private:
  double& m_total;
  double m_begin;
};

/// All scratch of a Stepper.
struct Stepper::Work {
  std::shared_ptr<const Model> model;
  const StepModel* inside;
  StepperOptions options;
  StepSettings settings;
  PaperLimits paper;
  PaperSettings additions;            ///< all of them in every profile but `paper`
  double recoverySpeedMax = 0;        ///< of c, m/s; infinite where c is not cut
  StepReport report;
  ContactBudget budget;
  std::unique_ptr<IslandViews> views; ///< null: nobody watches islands
  std::vector<IslandWork> islands;
  std::vector<Pose> wanted;           ///< hand of each tool at the end of the step
  std::vector<Pose> hands;            ///< at the end of the part of it that is being solved
  std::vector<double> turnStiffness;  ///< of each rigid object with couplings: Σ k r², N·m
  VecX rotations;
  double partBegin = 0;                   ///< when the part of the step that is being solved begins, s
  std::vector<Twist> drivenTwists;        ///< of inside->driven, in that part
  std::vector<Vec3> pressureScratch;      ///< two entries for each point of the largest pressure

  // Collision, filled by its own thread where there are two. Motion 0 is what the step begins with, each further
  // one what a solve answered that the search had not foreseen.
  std::unique_ptr<ProximityFinder> finder;
  using Surfaces = std::vector<std::vector<Vec3>>;
  using Spans = std::vector<std::span<const Vec3>>;
  Surfaces positions;
  Spans positionSpans;
  std::array<Surfaces, ProximityFinder::kMotionsMost> velocities;
  std::array<Spans, ProximityFinder::kMotionsMost> velocitySpans;
  int motionCount = 0;
  VecX solved;                        ///< velocities of all objects as the last solve left them
  std::vector<LastNormal> lastNormals;   ///< of the contacts that pressed in the last step
  const std::vector<Proximity>* proximities = nullptr;
  std::vector<FilmSearch> filmSearches;  ///< one for each bursa
  std::vector<const std::vector<FilmTouch>*> films;  ///< what they found
  const State* stateSeen = nullptr;   ///< what the collision thread reads
  StepReport collideReport;           ///< its stage times
  double workerMs = 0;                ///< their sum over the parts of a step
  std::unique_ptr<Worker> worker;

  // Contact.
  std::vector<StepContact> contacts;
  std::vector<std::array<int, 2>> sides;
  std::vector<Touch> touches;
  std::vector<int> touchOf;               ///< of each proximity: −1: a contact of its own
  std::vector<int> deepestFirst;          ///< scratch of the search for them
  IslandRows touchRows;
  RowPanels touchPanels;
  MatX touchResponse = MatX::Zero(5, 5);
  std::unique_ptr<ContactIslandBuilder> islandBuilder;
  std::vector<ContactUnknowns> unknowns;  ///< of the contact island at hand
  std::vector<int> unknownContacts;       ///< their contacts
  int tangentialRows = 0;
  MatX W;
  VecX d, lambda;
  VecX target;                            ///< paper profile: d without J v
  LcpWork lcp;
  CoulombWork coulomb;
  std::vector<std::unique_ptr<VelocitySystem>> velocitySystems;  ///< by the first coupling island of a contact island
  std::vector<VelocityIsland> velocityIslands;
  std::vector<double> compliances;        ///< of the unknown contacts' normal rows

  /// The first search of a step.
  void findProximities(const State& state);
  /// What the last search cost, into the budget.
  void countSearch();
  /// Whether the solve moves some surface further from what the search foresaw than its slack, half the contact
  /// distance; if so the search is made again with that motion too. What it finds is then complete.
  bool searchAgain(const State& state);
};

/// Into how many equal parts the step must be cut, 1 … kPartsMost, for what it turns to be near enough to its
/// linearisation; from the velocities of a trial over the whole step. Needs work.solved.
int partsOf(const Stepper::Work& work, const State& state);
/// Σ k r² of the couplings at each rigid object.
std::vector<double> turnStiffnessOf(const StepModel& inside);
/// The hands of this step: what came in, or the last pose where that is no pose of a hand.
void takeHands(Stepper::Work& work, const Inputs& inputs, const State& state);
/// work.hands for one of the remaining equal parts of the step: on the way from the state's hands to the wanted ones.
void moveHands(Stepper::Work& work, const State& state, int partsLeft);
/// How driven objects move in the part of the step that begins.
void foreseeDriven(Stepper::Work& work);
/// Velocity of a place of an object by its motion; zero for one that is not driven.
Vec3 drivenVelocity(const Stepper::Work& work, int object, const Vec3& p_W);
/// Velocities of the surfaces of driven objects into one motion of the search; after positions.
void drivenSurfaces(Stepper::Work& work, int motion);
/// What motions add at every contact; after all contacts are built.
void driftContacts(Stepper::Work& work);
/// Forces, A and b of each coupling island.
void assembleIslands(Stepper::Work& work, const State& state);
/// One solve for each coupling island; false where one has no finite answer.
bool solveUnconstrained(Stepper::Work& work, const State& state);
/// Turns what the detector found into rows.
void buildContacts(Stepper::Work& work, const State& state);
/// And what feels the film of a bursa; after buildContacts.
void buildFilmContacts(Stepper::Work& work, const State& state);
/// Where round tools touch what gives under them, from what the detector found; before buildContacts.
void findTouches(Stepper::Work& work, const State& state);
/// Their contacts; after buildContacts, before films.
void buildTouches(Stepper::Work& work, const State& state);
/// Coulomb's coefficient of a contact: the geometric mean of both sides; inside a bursa the bursa's.
double coefficientOf(const Stepper::Work& work, const StepContact& contact);
/// Dents of the report.
void showDents(Stepper::Work& work);
/// The row of contact c along `direction` (on a, against it on b) for one or two coupling islands; false where
/// nothing that it touches can move.
bool appendContactRow(Stepper::Work& work, const State& state, int c, const Vec3& direction,
                      IslandRows IslandWork::* rowsOf);
/// One complementarity problem for each contact island; velocities become the constrained ones.
void solveConstrained(Stepper::Work& work, const State& state);
/// Lays out the unknowns of the chosen contacts: their rows in each coupling island, −c in d, last impulses in λ.
int chooseRows(Stepper::Work& work, const State& state, const ContactIsland& island);
/// Of the chosen contacts of an island the deepest of each pair stay, up to so many rows.
void keepDeepest(Stepper::Work& work, const ContactIsland& island, int rowsMost);
/// Room for n rows of W.
void sizeDelassus(Stepper::Work& work, int n);
/// C of the chosen contacts onto W's diagonal.
void addCompliance(Stepper::Work& work);
/// Solves for λ with the n unknowns in W and d.
LcpReport solveChosen(Stepper::Work& work, int n, const LcpLimits& limits);
/// λ back to the contacts.
void takeImpulses(Stepper::Work& work);
/// Contacts and tool forces of the report.
void showContacts(Stepper::Work& work);
/// What islands did, into Work::views, which must be there (IslandViews.cpp): before the step; of a contact island that was just
/// solved, from what was counted before it; and once all are.
void beginViews(Stepper::Work& work);
void viewIsland(Stepper::Work& work, const ContactIsland& island, const ContactSolverCounts& before, double beginMs);
void viewResidual(Stepper::Work& work, ContactIslandView& view);
/// The published splitting for one contact island, in place of the direct solve.
void solveContactIslandBySplitting(Stepper::Work& work, const State& state, const ContactIsland& island);
/// Prepares the splittings of an island at construction, and this step's D with its factor.
void makeSplittings(const CouplingIslandModel& model, const StepModel& inside, bool portable, IslandWork& island);
void chooseSplitting(Stepper::Work& work, IslandWork& island);

}  // namespace glenoid
