#include "tests/flight/shrink.h"

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include "tests/flight/edits.h"
#include "tests/flight/replay.h"

namespace flight {
namespace {

using engine::SolverStep;

class Shrinker {
 public:
  Shrinker(SolverStep step, const StillFails& still_fails, const ShowProgress& show_progress)
      : step_(std::move(step)), still_fails_(still_fails), show_progress_(show_progress) {}

  SolverStep run() {
    do {
      changed_ = false;
      shrink_list([](SolverStep & step) -> auto& { return step.cords; });
      for (std::size_t k = 0; k < step_.cords.size(); ++k) shrink_cord(k);
      attempt_edits(
          step_edits(), [](SolverStep & step) -> auto& { return step; });
      for (std::size_t b = 0; b < step_.bodies.size(); ++b) {
        attempt_edits(
            body_edits(), [b](SolverStep & step) -> auto& { return step.bodies[b]; });
      }
    } while (changed_);
    return std::move(step_);
  }

 private:
  bool attempt(SolverStep candidate) {
    ++tried_;
    bool fails = false;
    try {
      fails = still_fails_(candidate);
    } catch (const std::exception&) {
      fails = false;  // the step is invalid, which is another failure
    }
    if (fails) {
      step_ = std::move(candidate);
      changed_ = true;
    }
    if (show_progress_) show_progress_(step_, tried_);
    return fails;
  }

  /// Removes halves, quarters, … of a list, and finally single entries.
  template <typename ListOf>
  void shrink_list(ListOf list_of) {
    for (std::size_t many = list_of(step_).size(); many > 0; many /= 2) {
      for (std::size_t first = 0; first < list_of(step_).size();) {
        SolverStep candidate = step_;
        auto& list = list_of(candidate);
        const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
        list.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(many, list.size() - first)));
        if (!attempt(std::move(candidate))) first += many;
      }
    }
  }

  template <typename Edits, typename PartOf>
  void attempt_edits(const Edits& edits, PartOf part_of) {
    for (const auto& edit : edits) {
      SolverStep candidate = step_;
      if (edit(part_of(candidate))) attempt(std::move(candidate));
    }
  }

  void shrink_cord(std::size_t k) {
    shrink_list([k](SolverStep & step) -> auto& { return step.cords[k].circles; });
    shrink_list([k](SolverStep & step) -> auto& { return step.cords[k].segments; });
    shrink_list([k](SolverStep & step) -> auto& { return step.cords[k].grips; });
    shrink_list([k](SolverStep & step) -> auto& { return step.cords[k].supports; });
    attempt_edits(
        cord_edits(), [k](SolverStep & step) -> auto& { return step.cords[k]; });
    cut_ends(k);
  }

  void cut_ends(std::size_t k) {
    for (int many = step_.cords[k].def.points / 2; many > 0; many /= 2) {
      for (const bool at_front : {false, true}) {
        bool is_shorter = true;
        while (is_shorter) {
          SolverStep candidate = step_;
          is_shorter = cut_rope(candidate.cords[k], many, at_front) && attempt(std::move(candidate));
        }
      }
    }
  }

  SolverStep step_;
  const StillFails& still_fails_;
  const ShowProgress& show_progress_;
  int tried_ = 0;
  bool changed_ = false;
};

}  // namespace

std::size_t size_of(const SolverStep& step) {
  std::size_t sum = step.bodies.size();
  for (const SolverStep::Cord& cord : step.cords) {
    sum += 1 + cord.state.positions.size() + cord.circles.size() + cord.segments.size() + cord.grips.size() +
           cord.axles.size() + cord.supports.size();
  }
  return sum;
}

SolverStep shrink(const SolverStep& step, const StillFails& still_fails, const ShowProgress& show_progress) {
  SolverStep smallest = Shrinker(step, still_fails, show_progress).run();
  Replay replay(smallest);
  replay.run();
  smallest.outcome = {step.outcome.why, replay.total().work, replay.total().unconverged, replay.hash()};
  return smallest;
}

}  // namespace flight
