// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "simcore/body/ContactObject.h"
#include "simcore/linear/BlockSymbolic.h"

namespace glenoid {

/// The rows that the contacts of a step give to one coupling island, as sparse rows over its blocks. A contact
/// between two coupling islands gives a row to each; one inside an island, or of an object with itself, gives a single row
/// with both sides.
class IslandRows {
 public:
  void clear();
  /// Starts the row of a contact; terms follow by append.
  void begin(int contact);
  void append(const ContactObject& object, const MaterialPoint& point, const Vec3& direction, const VecX& q, int base);
  /// Ends the row: terms ascending by block, one for a block: where both points lie on one object they share nodes. A row
  /// without terms, or one that moves nothing because its points move alike, is taken back; false then.
  bool finish();

  int count() const { return static_cast<int>(m_contact.size()); }
  int contactOf(int row) const { return m_contact[row]; }
  /// Valid until the next begin() or clear().
  SparseRow row(int row) const {
    return {m_terms.data() + m_start[row], static_cast<std::size_t>(m_start[row + 1] - m_start[row])};
  }

 private:
  std::vector<RowTerm> m_terms;
  std::vector<int> m_start{0};
  std::vector<int> m_contact;
};

/// J v of one row; v: the island's velocities.
double dot(SparseRow row, const VecX& v);
/// r += Jᵀ λ of one row.
void addTransposed(SparseRow row, double lambda, VecX& r);

}  // namespace glenoid
