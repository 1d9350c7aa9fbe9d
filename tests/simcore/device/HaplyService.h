// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <deque>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "simcore/base/Math.h"

struct lws;
struct lws_context;

namespace glenoid::test {

/// What we know of the Inverse Service's manners, as a server on this machine: an inventory on connecting, then one state for each message
/// received and none without; events in between if asked; a force taken in one dialect only.
class HaplyService {
 public:
  explicit HaplyService(const char* dialect = "values", int port = 0);
  ~HaplyService();
  int port() const { return m_port; }

  std::atomic<int> lagMs{0};            ///< before each answer
  std::atomic<bool> events{false};      ///< one before each answer
  std::atomic<bool> plugged{true};      ///< else states list no Inverse3
  std::atomic<int> broken{0};           ///< 1: places are null; 2: what is sent is no JSON
  std::atomic<long> received{0}, answered{0};
  std::atomic<int> outstandingMost{0};  ///< most messages unanswered at once
  std::atomic<double> x{0};             ///< of the cursor, m
  std::atomic<double> force[3]{};       ///< last taken, N
  std::atomic<long> sessions{0};        ///< messages that began one

 private:
  friend struct HaplyServiceCalls;
  struct Waiting {
    std::int64_t due;
    std::string text;
  };
  void run();
  void take(const std::string& text);
  std::string state(bool inventory) const;

  std::string m_dialect;
  int m_port = 0;
  lws_context* m_context = nullptr;
  lws* m_client = nullptr;
  std::deque<Waiting> m_out;
  std::string m_text;
  std::vector<unsigned char> m_bytes;
  std::atomic<bool> m_quit{false};
  std::thread m_thread;
};

}  // namespace glenoid::test
