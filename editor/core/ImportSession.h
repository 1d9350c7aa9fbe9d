// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <QStringList>
#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

#include "editor/core/Document.h"
#include "simcore/import/ImportSurfaces.h"
#include "simcore/repair/Diagnose.h"

namespace glenoid {

/// Surfaces on their way from files into the document: reads each file on a worker (which starts the reader's process),
/// judges every surface in it, keeps what the author decides about each and makes the result anew when a decision
/// changes, and at the end adds all that are wanted as one undo step. Nothing reaches the document before. GUI thread
/// only; work that is under way when the session ends is told to stop and its answer is thrown away.
class ImportSession : public QObject {
  Q_OBJECT
 public:
  enum class State { Reading, Working, Ready, Failed };

  /// One surface; while its file is being read, or when that failed, the file.
  struct Row {
    State state = State::Reading;
    QString file;      ///< path
    QString problem;   ///< a sentence, where the file or the repair failed
    QString format;
    std::vector<NoteCount> notes;          ///< of the file
    std::optional<double> namedUnit;       ///< metres, as the file says
    UnitGuess guess;                       ///< by what the surface looks like
    std::shared_ptr<const TriMesh> mesh;   ///< in the file's unit and axes
    SurfaceDiagnosis found;                ///< of that mesh, in the chosen unit

    // Decisions.
    bool wanted = true;
    QString name;                          ///< of the part it becomes
    double metres = 1e-3;                  ///< per unit
    AxisMap axes;
    std::set<FindingKind> repairs;

    // What comes of them.
    std::shared_ptr<const TriMesh> result; ///< W, m, without the session's shift; null until made
    SurfaceDiagnosis after;                ///< of the result
    std::vector<RepairChange> changes;
    long generation = 0;
  };

  explicit ImportSession(ImportLimits limits = {}, QObject* parent = nullptr);
  ~ImportSession() override;

  void add(const QStringList& files);
  const std::vector<Row>& rows() const { return m_rows; }
  bool busy() const;
  /// Stops reading: rows whose file was not read yet become failed ones that say so.
  void cancel();

  void setWanted(int row, bool wanted);
  void setName(int row, const QString& name);
  void setUnit(int row, double metres);
  void setAxes(int row, const AxisMap& axes);
  void setRepair(int row, FindingKind kind, bool on);
  double thinLimit() const { return m_thinLimit; }
  void setThinLimit(double metres);  ///< judges all anew
  const Vec3& shift_W() const { return m_shift_W; }
  void setShift(const Vec3& shift_W);
  /// Shift that brings the middle of all that is wanted to the origin.
  Vec3 centringShift_W() const;

  /// Rows that would be added now.
  int ready() const;
  /// Adds them as rigid, fixed parts of bone in one undo step; answers their ids. Nothing without any.
  std::vector<std::string> apply(Document& document) const;

 signals:
  void rowsChanged();          ///< another number of rows
  void rowChanged(int row);
  void busyChanged();

 private:
  struct Mailbox {
    std::mutex mutex;
    ImportSession* session = nullptr;
    std::atomic<bool> stop{false};
  };
  template <class Work>
  void onWorker(Work work);
  void read(const QString& file, long key);
  void took(long key, Result<ImportedFile> file, std::vector<SurfaceDiagnosis> found);
  void remake(int row, bool judgeAgain);
  int rowOf(long key) const;

  ImportLimits m_limits;
  std::shared_ptr<Mailbox> m_mailbox;
  std::vector<Row> m_rows;
  std::vector<long> m_keys;  ///< of each row, never used twice
  long m_lastKey = 0;
  int m_working = 0;
  double m_thinLimit = 1e-3;
  Vec3 m_shift_W = Vec3::Zero();
};

}  // namespace glenoid
