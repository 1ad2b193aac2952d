#include "game/simulation/meter.h"

#include <gtest/gtest.h>

#include "game/simulation/buttons.h"

namespace game {
namespace {

TEST(Meter, ShowsTheMedianAndTheMaximumOfTheLastSecond) {
  const Level level = load_level("first_swing");
  Simulation simulation(level);
  Meter meter;
  EXPECT_EQ(meter.median_us(), 0.0);
  EXPECT_EQ(meter.worst_us(), 0.0);
  simulation.tick({});
  meter.add(simulation, 900'000);
  for (int k = 0; k < 60; ++k) {
    if (k == 0) {
      EXPECT_EQ(meter.worst_us(), 900.0);
    }
    meter.add(simulation, 1000 * (k % 2 == 0 ? 10 : 30));
  }
  EXPECT_EQ(meter.worst_us(), 30.0);  // the first one is more than a second old
  EXPECT_EQ(meter.median_us(), 30.0);
  meter.add(simulation, 5'000);
  meter.add(simulation, 5'000);
  EXPECT_EQ(meter.median_us(), 10.0);
}

TEST(Meter, ShowsTheMaximumStretchOfACordSinceTheRestart) {
  const Level level = load_level("first_swing");
  Simulation simulation(level);
  Meter meter;
  double most = 0.0;
  for (int k = 0; k < 120; ++k) {
    simulation.tick({});
    meter.add(simulation, 0);
    const auto& cord = simulation.scene().coupling().cord(0).direct();
    double along = 0.0;
    for (std::size_t p = 1; p < cord.positions().size(); ++p) {
      along += length(cord.positions()[p] - cord.positions()[p - 1]);
    }
    most = std::max(most, along / cord.def().length - 1.0);
  }
  EXPECT_EQ(meter.peak_stretch(0), most);
  engine::TickInput restart;
  restart.buttons = button_restart;
  simulation.tick(restart);
  meter.add(simulation, 0);
  EXPECT_LE(meter.peak_stretch(0), most);
  EXPECT_LE(meter.peak_stretch(0), 1e-4);
  EXPECT_EQ(meter.peak_stretch(99), 0.0);
}

TEST(Meter, EstimatesErrorsTenTimesASecondAndExcludesThoseTicksFromTimes) {
  const Level level = load_level("first_swing");
  Simulation simulation(level);
  Simulation alone(level);
  for (int k = 0; k < 180; ++k) {  // the balls roll into the hammock
    simulation.tick({});
    alone.tick({});
  }
  Meter meter;
  double sum = 0.0;
  int estimates = 0;
  for (int k = 0; k < 60; ++k) {
    const bool wanted = meter.wants_estimate();
    simulation.scene().coupling().estimate_errors(wanted);
    simulation.tick({});
    alone.tick({});
    meter.add(simulation, wanted ? 900'000 : 10'000);
    if (wanted) sum += simulation.scene().coupling().cord(3).error();
    estimates += wanted ? 1 : 0;
  }
  EXPECT_EQ(estimates, 10);
  EXPECT_GT(sum, 1e-6);  // the hammock swings
  EXPECT_NEAR(meter.error_per_second(3), 6.0 * sum, 1e-15);
  EXPECT_EQ(meter.error_per_second(99), 0.0);
  EXPECT_EQ(meter.worst_us(), 10.0);
  EXPECT_TRUE(simulation.hash() == alone.hash());
}

}  // namespace
}  // namespace game
