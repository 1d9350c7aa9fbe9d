// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/scene/UnusedSettings.h"

namespace glenoid {

enum class NoticeKind {
  UnusedSetting,  ///< `unused` says which; subject: its name
  EffectIdle,     ///< subject: an effect that was switched on and finds nothing to act on
  TooDeep,        ///< subject, other: two objects, or one twice, once a pair; figure: depth, limit: the most that is let pass, m; the run fails
  TornAway,       ///< subject: a part; figure: how far its middle went, limit: its size, m
  Overstretched,  ///< subject: a soft part; figure: longest edge of its tetrahedra over its length at rest, limit: what tissue stands
  InsideOut,      ///< subject: a soft part; figure: most of its elements turned inside out at once, limit: how many it has
  Pressed,        ///< likewise, pressed beyond three Young's moduli, which their law does not hold (fem/StretchLaw.h)
  MarkMissed,     ///< subject: a mark; other: its tool and part, as far as it names them; figure: Δt, s
  PathCut,        ///< subject: a tool; figure: how far the path of its hand in steps of Δt lies from the recorded one, limit: what counts
                  ///< as contact, m
  Bounded,        ///< contacts of some steps cost more than a step may (step/ContactBudget.h); figure: of how many, limit: of all; time and
                  ///< step: the first
  TimeUp,         ///< the run was stopped; subject, other: the two objects with most contacts, if any; figure: rows of all contacts,
                  ///< limit: what the run was given, s of the clock
};
inline constexpr int kNoticeKindCount = static_cast<int>(NoticeKind::TimeUp) + 1;

/// English word of a kind, for reports and tests: "unused-setting", …
const char* noticeName(NoticeKind kind);

/// Whether what the run says after that is not to be trusted: too deep, torn away, overstretched, inside out.
constexpr bool isGrave(NoticeKind kind) {
  return kind == NoticeKind::TooDeep || kind == NoticeKind::TornAway || kind == NoticeKind::Overstretched ||
         kind == NoticeKind::InsideOut;
}

/// Something that whoever reads the figures of a run should be told first. The sentence is made at the top
/// (editor/core/NoticeSentences).
struct Notice {
  NoticeKind kind = NoticeKind::UnusedSetting;
  std::string subject, other;  ///< ids or names, see above
  double figure = 0, limit = 0;
  double time = 0;             ///< s, of the step's end at which it was first so, or worst for TooDeep, InsideOut and Pressed; 0: of the whole run
  long step = 0;               ///< likewise, counted from 1
  UnusedSetting unused;
};

}  // namespace glenoid
