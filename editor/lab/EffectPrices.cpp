// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/EffectPrices.h"

#include <QCoreApplication>
#include <cmath>

#include "editor/core/Sentences.h"
#include "editor/lab/SettingWords.h"
#include "simcore/live/EffectStages.h"
#include "simcore/scene/SceneWords.h"

namespace glenoid {
namespace {

struct EffectPriceTexts {
  Q_DECLARE_TR_FUNCTIONS(glenoid::EffectPrices)
 public:
  static QString stage(Stage stage) {
    switch (stage) {
      case Stage::Assemble: return tr("Forces and stiffness");
      case Stage::Factor: return tr("Factorization");
      case Stage::Unconstrained: return tr("Free motion");
      case Stage::Surfaces: return tr("Surfaces");
      case Stage::Collide: return tr("Search for contacts");
      case Stage::SelfContact: return tr("Search for self-contacts");
      case Stage::Islands: return tr("Rows and islands");
      case Stage::Delassus: return tr("Delassus matrix");
      case Stage::Contact: return tr("Contact solve");
      case Stage::Friction: return tr("Friction solve");
      case Stage::Bursa: return tr("Bursa films");
      case Stage::Dent: return tr("Dents under tools");
      case Stage::Integrate: return tr("Moving on");
      case Stage::Count: break;
    }
    return {};
  }
  static QString wish(const QString& effect, Wish wish) {
    switch (wish) {
      case Wish::On: return tr("Switch on: %1").arg(effect);
      case Wish::Off: return tr("Switch off: %1").arg(effect);
      case Wish::Auto: break;
    }
    return tr("Let the scene decide: %1").arg(effect);
  }
};

Wish Effects::*memberOf(const std::string& effect) {
  for (const auto& word : scene_words::kEffects)
    if (effect == word.word) return word.wish;
  return nullptr;
}

}  // namespace

QString stageWords(Stage stage) { return EffectPriceTexts::stage(stage); }

std::vector<EffectPrice> effectPrices(const Model& model, const Effects& wishes, const StepSeries& series) {
  std::vector<EffectPrice> prices;
  for (const EffectPlan& plan : model.effects) {
    EffectPrice& price = prices.emplace_back();
    price.name = plan.name;
    if (const auto member = memberOf(plan.name)) price.wish = wishes.*member;
    price.on = plan.on;
    price.reason = effectReason(plan.reason);
    price.ms = {std::nan(""), std::nan("")};
    const EffectStages* stages = stagesOfEffect(plan.name);
    if (!plan.on || !stages) continue;
    if (!stages->own.empty()) price.ms = series.stages(stages->own);
    else
      for (int s = 0; s < kStageCount; ++s)
        if (std::string(stages->shared) == stageName(static_cast<Stage>(s))) price.sharedWith = stageWords(static_cast<Stage>(s));
  }
  return prices;
}

QString priceText(const EffectPrice& price) {
  if (!price.on) return EffectPriceTexts::tr("off: nothing");
  if (!price.sharedWith.isEmpty()) return EffectPriceTexts::tr("within “%1”").arg(price.sharedWith);
  if (!std::isfinite(price.ms.p50)) return QStringLiteral("–");
  return EffectPriceTexts::tr("%1, at most %2 in 95 of 100 steps").arg(msText(price.ms.p50), msText(price.ms.p95));
}

bool setEffect(Document& document, const std::string& effect, Wish wish) {
  const auto member = memberOf(effect);
  if (!member || document.scenario().effects.*member == wish) return false;
  ChangeSet changes;
  changes.model = changes.settings = true;
  document.edit(EffectPriceTexts::wish(effectName(effect), wish), changes, [&](Scene& scene) { scene.scenario.effects.*member = wish; });
  return true;
}

}  // namespace glenoid
