#include "ribbon/study/accuracies.h"

namespace ribbon::study {

void Accuracies::set(box2d::Coupling& coupling, const std::optional<Accuracy>& accuracy,
                     const std::map<box2d::CordId, Accuracy>& by_cord) {
  for (const box2d::CordId c : coupling.cords()) {
    if (coupling.cord(c).solver() != box2d::Solver::direct) continue;
    Cord& cord = coupling.cord(c).direct();
    const auto own = own_.try_emplace(c, cord.def().accuracy).first;
    const auto listed = by_cord.find(c);
    const Accuracy& wanted = listed != by_cord.end() ? listed->second : accuracy ? *accuracy : own->second;
    if (!(cord.def().accuracy == wanted)) cord.set_accuracy(wanted);
  }
}

}  // namespace ribbon::study
