#include "ribbon/contact/contact_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ribbon/contact/contact_scene.h"
#include "tests/support/dice.h"

namespace ribbon {
namespace {

using test_support::Dice;

/// Discs and segments at random places in a square of 10 m, every disc paired with every segment.
struct Scene {
  static constexpr int discs = 20;
  static constexpr int segments = 20;
  ContactScene contacts;
  std::vector<Vec2> x;

  explicit Scene(Dice& dice) {
    for (int k = 0; k < discs + segments; ++k) x.push_back({dice(-5.0, 5.0), dice(-5.0, 5.0)});
    for (int k = 0; k < segments; ++k) x.push_back(x[at(discs + k)] + Vec2{dice(-1.0, 1.0), dice(-1.0, 1.0)});
    contacts.clear(x.size());
    for (int disc = 0; disc < discs; ++disc) {
      for (int k = 0; k < segments; ++k) {
        ContactPair pair;
        pair.disc = disc;
        pair.a = discs + k;
        pair.b = discs + segments + k;
        pair.contact_distance = dice(0.1, 0.5);
        pair.disc_radius = 0.5 * pair.contact_distance;
        contacts.add(pair);
      }
    }
    contacts.begin_substep(1.0);
  }
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static double distance(const ContactPair& pair, const std::vector<Vec2>& x) {
    return find_separation(x[at(pair.disc)], x[at(pair.a)], x[at(pair.b)]).distance;
  }
  /// Each point displaced at random, by up to `size` [m] in x and in y.
  std::vector<Vec2> displaced(Dice& dice, double size) const {
    std::vector<Vec2> to = x;
    for (Vec2& point : to) point += Vec2{dice(-size, size), dice(-size, size)};
    return to;
  }
};

TEST(CandidateList, ContainsEveryPairThatTouches) {
  Dice dice(1);
  Scene scene(dice);
  for (int step = 0; step < 200; ++step) {
    const std::vector<Vec2> to = scene.displaced(dice, step % 10 == 0 ? 0.3 : 0.003);
    scene.contacts.list_candidates(scene.x, to);
    const auto listed = scene.contacts.candidates.pairs();
    ASSERT_TRUE(std::is_sorted(listed.begin(), listed.end()));
    for (std::size_t k = 0; k < scene.contacts.pairs.size(); ++k) {
      const ContactPair& pair = scene.contacts.pairs[k];
      const double nearest = std::min(Scene::distance(pair, scene.x), Scene::distance(pair, to));
      if (nearest > pair.contact_distance) continue;
      EXPECT_TRUE(std::binary_search(listed.begin(), listed.end(), k)) << step << ", pair " << k;
    }
    scene.x = to;
  }
}

TEST(CandidateList, IsNotSearchedAgainWithinItsSkins) {
  Dice dice(2);
  Scene scene(dice);
  scene.contacts.list_candidates(scene.x, scene.x);
  const auto all = static_cast<std::int64_t>(scene.contacts.pairs.size());
  EXPECT_EQ(scene.contacts.candidates.take_checks(), all);
  const std::vector<Vec2> to = scene.displaced(dice, 0.005);  // the least skin is a tenth of 0.1 m
  scene.contacts.list_candidates(scene.x, to);
  EXPECT_EQ(scene.contacts.candidates.take_checks(), 0);
}

TEST(ContactSweep, KeepsEveryPairApartOnTheCollisionFreePartOfThePath) {
  int limited = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    Dice dice(seed);
    Scene scene(dice);
    const std::vector<Vec2> to = scene.displaced(dice, 3.0);
    ContactSweep sweep;
    const double free = sweep.collision_free_fraction(scene.contacts, scene.x, to, KinematicTime::current);
    ASSERT_GE(free, 0.0);
    ASSERT_LE(free, 1.0);
    limited += free < 1.0 ? 1 : 0;
    for (int k = 0; k <= 100; ++k) {
      std::vector<Vec2> between = scene.x;
      for (std::size_t p = 0; p < between.size(); ++p) between[p] += (0.01 * k * free) * (to[p] - scene.x[p]);
      for (const ContactPair& pair : scene.contacts.pairs.all()) {
        const double start = Scene::distance(pair, scene.x);
        EXPECT_GE(Scene::distance(pair, between), std::min(0.9 * pair.contact_distance, 0.98 * start) - 1e-12) << seed;
      }
    }
  }
  EXPECT_GT(limited, 25);
}

/// A column of discs moves towards a disc that does not move. Each stops the one behind it.
TEST(ContactSweep, WhatHasToStopStopsWhatComesBehind) {
  constexpr int moving = 40;
  constexpr double distance = 0.2;  // m, of contact
  ContactScene scene;
  scene.clear(moving + 1);
  std::vector<Vec2> from;
  std::vector<Vec2> to;
  std::vector<int> groups;
  for (int k = 0; k <= moving; ++k) {
    from.push_back({0.3 * k, 0.0});
    to.push_back(from.back() + (k < moving ? Vec2{10.0, 0.0} : Vec2{}));
    groups.push_back(k < moving ? k : -1);
    if (k == 0) continue;
    ContactPair pair;
    pair.disc = k - 1;
    pair.a = pair.b = k;
    pair.contact_distance = distance;
    pair.disc_radius = 0.5 * distance;
    scene.add(pair);
  }
  scene.begin_substep(1.0);
  ContactSweep sweep;
  std::vector<double> fractions(from.size(), 1.0);
  EXPECT_FALSE(sweep.separate_groups(scene, from, to, groups, fractions));
  const auto end = [&](int k) {
    return from[Scene::at(k)].x + fractions[Scene::at(k)] * (to[Scene::at(k)].x - from[Scene::at(k)].x);
  };
  for (int k = 0; k < moving; ++k) EXPECT_LT(end(k), end(k + 1)) << k;
}

TEST(ContactSweep, NoPairThatEndsNearIsOverlooked) {
  Dice dice(7);
  Scene scene(dice);
  int near = 0;
  int left_out = 0;
  for (int step = 0; step < 50; ++step) {
    const std::vector<Vec2> to = scene.displaced(dice, 0.3);
    ContactSweep sweep;
    sweep.reserve(scene.x.size(), scene.x.size());
    sweep.set_path(scene.contacts, scene.x, to);
    for (std::size_t k = 0; k < scene.contacts.pairs.size(); ++k) {
      const double distance = Scene::distance(scene.contacts.pairs[k], to);
      near += distance < 0.5 ? 1 : 0;
      if (sweep.may_end_within(scene.contacts.pairs.geometry(k), 0.5)) continue;
      ++left_out;
      EXPECT_GT(distance, 0.5 - 1e-12) << step << ", pair " << k;
    }
    scene.x = to;
  }
  EXPECT_GT(near, 200);
  EXPECT_GT(left_out, 10'000);
}

/// All pairs that a group is part of limit it, also those that are looked at when it is limited already.
TEST(ContactSweep, TheNearestPairLimitsItsGroups) {
  Dice dice(8);
  for (int run = 0; run < 100; ++run) {
    Scene scene(dice);
    const std::vector<Vec2> to = scene.displaced(dice, 1.0);
    std::vector<int> groups(scene.x.size());
    for (int& group : groups) group = static_cast<int>(dice(0.0, 3.0));
    std::vector<double> fractions(3, 1.0);
    ContactSweep sweep;
    sweep.reserve(scene.x.size(), scene.x.size());
    sweep.separate_groups(scene.contacts, scene.x, to, groups, fractions);
    std::vector<Vec2> end(scene.x.size());
    for (std::size_t p = 0; p < end.size(); ++p) {
      end[p] = scene.x[p] + fractions[Scene::at(groups[p])] * (to[p] - scene.x[p]);
    }
    for (std::size_t k = 0; k < scene.contacts.pairs.size(); ++k) {
      const ContactPair& pair = scene.contacts.pairs[k];
      const double start = Scene::distance(pair, scene.x);
      const double least = scene.contacts.pairs.geometry(k).overlap_fraction * pair.contact_distance;
      EXPECT_GE(Scene::distance(pair, end), 0.99 * std::min(start, least)) << run << ", pair " << k;
    }
  }
}

}  // namespace
}  // namespace ribbon
