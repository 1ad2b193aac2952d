#include "engine/sound/score.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/refusal.h"

namespace {

using engine::parse_score;
using engine::Score;

const std::string two_voices = "tempo 60\nmeter 4\nvoice lute pluck volume 0.6 ring 2 bright 0.4\nvoice mist pad\n";

std::string refused(const std::string& text) {
  return test_support::refusal<engine::SoundError>([&] { parse_score(text, "a.score"); });
}

TEST(Score, PlacesTheNotesInTheirBars) {
  const Score score = parse_score(
      two_voices + "# a comment\nsection a\nlute: A4 - . C#4 | Bb2+C3  # one more\nmist: D3 | -\nplay a a\n",
      "a.score");
  EXPECT_EQ(score.seconds, 16.0);
  ASSERT_EQ(score.voices.size(), 2U);
  EXPECT_EQ(score.voices[0].volume, 0.6);
  EXPECT_EQ(score.voices[1].instrument, engine::Instrument::pad);
  ASSERT_EQ(score.notes.size(), 10U);
  EXPECT_EQ(score.notes[0].key, 69);
  EXPECT_EQ(score.notes[0].length, 2.0) << "a hold";
  EXPECT_EQ(score.notes[1].key, 50);
  EXPECT_EQ(score.notes[1].length, 8.0) << "held into the next bar";
  EXPECT_EQ(score.notes[2].key, 61);
  EXPECT_EQ(score.notes[2].start, 3.0);
  EXPECT_EQ(score.notes[3].key, 46);
  EXPECT_EQ(score.notes[3].length, 4.0);
  EXPECT_EQ(score.notes[4].start, 4.0);
  EXPECT_EQ(score.notes[5].start, 8.0) << "the second time";
}

TEST(Score, NamesTheLineThatIsWrongAndWhatIsAccepted) {
  EXPECT_EQ(refused("tempo 20\n"), "a.score:1: tempo is 20; accepted is a number from 30 to 240");
  EXPECT_EQ(refused("tempo 60\ntempo 60\n"), "a.score:2: tempo is set twice; accepted is one line of it");
  EXPECT_EQ(refused("meter 3.5\n"), "a.score:1: meter is 3.5; accepted is a whole number");
  EXPECT_EQ(refused("voice a horn\n"), "a.score:1: the voice is a horn; accepted is pluck, pad or drum");
  EXPECT_EQ(refused("voice a pad volume 2\n"), "a.score:1: volume is 2; accepted is a number from 0 to 1");
  EXPECT_EQ(refused("voice a pad colour 2\n"),
            "a.score:1: the voice has a setting colour; accepted is volume, ring or bright");
  EXPECT_EQ(refused("voice a pad\nvoice a pad\n"),
            "a.score:2: the voice a is there twice; accepted is a name of its own for each");
  EXPECT_EQ(refused("section a\n"),
            "a.score:1: a section comes too early; accepted is tempo, meter and a voice before it");
  EXPECT_EQ(refused(two_voices + "section a\nlute: H4\n"),
            "a.score:6: there is a note H4; accepted is a note such as D3, F#4 or D3+Bb3 (C1 to B7), . or -");
  EXPECT_EQ(refused(two_voices + "section a\nhorn: A4\n"),
            "a.score:6: no voice is named horn; accepted is a voice that is declared");
  EXPECT_EQ(refused(two_voices + "section a\nlute: . -\n"),
            "a.score:6: a hold (-) has no note before it in its section; accepted is a note before it");
  EXPECT_EQ(refused(two_voices + "section a\nlute: A4 | | A4\n"),
            "a.score:6: a bar is empty; accepted is a note, . or - in each bar");
  EXPECT_EQ(refused(two_voices + "section a\nlute: A4 | A4\nmist: A4\nplay a\n"),
            "a.score:8: in section a the voice mist has 1 bars, another has 2; accepted is the same number");
  EXPECT_EQ(refused(two_voices + "section a\nlute: A4\nplay b\n"),
            "a.score:7: no section is named b; accepted is a section above");
  EXPECT_EQ(refused(two_voices + "section a\nlute: A4\n"),
            "a.score:6: the score ends without a line play; accepted is play SECTION …");
  EXPECT_EQ(refused(two_voices + "section a\nlute: A4\nplay a\nplay a\n"),
            "a.score:8: there is a line after play; accepted is one line play at the end");
  EXPECT_EQ(
      refused("sing\n"),
      "a.score:1: the line begins with sing; accepted is tempo, meter, voice, section, play, or a voice with a colon");
}

TEST(Score, HasAGreatestSize) {
  std::string bars = "lute: A4";
  for (int k = 0; k < 90; ++k) bars += " | A4";
  EXPECT_NE(refused(two_voices + "section a\n" + bars + "\nplay a\n").find("longer than 300 s"), std::string::npos);
  EXPECT_NE(refused(std::string(Score::max_bytes + 1, '#')).find("larger than 64 KiB"), std::string::npos);
  std::string words = "lute: A4";
  for (int k = 0; k < 64; ++k) words += " A4";
  EXPECT_NE(refused(two_voices + "section a\n" + words + "\n").find("more than 64 words"), std::string::npos);
}

/// Cut at every byte, and with every byte changed: the score is accepted or refused, and the message names a line.
TEST(Score, ABrokenScoreIsRefusedWithAMessage) {
  const std::string whole = two_voices + "section a\nlute: A4 - . C#4 | Bb2+C3\nmist: D3 | -\nplay a a\n";
  int accepted = 0;
  const auto read = [&](const std::string& text) {
    try {
      parse_score(text, "a.score");
      ++accepted;
    } catch (const engine::SoundError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("a.score:", 0), 0U) << error.what();
    }
  };
  for (std::size_t length = 0; length < whole.size(); ++length) read(whole.substr(0, length));
  EXPECT_EQ(accepted, 3) << "without the line feed, the second section or the space before it";
  for (std::size_t k = 0; k < whole.size(); ++k) {
    for (const char by : {'\0', '-', '9', '\n', '\xff', '#', ':'}) read(std::string(whole).replace(k, 1, 1, by));
  }
}

}  // namespace
