#include "ribbon/collision/stored_touches.h"

#include "ribbon/linear/index.h"

namespace ribbon {

void StoredTouches::list(const CordParts& cord) {
  touches_ = cord.state.touches;
  first_.assign(2 * cord.outline.size(), -1);
  next_.reserve(cord.state.touches.capacity());
  next_.resize(touches_.size());
  for (std::size_t k = touches_.size(); k-- > 0;) {
    const auto feature = at(touches_[k].feature);
    if (feature >= first_.size()) continue;
    next_[k] = first_[feature];
    first_[feature] = static_cast<int>(k);
  }
}

const Touch* StoredTouches::find(const Touch& place) const {
  for (int k = first_[at(place.feature)]; k >= 0; k = next_[at(k)]) {
    const Touch& touch = touches_[at(k)];
    if (touch.other == place.other && touch.other_feature == place.other_feature) return &touch;
  }
  return nullptr;
}

}  // namespace ribbon
