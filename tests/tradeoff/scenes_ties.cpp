#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/net.h"
#include "tests/tradeoff/measure.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

constexpr int net_settling_ticks = 120;
constexpr int caught_ticks = 120;    // in which the ball falls into the net and lies there
constexpr double ball_mass = 100.0;  // kg

/// The figures of a run: the largest strain of a link, and substeps without convergence.
std::vector<double> figures_of(const ribbon::Accuracy& accuracy, bool catches) {
  test_support::Net net(accuracy);
  for (int k = 0; k < net_settling_ticks; ++k) net.tick();
  if (catches) net.drop_ball(ball_mass);
  double strain = 0.0;
  int unconverged = 0;
  for (int k = 0; k < caught_ticks; ++k) {
    net.tick();
    strain = std::max(strain, net.strain());
    unconverged += net.coupling.last_step().report().unconverged;
  }
  return {100.0 * strain, static_cast<double>(unconverged)};
}

Variant net(const std::string& setting, const ribbon::Accuracy& accuracy, bool catches) {
  const auto scene = std::make_shared<std::unique_ptr<test_support::Net>>();
  const auto renew = [=] {
    *scene = std::make_unique<test_support::Net>(accuracy);
    for (int k = 0; k < net_settling_ticks; ++k) (*scene)->tick();
    if (catches) (*scene)->drop_ball(ball_mass);
  };
  return {"coupling",
          setting,
          test_support::Net::cords * test_support::Net::cords * 2,
          renew,
          [scene] { (*scene)->tick_cords(); },
          [=] { return figures_of(accuracy, catches); },
          [scene] { (*scene)->tick_world(); },
          catches ? "a ball of 100 kg" : "hanging",
          [scene] { return (*scene)->coupling.last_step().report().work; }};
}

std::vector<Variant> nets() {
  std::vector<Variant> list;
  for (const bool catches : {false, true}) {
    list.push_back(net("fast", ribbon::Accuracy::fast(), catches));
    list.push_back(net("balanced", ribbon::Accuracy::balanced(), catches));
  }
  return list;
}

}  // namespace

std::vector<Scene> tie_scenes() {
  return {{"net",
           "a net of 20 × 20 cords tied at 400 places: it hangs from two corners, and a ball falls into it from 1 m",
           caught_ticks,
           nets,
           {cords_us(), p99_us(), cords_max_us(), figure("strain_percent", 0), figure("unconverged", 1)}}};
}

}  // namespace tradeoff
