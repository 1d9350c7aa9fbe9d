// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "app/PublishedTable.h"

namespace glenoid {
namespace {

PartReport reportOf(const PublishedRow& row) {
  PartReport report;
  report.number = row.number;
  report.rigid = row.tetrahedra < 0;
  report.renderTriangles = row.render;
  report.collisionTriangles = row.collision;
  report.tetrahedra = std::max(row.tetrahedra, 0);
  for (const int other : row.couplings) report.couplings.push_back({"", other, "", 4, 1.0});
  return report;
}

TEST(PublishedTable, everyCouplingIsListedByBothParts) {
  int ends = 0;
  for (const PublishedRow& row : publishedTable()) {
    EXPECT_TRUE(std::is_sorted(row.couplings.begin(), row.couplings.end()));
    for (const int other : row.couplings) {
      ++ends;
      const auto& back = publishedTable().at(other - 1).couplings;
      EXPECT_EQ(std::count(row.couplings.begin(), row.couplings.end(), other), std::count(back.begin(), back.end(), row.number))
          << row.number << " and " << other;
    }
  }
  EXPECT_EQ(ends, 2 * 16);
}

TEST(PublishedTable, itsOwnFiguresFit) {
  for (const PublishedRow& row : publishedTable()) EXPECT_TRUE(compare(reportOf(row)).all()) << row.name;
}

TEST(PublishedTable, tolerancesEndWhereTheyShould) {
  const PublishedRow& labrum = publishedTable().at(8);  // 636, 120, 96
  PartReport report = reportOf(labrum);
  report.renderTriangles = 667;
  EXPECT_TRUE(compare(report).render);
  report.renderTriangles = 668;
  EXPECT_FALSE(compare(report).render);
  report.collisionTriangles = 126;
  EXPECT_TRUE(compare(report).collision);
  report.collisionTriangles = 127;
  EXPECT_FALSE(compare(report).collision);
  report.tetrahedra = 110;
  EXPECT_TRUE(compare(report).tetrahedra);
  report.tetrahedra = 111;
  EXPECT_FALSE(compare(report).tetrahedra);
  report = reportOf(publishedTable().at(7));  // 28 collision triangles: 4 is more than 5 %
  report.collisionTriangles = 24;
  EXPECT_TRUE(compare(report).collision);
  report.collisionTriangles = 23;
  EXPECT_FALSE(compare(report).collision);
  report.rigid = false;
  EXPECT_FALSE(compare(report).kind);
  report = reportOf(labrum);
  report.couplings.pop_back();
  EXPECT_FALSE(compare(report).couplings);
}

TEST(PublishedTable, couplingsReadAsInTheTable) {
  EXPECT_EQ(couplingText({3, 4, 5, 6, 6, 7, 9}), "3, 4, 5, 6(x2), 7, 9");
  EXPECT_EQ(couplingText({}), "");
}

}  // namespace
}  // namespace glenoid
