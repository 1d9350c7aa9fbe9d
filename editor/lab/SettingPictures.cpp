// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/SettingPictures.h"

#include <signal.h>
#include <sys/prctl.h>

#include "editor/core/Sentences.h"
#include "editor/lab/StudiedScene.h"

namespace glenoid {
namespace {

constexpr const char* kCamera = "lab-camera";

Scene seenFrom(Scene scene, const View& view) {
  Camera camera;
  camera.id = camera.name = kCamera;
  camera.eye_W = view.eye_W;
  camera.target_W = view.target_W;
  camera.up_W = view.up_W;
  camera.fieldOfView = view.fieldOfView;
  std::erase_if(scene.scenario.cameras, [](const Camera& one) { return one.id == kCamera; });
  scene.scenario.cameras.push_back(camera);
  return scene;
}

}  // namespace

SettingPictures::SettingPictures(QString program, QObject* parent) : QObject(parent), m_program(std::move(program)) {
  m_process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
  m_process.setStandardOutputFile(QProcess::nullDevice());
  connect(&m_process, &QProcess::finished, this, [this](int status, QProcess::ExitStatus how) {
    if (!m_busy) return;
    QImage image(m_scenarios[static_cast<int>(m_images.size())] + QStringLiteral(".png"));
    if (status != 0 || how != QProcess::NormalExit || image.isNull()) {
      m_busy = false;
      const QString said = QString::fromUtf8(m_process.readAllStandardError()).trimmed().section(u'\n', -1);
      emit failed(said.isEmpty() ? tr("The picture of a setting could not be drawn.") : said);
      return;
    }
    m_images.push_back(std::move(image));
    next();
  });
  connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart || !m_busy) return;
    m_busy = false;
    emit failed(tr("The picture of a setting could not be drawn: %1 cannot be run.").arg(m_program));
  });
}

SettingPictures::~SettingPictures() {
  m_process.disconnect(this);
  stop();
}

void SettingPictures::stop() {
  m_busy = false;
  if (m_process.state() == QProcess::NotRunning) return;
  m_process.kill();
  m_process.waitForFinished(3000);
}

void SettingPictures::draw(const Scene& before, const Scene& after, const View& view, double seconds, QSize size) {
  stop();
  m_folder = std::make_unique<QTemporaryDir>();
  m_scenarios.clear();
  m_images.clear();
  m_seconds = seconds;
  m_size = size;
  for (const auto& [scene, stem] : {std::pair(&before, "before"), std::pair(&after, "after")}) {
    const Result<std::string> saved = saveStudied(seenFrom(*scene, view), m_folder->path().toStdString(), stem);
    if (!saved) {
      emit failed(sentenceOf(saved.error()));
      return;
    }
    m_scenarios << QString::fromStdString(*saved);
  }
  m_busy = true;
  next();
}

void SettingPictures::next() {
  const int k = static_cast<int>(m_images.size());
  if (k == m_scenarios.size()) {
    m_busy = false;
    emit drawn(m_images[0], m_images[1]);
    return;
  }
  m_process.start(m_program, {QStringLiteral("render"), m_scenarios[k], QStringLiteral("--out"), m_scenarios[k] + QStringLiteral(".png"), QStringLiteral("--camera"),
                              QLatin1String(kCamera), QStringLiteral("--size"), QStringLiteral("%1x%2").arg(m_size.width()).arg(m_size.height()),
                              QStringLiteral("--time"), QString::number(m_seconds, 'g', 9)},
                  QIODevice::ReadOnly);
}

}  // namespace glenoid
