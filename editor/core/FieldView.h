// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <array>
#include <optional>

#include "editor/core/LatestJob.h"
#include "editor/core/PlayLink.h"
#include "editor/render/SceneRenderer.h"
#include "simcore/reading/FieldRange.h"

namespace glenoid {

/// What the view shows of what parts bear: which quantity, on which scale, and what it is at a place. Like DisplayState it
/// belongs to the window and not to the document. While nothing is chosen it costs nothing: the run copies no rotations, no
/// weights are kept and nothing is computed. Once chosen, weights are found on a worker for each new model (the view shows
/// no colours until then), and values for each snapshot that is drawn, and only for those. GUI thread only.
class FieldView : public QObject {
  Q_OBJECT
 public:
  /// `link` must outlive it.
  explicit FieldView(PlayLink& link, QObject* parent = nullptr);

  std::optional<Quantity> quantity() const { return m_quantity; }
  /// Nothing: parts look as they are. Another quantity goes back to the automatic scale.
  void show(std::optional<Quantity> quantity);
  /// The next in the order of kQuantities, after the last nothing.
  void showNext();

  bool isAutomatic() const { return !m_byHand; }
  /// The scale as it is shown, SI; of nothing chosen 0…1.
  const FieldRange& range() const { return m_range; }
  /// A scale that stays as it is. Ends the wrong way round or equal are moved apart.
  void setRange(const FieldRange& range);
  void setAutomatic();

  /// For the renderer, the values of the link's snapshot; `layers` says what is hidden. Nothing while there are none.
  std::optional<FieldLook> look(const Layers& layers);

  /// A place on a part's visual surface that goes with it.
  struct Place {
    std::shared_ptr<const Model> model;
    int object = -1;
    std::array<int, 3> vertices{};
    std::array<double, 3> weights{};
  };
  /// Nothing where no quantity is chosen or the hit is on no visual surface of the snapshot's model.
  std::optional<Place> placeOf(const PickHit& hit) const;
  /// The value there now; nothing where there is none.
  std::optional<double> valueAt(const Place& place) const;
  /// The same as a sentence; empty when the place belongs to another model or nothing is chosen.
  QString readingAt(const Place& place) const;

 signals:
  void changed();       ///< what look() gives may be another
  void rangeChanged();  ///< quantity, scale or whose it is

 private:
  void onSnapshot();
  void prepare();
  void compute();
  void setShownRange(const FieldRange& range);

  PlayLink& m_link;
  LatestJob m_worker;
  std::optional<Quantity> m_quantity;
  bool m_byHand = false;
  FieldRange m_range;
  SteadyRange m_steady;
  std::shared_ptr<const Model> m_asked;        ///< for which weights are being found
  std::shared_ptr<const SurfaceField> m_field;
  std::shared_ptr<const SurfaceValues> m_values;  ///< of m_valuesModel, null: none
  std::shared_ptr<const Model> m_valuesModel;
  bool m_stale = true;                         ///< the snapshot is newer than the values
};

}  // namespace glenoid
