#include "ribbon/box2d/state_hash.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

namespace engine {
namespace {

template <class... Values>
std::uint64_t hash_of(Values... values) {
  ribbon::box2d::Hasher hasher;
  (hasher.add(values), ...);
  return hasher.value();
}

ribbon::box2d::Hasher hasher_of(double value) {
  ribbon::box2d::Hasher hasher;
  hasher.add(value);
  return hasher;
}

/// A state with two cords and a body.
ribbon::box2d::StateHash state(double cord_0 = 1.0, double cord_1 = 2.0, double body_0 = 3.0) {
  ribbon::box2d::StateHash hash;
  hash.add(ribbon::box2d::Subsystem::cord, 0, hasher_of(cord_0));
  hash.add(ribbon::box2d::Subsystem::cord, 1, hasher_of(cord_1));
  hash.add(ribbon::box2d::Subsystem::body, 0, hasher_of(body_0));
  return hash;
}

TEST(Hasher, IsAFixedFunction) {
  // Recorded replays contain these hashes: if this test fails, all of them are invalid.
  EXPECT_EQ(ribbon::box2d::to_hex(hash_of()), "e9e0033e3badaf36");
  EXPECT_EQ(ribbon::box2d::to_hex(hash_of(1.0, -2.5F, std::uint32_t{7}, std::int64_t{-1}, true)), "a754c32fa3b972e7");
}

TEST(Hasher, DistinguishesValuesThatCompareEqual) {
  EXPECT_NE(hash_of(0.0), hash_of(-0.0));
  EXPECT_NE(hash_of(0.0F), hash_of(-0.0F));
  const auto nan = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(hash_of(std::bit_cast<double>(nan)), hash_of(std::bit_cast<double>(nan + 1)));
  EXPECT_EQ(hash_of(std::bit_cast<double>(nan)), hash_of(std::bit_cast<double>(nan)));
}

TEST(Hasher, DependsOnTheLastBitOrderAndNumberOfValues) {
  EXPECT_NE(hash_of(1.0), hash_of(1.0 + std::numeric_limits<double>::epsilon()));
  EXPECT_NE(hash_of(1.0, 2.0), hash_of(2.0, 1.0));
  std::set<std::uint64_t> zeros;
  ribbon::box2d::Hasher hasher;
  for (int n = 0; n < 1000; ++n, hasher.add(0)) zeros.insert(hasher.value());
  EXPECT_EQ(zeros.size(), 1000U) << "a run of zeros must not hide how long it is";
}

TEST(Hasher, HashesAVectorAsItsTwoCoordinates) { EXPECT_EQ(hash_of(ribbon::Vec2{1.0, 2.0}), hash_of(1.0, 2.0)); }

TEST(Hasher, OneFlippedBitFlipsAboutHalfOfTheValue) {
  for (int bit = 0; bit < 64; ++bit) {
    const int flipped = std::popcount(hash_of(0, 5) ^ hash_of(std::uint64_t{1} << bit, 5));
    EXPECT_GT(flipped, 12) << "bit " << bit;
    EXPECT_LT(flipped, 52) << "bit " << bit;
  }
}

TEST(StateHash, EqualStatesHaveNoDifference) {
  EXPECT_EQ(state(), state());
  EXPECT_FALSE(ribbon::box2d::first_difference(state(), state()));
  EXPECT_FALSE(ribbon::box2d::first_difference({}, {}));
}

TEST(StateHash, NamesThePartThatDiffers) {
  const ribbon::box2d::StateHash recorded = state(1.0, 2.0, 3.0);
  const ribbon::box2d::StateHash computed = state(1.0, 2.5, 3.5);
  const auto difference = ribbon::box2d::first_difference(recorded, computed);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->kind, ribbon::box2d::Divergence::Kind::differs);
  EXPECT_EQ(difference->subsystem, ribbon::box2d::Subsystem::cord);
  EXPECT_EQ(difference->index, 1);
  EXPECT_EQ(describe(*difference), "cord 1 differs (recorded " + ribbon::box2d::to_hex(recorded.parts()[1].hash) +
                                       ", now " + ribbon::box2d::to_hex(computed.parts()[1].hash) + ")");
}

TEST(StateHash, NamesAMissingPart) {
  ribbon::box2d::StateHash computed;
  computed.add(ribbon::box2d::Subsystem::cord, 0, hasher_of(1.0));
  computed.add(ribbon::box2d::Subsystem::body, 0, hasher_of(3.0));
  const auto difference = ribbon::box2d::first_difference(state(), computed);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->kind, ribbon::box2d::Divergence::Kind::missing);
  EXPECT_EQ(describe(*difference),
            "cord 1 is missing (recorded " + ribbon::box2d::to_hex(state().parts()[1].hash) + ", now not there)");
}

TEST(StateHash, NamesAPartMissingAtTheEnd) {
  ribbon::box2d::StateHash computed;
  computed.add(ribbon::box2d::Subsystem::cord, 0, hasher_of(1.0));
  const auto difference = ribbon::box2d::first_difference(state(), computed);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->kind, ribbon::box2d::Divergence::Kind::missing);
  EXPECT_EQ(difference->subsystem, ribbon::box2d::Subsystem::cord);
  EXPECT_EQ(difference->index, 1);
}

