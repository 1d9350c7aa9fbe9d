// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>

#include "simcore/linear/BlockCholesky.h"
#include "simcore/step/Model.h"
#include "simcore/step/StepModel.h"

namespace glenoid {

/// How the elements of one soft object, alone at rest and held by the springs of its couplings with their other ends fixed,
/// answer static forces: the coarse counterpart of author/StaticPart. K is the step's own matrix for so long a step that
/// only stiffness is left in it, factored once. Constant: threads share it.
class StaticResponse {
 public:
  /// Of a free soft object; null where nothing holds it or K is not positive definite. After the model's springs are derived.
  static std::shared_ptr<const StaticResponse> make(const Model& model, const ContactObject& object, int index);

  /// W += J K⁻¹ Jᵀ, m/N, for a few rows over the object's own blocks, counted from 0.
  void add(std::span<const SparseRow> rows, std::span<const int> rowIds, RowPanels& scratch, Eigen::Ref<MatX> W) const;

 private:
  explicit StaticResponse(std::shared_ptr<const BlockSymbolic> symbolic) : m_factor(std::move(symbolic), true) {}
  BlockCholesky m_factor;
};

}  // namespace glenoid
