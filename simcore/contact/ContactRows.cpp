// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/ContactRows.h"

#include <algorithm>

namespace glenoid {

void IslandRows::clear() {
  m_terms.clear();
  m_contact.clear();
  m_start.assign(1, 0);
}

void IslandRows::begin(int contact) { m_contact.push_back(contact); }

void IslandRows::append(const ContactObject& object, const MaterialPoint& point, const Vec3& direction, const VecX& q,
                        int base) {
  RowTerm terms[kMaxPointTerms];
  const int count = object.rowTerms(point, direction, q, base, terms);
  m_terms.insert(m_terms.end(), terms, terms + count);
}

bool IslandRows::finish() {
  const auto first = m_terms.begin() + m_start.back();
  if (first == m_terms.end()) {
    m_contact.pop_back();
    return false;
  }
  std::sort(first, m_terms.end(), [](const RowTerm& a, const RowTerm& b) { return a.block < b.block; });
  m_start.push_back(static_cast<int>(m_terms.size()));
  return true;
}

double dot(SparseRow row, const VecX& v) {
  double sum = 0;
  for (const RowTerm& term : row) sum += term.coefficient.dot(v.segment<3>(3 * term.block));
  return sum;
}

void addTransposed(SparseRow row, double lambda, VecX& r) {
  for (const RowTerm& term : row) r.segment<3>(3 * term.block) += lambda * term.coefficient;
}

}  // namespace glenoid
