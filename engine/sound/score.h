#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/sound/wav.h"

/// Scores: short pieces of music as plain text, which play in a loop.
///
/// A score has lines of words; `#` at the start of a line or after a space begins a comment. In this order:
///
///     tempo 72                            beats a minute, 30 … 240
///     meter 4                             beats a bar, 1 … 12
///     voice lute pluck volume 0.6 ring 2 bright 0.4    at least one; then its sections:
///     section verse
///     lute: D3 A3 F#4+A4 - | . D4         the notes of a voice, in bars that `|` separates
///     play verse verse                    the sections in their order
///
/// A voice is a `pluck` (a string), a `pad` (a soft chord) or a `drum`. It may have a `volume` (0 … 1, by default 0.5),
/// a `ring` (the seconds in which it dies away by 60 dB, 0.05 … 10, by default 2) and `bright` (0 … 1, by default 0.4).
/// Each word of a bar has an equal share of it: notes that start together, as `D3` or `D3+F#3+Bb3` (C1 … B7); `.` for
/// silence; `-` to hold the notes before, also those of the bar before. A section may have several lines for a voice;
/// they follow each other. All voices that a section names have the same number of bars.
namespace engine {

enum class Instrument : unsigned char { pluck, pad, drum };

struct ScoreVoice {
  std::string name;
  Instrument instrument = Instrument::pluck;
  double volume = 0.5;  ///< 0 … 1
  double ring = 2.0;    ///< s, until it has died away by 60 dB
  double bright = 0.4;  ///< 0 … 1
};

struct ScoreNote {
  std::size_t voice = 0;
  int key = 0;          ///< as in MIDI: 60 is C4, 69 is A4 with 440 Hz
  double start = 0.0;   ///< s
  double length = 0.0;  ///< s
};

struct Score {
  static constexpr double max_seconds = 300.0;
  static constexpr std::size_t max_notes = 20'000;
  static constexpr std::size_t max_bytes = std::size_t{64} << 10U;

  double seconds = 0.0;  ///< of the loop, above 0
  std::vector<ScoreVoice> voices;
  std::vector<ScoreNote> notes;
};

/// Reads a score of at most max_bytes. Throws SoundError if the file cannot be read or is invalid.
Score load_score(const std::string& path);
/// Reads the text of a score. Throws SoundError as "FILE:LINE: fault; accepted is …"; `file` stands for FILE.
Score parse_score(std::string_view text, const std::string& file);

}  // namespace engine
