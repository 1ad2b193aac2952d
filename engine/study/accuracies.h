#pragma once

#include <map>
#include <optional>

#include "ribbon/box2d/coupling.h"
#include "ribbon/cord_def.h"

namespace ribbon::study {

/// Gives all cords of the direct solver an accuracy, and their own back.
class Accuracies {
 public:
  /// Sets the accuracy of all cords; none: each cord's own, which is the one that it had when it was first seen here.
  /// Those in `by_cord` have that one instead. Call it before each tick, for cords that are new.
  void set(box2d::Coupling& coupling, const std::optional<Accuracy>& accuracy,
           const std::map<box2d::CordId, Accuracy>& by_cord = {});

 private:
  std::map<box2d::CordId, Accuracy> own_;  // of the cords that were seen
};

}  // namespace ribbon::study
