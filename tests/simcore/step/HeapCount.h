// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Counts every way to the heap of the whole program, malloc and what stands on it included: Eigen's vectors
/// do not go through operator new. A program that links HeapCount.cpp has its malloc replaced.
namespace glenoid::test {

/// Allocations since the program began, of all threads. Always 0 under a sanitizer, which needs malloc for
/// itself.
long heapAllocations();

/// Whether heapAllocations counts in this build.
bool heapIsCounted();

/// Bytes in use on the heap, as the C library knows them.
long heapBytesInUse();

}  // namespace glenoid::test
