#include "game/session.h"

#include <utility>

namespace game {
namespace {

constexpr std::int64_t shown_for_ns = 6'000'000'000;

}  // namespace

void Notice::show(std::string sentence) {
  text_ = std::move(sentence);
  left_ns_ = shown_for_ns;
}

void Notice::pass(std::int64_t nanoseconds) {
  left_ns_ -= nanoseconds;
  if (left_ns_ <= 0) text_.clear();
}

}  // namespace game
