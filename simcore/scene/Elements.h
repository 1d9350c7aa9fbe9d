// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// Elements of a soft part: five tetrahedra in each cell, as published, or one element of eight nodes over the tissue in it
/// (fem/CorotCell.h), which bends where tissue is thinner than its cell. The profile `paper` has tetrahedra whatever is said.
enum class Elements { Tetrahedra, Cells };

}  // namespace glenoid
