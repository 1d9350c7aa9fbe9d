// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QImage>
#include <QWidget>
#include <functional>
#include <optional>

#include "editor/core/LatestJob.h"
#include "editor/core/tools/Authoring.h"
#include "simcore/author/MakeBody.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;

namespace glenoid {

/// Surfaces to bodies: how the chosen part collides and deforms, what that costs and how near it stays to
/// what is seen, with the three meshes side by side while the sliders move. Nothing changes before Apply,
/// which is one step. Shows and forwards: what is made is in simcore/author/MakeBody.
class BodyPanel : public QWidget {
  Q_OBJECT
 public:
  BodyPanel(Document& document, Authoring& authoring, QWidget* parent = nullptr);

  /// The direction from which the pictures are taken; asked for each time.
  void setViewSource(std::function<View()> source) { m_viewSource = std::move(source); }
  /// The view has moved: new pictures of the same meshes.
  void viewMoved();

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeControls();
  QWidget* makePictures();
  void retranslate();
  void refreshPart();  ///< takes the part anew where its body has changed
  void takePart();     ///< the part's values into the fields
  void refreshMaterials();
  void ask();  ///< a new body for the fields as they stand
  void askPictures();
  void showFigures();
  void apply();
  void mark();  ///< the selected triangles matter
  BodyWish wish() const;
  const Part* part() const;

  Document& m_document;
  Authoring& m_authoring;
  std::function<View()> m_viewSource;
  std::vector<Material> m_library;
  LatestJob m_bodyJob, m_pictureJob;
  bool m_showing = false;
  Part m_taken;                             ///< as the fields have it, without the rest
  std::shared_ptr<const TriMesh> m_visual;  ///< that the fields and the marks belong to
  std::vector<int> m_important;             ///< triangles of the visual surface
  std::optional<BodyWish> m_madeWish;       ///< what m_made is of
  std::optional<Body> m_made;
  std::optional<Error> m_error;
  View m_picturedView;

  std::vector<QGroupBox*> m_groups;
  std::vector<QLabel*> m_labels, m_pictures, m_captions;
  QLabel *m_name, *m_figures, *m_matter, *m_outcome;
  QComboBox *m_kind, *m_material;
  QSlider *m_triangleSlider, *m_cellSlider;
  QSpinBox *m_triangles, *m_factor;
  QDoubleSpinBox* m_cell;
  QCheckBox* m_ownAxes;
  QPushButton *m_markButton, *m_unmark, *m_apply, *m_revert, *m_ownMaterial;
};

}  // namespace glenoid
