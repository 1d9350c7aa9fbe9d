// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

namespace glenoid {

/// Hands the newest value from one writing thread to one reading thread; neither ever waits, values that came
/// too fast are lost. Wrong for events that all count: those go through a queue.
/// Three slots: one belongs to the writer, one to the reader, the middle one changes hands by an atomic
/// exchange. Slots are reused, so a T that keeps its capacity when assigned to allocates nothing after warm-up.
template <class T>
class TripleBuffer {
 public:
  /// Writer only: the slot to fill. It holds some older value, not the last one.
  T& back() { return m_slots[m_back]; }
  /// Writer only: the filled slot becomes the newest value.
  void publish() { m_back = m_middle.exchange(m_back | kFresh, std::memory_order_acq_rel) & kIndex; }
  /// Reader only: makes the newest value the front; false when there is none since the last call.
  bool take() {
    if (!fresh()) return false;
    m_front = m_middle.exchange(m_front, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  /// Any thread: whether take() would find something.
  bool fresh() const { return (m_middle.load(std::memory_order_relaxed) & kFresh) != 0; }
  /// Reader only: the value of the last take().
  const T& front() const { return m_slots[m_front]; }

 private:
  static constexpr std::uint8_t kFresh = 4, kIndex = 3;
  std::array<T, 3> m_slots{};
  std::atomic<std::uint8_t> m_middle{1};
  std::uint8_t m_back = 0;   // the writer's
  std::uint8_t m_front = 2;  // the reader's
};

}  // namespace glenoid
