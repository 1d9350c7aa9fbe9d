// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "editor/core/AutosaveStore.h"

namespace glenoid {

/// Keeps safety copies of the document outside of its project, on a worker: a second after a batch of edits has ended, and
/// while edits go on at the latest four seconds after the first that is not safe yet. So nothing older than ten seconds
/// is lost when the program is killed, as long as one copy takes less than five. GUI thread only.
class Autosave : public QObject {
  Q_OBJECT
 public:
  /// `document` must outlive this.
  Autosave(Document& document, const QString& root, QObject* parent = nullptr);
  /// Waits for the worker. A scene without unsaved changes leaves nothing; another stays for File > Recover.
  ~Autosave() override;

  const QString& root() const { return m_root; }
  /// Every edit so far is in a copy, or on its own place.
  bool isSafe() const { return !m_changed && !m_writing; }

 signals:
  void safe();
  void failed(const glenoid::Error& error);  ///< told once until a copy succeeds

 private:
  void onChanged(const ChangeSet& changes);
  void touch();
  void write();
  void begin();

  Document& m_document;
  QString m_root;
  std::shared_ptr<AutosaveSession> m_session;  ///< the worker's, except between jobs
  bool m_changed = false, m_writing = false, m_told = false;
  QTimer m_quiet, m_latest;
  QThreadPool m_worker;
};

}  // namespace glenoid
