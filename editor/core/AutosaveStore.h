// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QDateTime>
#include <QString>
#include <memory>
#include <vector>

#include "editor/core/Document.h"

class QLockFile;

namespace glenoid {

/// The safety copies that running programs keep of unsaved scenes, in one folder of the program's own (`root`):
///
///     ROOT/SESSION/lock          held while its program runs
///     ROOT/SESSION/blobs/        meshes by content, each written once
///     ROOT/SESSION/g000012/      one generation: joint.json, scenario.json, about.json, meshes/ (links to blobs)
///     ROOT/SESSION/declined      its owner was asked and did not want it, or closed the scene without saving
///
/// A generation has its name only when it is whole. A project's own files are never touched. Functions may run on any
/// thread; one session has one writer.

/// One generation on disk.
struct Generation {
  QString folder;
  QString name;      ///< of the scene, for people
  QString origin;    ///< path it was opened from or last saved to; may be empty
  QDateTime saved;   ///< UTC
};

/// What one scene of one program left, newest generation first; never empty.
struct AbandonedSession {
  QString folder;
  bool declined = false;
  std::vector<Generation> generations;
};

/// A session being written. Its folder is made with the first generation.
class AutosaveSession {
 public:
  /// Where sessions lie when nobody says otherwise.
  static QString defaultRoot();

  explicit AutosaveSession(const QString& root);
  ~AutosaveSession();  ///< lets the lock go; the files stay

  /// Writes one generation and drops those that are no longer needed. Fails with FileUnwritable.
  Result<Done> write(const Scene& scene, const QString& origin);
  /// The scene is safe elsewhere: all generations go.
  void clear();
  /// Its scene was closed without saving: it is kept for File > Recover, and not offered by itself.
  void decline();
  const QString& folder() const { return m_folder; }

 private:
  bool prepare();

  QString m_root, m_folder;
  std::unique_ptr<QLockFile> m_lock;
  int m_next = 1;
  std::shared_ptr<const Recording> m_input;  ///< last written as a blob
  int m_inputs = 0;
};

/// Sessions whose program is gone and that hold something, newest first. Those older than 30 days, and more than the
/// newest 20, are removed.
std::vector<AbandonedSession> abandonedSessions(const QString& root);
/// Reads a generation back. Fails as loadDraft does.
Result<Scene> loadGeneration(const QString& folder);
void declineSession(const QString& folder);
void removeSession(const QString& folder);

/// Which generations go when the newest is kept: of `saved` (newest first) the four newest stay, and of the older ones
/// those that lie at least a minute apart, four at most. Answers indices, ascending.
std::vector<int> generationsToDrop(const std::vector<QDateTime>& saved);

}  // namespace glenoid
