// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/collide/Penetration.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// Which parts (or tools) and pairs a trace follows, by id.
struct TraceWishes {
  std::vector<std::string> parts;                 ///< empty: all that move
  std::vector<std::array<std::string, 2>> pairs;  ///< empty: all that touch in a row of the trace
  int every = 1;                                  ///< steps between two rows, ≥ 1
};

/// "id,id,…" and "a:b,c:d,…". Fail with BadUsage.
Result<std::vector<std::string>> tracePartsIn(const std::string& list);
Result<std::vector<std::array<std::string, 2>>> tracePairsIn(const std::string& list);

/// A table of how parts move and press on each other: a row at the start and one after every `every` steps. Columns: time;
/// penetration (m, the deepest of all pairs that may collide at the row's state, as the report's penetrationMax is
/// measured: PenetrationCheck on the collision surfaces, less what a dent lets pass; 0: nothing is inside anything); for
/// each part ID.x y z (centre of mass, m), ID.vx vy vz (m/s), ID.qx qy qz qw (turn, unit quaternion), ID.wx wy wz (rad/s),
/// as readPart has them; for each pair A:B.contacts (that press), A:B.fx fy fz (force on A with friction, N), A:B.normal
/// (sum of normal forces, N), of the last step before the row, and A:B.penetration (m, of that pair). Depths are the
/// caller's to measure; where nobody did, or nothing may collide, their cells are empty. The model must outlive it.
class Trace {
 public:
  /// Fails with UnknownId (arguments: id, "part") or BadUsage (a pair of a part with itself).
  static Result<Trace> make(const Model& model, const TraceWishes& wishes);

  /// `depths`: by pair of the model, of that state; empty: not measured.
  void begin(const State& start, std::span<const Penetration> depths = {});
  /// After every step.
  void add(const StepReport& step, const State& state, std::span<const Penetration> depths = {});

  /// Comma-separated with a header; every number reads back as it was.
  std::string csv() const;

 private:
  struct PairForce {
    int row, pair, contacts;
    Vec3 force_W;
    double normal;
  };
  struct PairDepth {
    int row, pair;  ///< pair of the model
    double depth;
  };
  Trace(const Model& model) : m_model(&model) {}
  void addRow(const State& state, std::span<const Penetration> depths);
  int modelPair(int a, int b) const;
  int pairOf(int a, int b, double& sign);

  const Model* m_model;
  int m_every = 1;
  bool m_anyPair = true;
  std::vector<int> m_parts;                ///< objects
  std::vector<std::array<int, 2>> m_pairs; ///< objects
  std::vector<double> m_values;            ///< time and parts, row by row
  std::vector<PairForce> m_forces;         ///< where something presses
  std::vector<PairDepth> m_depths;         ///< where something is inside, by row
  std::vector<char> m_measured;            ///< by row
  int m_rows = 0;
  long m_steps = 0;
};

}  // namespace glenoid
