// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/Autosave.h"

namespace glenoid {
namespace {

constexpr int kQuietMs = 1000, kLatestMs = 4000;

}  // namespace

Autosave::Autosave(Document& document, const QString& root, QObject* parent)
    : QObject(parent), m_document(document), m_root(root) {
  m_worker.setMaxThreadCount(1);
  m_worker.setExpiryTimeout(-1);
  for (QTimer* timer : {&m_quiet, &m_latest}) {
    timer->setSingleShot(true);
    connect(timer, &QTimer::timeout, this, &Autosave::write);
  }
  m_quiet.setInterval(kQuietMs);
  m_latest.setInterval(kLatestMs);
  begin();
  connect(&document, &Document::changed, this, &Autosave::onChanged);
  // A scene that was recovered lies nowhere: it is kept again at once, without waiting for an edit.
  connect(&document.undoStack(), &QUndoStack::cleanChanged, this, [this](bool clean) {
    if (!clean) touch();
  });
  connect(&document, &Document::savedTo, this, [this] {
    m_quiet.stop();
    m_latest.stop();
    m_changed = false;
    m_worker.start([session = m_session] { session->clear(); });
  });
}

Autosave::~Autosave() {
  m_worker.waitForDone();
  if (m_document.undoStack().isClean()) m_session->clear();
  else m_session->decline();
}

void Autosave::begin() {
  m_session = std::make_shared<AutosaveSession>(m_root);
  m_changed = false;
}

void Autosave::onChanged(const ChangeSet& changes) {
  if (changes.everything) {
    // Another scene: what the last one had unsaved was given up knowingly, and is kept for a while.
    m_quiet.stop();
    m_latest.stop();
    m_worker.start([session = m_session] { session->decline(); });
    begin();
    return;
  }
  touch();
}

void Autosave::touch() {
  m_changed = true;
  m_quiet.start();
  if (!m_latest.isActive()) m_latest.start();
}

void Autosave::write() {
  if (!m_changed) return;
  if (m_writing) {  // tried again when that one is done
    QTimer::singleShot(50, this, &Autosave::write);
    return;
  }
  m_quiet.stop();
  m_latest.stop();
  m_changed = false;
  m_writing = true;
  m_worker.start([this, session = m_session, scene = m_document.scene(), origin = m_document.path()] {
    auto written = session->write(scene, origin);
    QMetaObject::invokeMethod(this, [this, written = std::move(written)] {
      m_writing = false;
      if (written.ok()) {
        m_told = false;
        if (!m_changed) emit safe();
      } else if (!m_told) {
        m_told = true;
        emit failed(written.error());
      }
    }, Qt::QueuedConnection);
  });
}

}  // namespace glenoid
