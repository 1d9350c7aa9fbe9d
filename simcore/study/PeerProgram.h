// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <iosfwd>

#include "simcore/study/PeerStudy.h"

namespace glenoid::peers {

/// The scene as plain numbers for a program that knows nothing of us, one after another, words as headings:
///   dt D steps N radius R gravity GX GY GZ ridge HX HY HZ bones HX HY HZ CX CY CZ FX FY FZ
///   block NAME young E poisson NU nodes n (x y z mass)… tets n (a b c d)… faces n (a b c)… fixed n i… moving n i…
///   path (ball x y z, ridge x y z)… for each step, then the word end.
/// m, kg, s, Pa; HX… half extents, C the moving bone's centre, F the fixed one's.
void writeScene(Stiffness stiffness, double dt, double seconds, std::ostream& out);

/// Runs `program` in its own process with the scene on its standard input and reads the JSON line that it prints.
/// `limit`: seconds of computing after which it must stop by itself. Fails with FileMissing where there is no such
/// program and Unusable where it prints no row. Not for a thread that is measured.
Result<Row> runProgram(const std::string& program, Stiffness stiffness, double dt, double seconds, double limit);

}  // namespace glenoid::peers
