// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>

#include "editor/core/Document.h"
#include "simcore/study/accuracy/AccuracySetting.h"

namespace glenoid {

/// The scene that a study is of, with the settings that such a study may sweep. A constant value.
class StudiedScene {
 public:
  /// Compiles it, so on a worker. Fails as compileModel does.
  static Result<std::shared_ptr<const StudiedScene>> make(Scene scene);

  const Scene& scene() const { return m_scene; }
  /// The studied scene with one of its settings, by id; other cells take a while. Fails with UnknownId, and as refineCells does.
  Result<Scene> with(const std::string& setting) const;

 private:
  Scene m_scene;
  std::vector<AccuracySetting> m_settings;
};

/// A scene as files of a folder, for a program of its own: STEM.scenario.json, STEM.joint, and STEM.recording where it has an input that does
/// not ship with the program. Answers the scenario's path. Fails as saving does.
Result<std::string> saveStudied(const Scene& scene, const std::string& folder, const std::string& stem);

/// What came of applySetting: a sentence that says what changed, or why nothing may; empty where nothing would.
struct SettingApplied {
  bool refused = false;
  QString sentence;
};

/// Makes a document's scene run with what `made` (StudiedScene::with) sets, and keeps what else was edited since: one undo step, called
/// by `words`. Refused where cells or surfaces would change of a joint that is neither the studied one nor `lastMade`, which an earlier
/// setting put there.
SettingApplied applySetting(Document& document, const Scene& studied, const Scene& made, const std::optional<Joint>& lastMade, const QString& words);

}  // namespace glenoid