TEST(StateHash, NamesANewPartAtAnyPosition) {
  ribbon::box2d::StateHash in_front;
  in_front.add(ribbon::box2d::Subsystem::game, 0, hasher_of(9.0));
  for (std::uint16_t i = 0; i < 2; ++i) in_front.add(ribbon::box2d::Subsystem::cord, i, hasher_of(1.0 + i));
  in_front.add(ribbon::box2d::Subsystem::body, 0, hasher_of(3.0));
  const auto first = ribbon::box2d::first_difference(state(), in_front);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, ribbon::box2d::Divergence::Kind::extra);
  EXPECT_EQ(describe(*first),
            "game 0 is new (not recorded there, now " + ribbon::box2d::to_hex(in_front.parts()[0].hash) + ")");

  ribbon::box2d::StateHash at_the_end = state();
  at_the_end.add(ribbon::box2d::Subsystem::body, 1, hasher_of(9.0));
  const auto last = ribbon::box2d::first_difference(state(), at_the_end);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->kind, ribbon::box2d::Divergence::Kind::extra);
  EXPECT_EQ(last->subsystem, ribbon::box2d::Subsystem::body);
  EXPECT_EQ(last->index, 1);
}

TEST(StateHash, TheSamePartsInAnotherOrderDiffer) {
  ribbon::box2d::StateHash swapped;
  swapped.add(ribbon::box2d::Subsystem::cord, 1, hasher_of(2.0));
  swapped.add(ribbon::box2d::Subsystem::cord, 0, hasher_of(1.0));
  swapped.add(ribbon::box2d::Subsystem::body, 0, hasher_of(3.0));
  EXPECT_NE(swapped.combined(), state().combined());
  EXPECT_TRUE(ribbon::box2d::first_difference(state(), swapped));
}

TEST(StateHash, The64BitHashDetectsCollisionsOfThe32BitHashes) {
  const ribbon::box2d::StateHash recorded({{ribbon::box2d::Subsystem::cord, 0, 1}}, 10);
  const ribbon::box2d::StateHash computed({{ribbon::box2d::Subsystem::cord, 0, 1}}, 11);
  const auto difference = ribbon::box2d::first_difference(recorded, computed);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->kind, ribbon::box2d::Divergence::Kind::combined);
  EXPECT_EQ(describe(*difference),
            "the state differs (recorded 000000000000000a, now 000000000000000b) though no single part shows it");
}

TEST(StateHash, ClearedAndRefilledIsTheSameAndAllocatesNothing) {
  ribbon::box2d::StateHash hash = state();
  const ribbon::box2d::StatePart* storage = hash.parts().data();
  hash.clear();
  EXPECT_TRUE(hash.parts().empty());
  EXPECT_EQ(hash.combined(), ribbon::box2d::StateHash().combined());
  hash.add(ribbon::box2d::Subsystem::cord, 0, hasher_of(1.0));
  hash.add(ribbon::box2d::Subsystem::cord, 1, hasher_of(2.0));
  hash.add(ribbon::box2d::Subsystem::body, 0, hasher_of(3.0));
  EXPECT_EQ(hash, state());
  EXPECT_EQ(hash.parts().data(), storage);
}

TEST(StateHash, SubsystemsHaveNames) {
  EXPECT_EQ(ribbon::box2d::subsystem_name(ribbon::box2d::Subsystem::game), "game");
  EXPECT_EQ(ribbon::box2d::subsystem_name(ribbon::box2d::Subsystem::cord), "cord");
  EXPECT_EQ(ribbon::box2d::subsystem_name(ribbon::box2d::Subsystem::body), "body");
}

TEST(HashBytes, IsFnv1a) {
  // Test vectors of the FNV reference implementation (Fowler, Noll, Vo; draft-eastlake-fnv).
  EXPECT_EQ(ribbon::box2d::to_hex(ribbon::box2d::hash_bytes("")), "cbf29ce484222325");
  EXPECT_EQ(ribbon::box2d::to_hex(ribbon::box2d::hash_bytes("a")), "af63dc4c8601ec8c");
  EXPECT_EQ(ribbon::box2d::to_hex(ribbon::box2d::hash_bytes("foobar")), "85944171f73967e8");
  EXPECT_NE(ribbon::box2d::hash_bytes(std::string_view("\0", 1)), ribbon::box2d::hash_bytes(""));
  EXPECT_NE(ribbon::box2d::hash_bytes("\xff"), ribbon::box2d::hash_bytes("\x7f"));
}

TEST(ToHex, KeepsLeadingZeros) {
  EXPECT_EQ(ribbon::box2d::to_hex(std::uint64_t{0x0123456789abcdef}), "0123456789abcdef");
  EXPECT_EQ(ribbon::box2d::to_hex(std::uint64_t{0}), "0000000000000000");
  EXPECT_EQ(ribbon::box2d::to_hex(std::uint32_t{0xabc}), "00000abc");
}

}  // namespace
}  // namespace engine
