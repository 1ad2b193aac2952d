#include "engine/sound/score.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "engine/files/number_text.h"
#include "engine/files/regular_file.h"

namespace engine {
namespace {

constexpr std::size_t max_voices = 16;
constexpr std::size_t max_sections = 64;
constexpr std::size_t max_words_in_bar = 64;

/// The notes of one voice in a section, by words of equal length in each bar.
struct Bar {
  struct Word {
    std::vector<int> keys;  // empty: silence, or a hold
    bool holds = false;
  };
  std::vector<Word> words;
};

struct Section {
  std::string name;
  std::vector<std::vector<Bar>> bars;  // by voice; empty for a voice without a line

  std::size_t length() const {
    std::size_t most = 0;
    for (const std::vector<Bar>& voice : bars) most = std::max(most, voice.size());
    return most;
  }
};

std::vector<std::string> words_of(std::string_view line) {
  std::istringstream in{std::string(line)};
  std::vector<std::string> words;
  for (std::string word; in >> word && word[0] != '#';) words.push_back(word);
  return words;
}

/// Returns the key of a note such as F#4.
std::optional<int> key_in(std::string_view word) {
  static constexpr std::string_view letters = "C.D.EF.G.A.B";  // by semitone
  if (word.size() < 2 || word[0] == '.') return std::nullopt;
  const std::size_t semitone = letters.find(word[0]);
  if (semitone == std::string_view::npos) return std::nullopt;
  const bool is_altered = word[1] == '#' || word[1] == 'b';
  const std::string_view octave = word.substr(is_altered ? 2 : 1);
  if (octave.size() != 1 || octave[0] < '1' || octave[0] > '7') return std::nullopt;
  const int shift = word[1] == '#' ? 1 : word[1] == 'b' ? -1 : 0;
  return 12 * (octave[0] - '0' + 1) + static_cast<int>(semitone) + shift;
}

/// Reads a score line by line.
class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Score read(std::string_view text) {
    if (text.size() > Score::max_bytes) fail("is larger than 64 KiB", "a shorter score");
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) {
      ++line_;
      if (const auto words = words_of(line); !words.empty()) read_line(words);
    }
    if (score_.seconds == 0.0) fail("the score ends without a line play", "play SECTION …");
    return std::move(score_);
  }

 private:
  [[noreturn]] void fail(const std::string& fault, const std::string& accepted) const {
    throw SoundError(file_ + ":" + std::to_string(line_) + ": " + fault + "; accepted is " + accepted);
  }

  void read_line(const std::vector<std::string>& words) {
    if (score_.seconds > 0.0) fail("there is a line after play", "one line play at the end");
    if (words[0] == "tempo") return read_once(tempo_, words, 30.0, 240.0);
    if (words[0] == "meter") return read_meter(words);
    if (words[0] == "voice") return read_voice(words);
    if (words[0] == "section") return read_section(words);
    if (words[0] == "play") return read_play(words);
    if (words[0].back() == ':') return read_notes(words);
    fail("the line begins with " + words[0], "tempo, meter, voice, section, play, or a voice with a colon");
  }

  double number(const std::string& what, const std::string& word, double min, double max) const {
    const auto value = fixed_number(word);
    if (value && *value >= min && *value <= max) return *value;
    std::ostringstream range;
    range << "a number from " << min << " to " << max;
    fail(what + " is " + word, range.str());
  }

  void read_once(double& value, const std::vector<std::string>& words, double min, double max) {
    if (value != 0.0) fail(words[0] + " is set twice", "one line of it");
    if (words.size() != 2) fail(words[0] + " has " + std::to_string(words.size() - 1) + " values", "one number");
    value = number(words[0], words[1], min, max);
  }

  void read_meter(const std::vector<std::string>& words) {
    read_once(meter_, words, 1.0, 12.0);
    if (meter_ != static_cast<double>(static_cast<int>(meter_))) fail("meter is " + words[1], "a whole number");
  }

  void read_voice(const std::vector<std::string>& words) {
    if (!sections_.empty()) fail("a voice comes after a section", "all voices before the sections");
    if (score_.voices.size() == max_voices) fail("there are more than 16 voices", "at most 16");
    if (words.size() < 3 || words.size() % 2 == 0)
      fail("the voice is incomplete", "voice NAME KIND [SETTING NUMBER] …");
    ScoreVoice voice;
    voice.name = words[1];
    if (find_voice(voice.name)) fail("the voice " + voice.name + " is there twice", "a name of its own for each");
    static const std::vector<std::string> kinds = {"pluck", "pad", "drum"};
    const auto kind = std::find(kinds.begin(), kinds.end(), words[2]);
    if (kind == kinds.end()) fail("the voice is a " + words[2], "pluck, pad or drum");
    voice.instrument = static_cast<Instrument>(kind - kinds.begin());
    for (std::size_t k = 3; k < words.size(); k += 2) read_setting(voice, words[k], words[k + 1]);
    score_.voices.push_back(voice);
  }

  void read_setting(ScoreVoice& voice, const std::string& name, const std::string& word) const {
    if (name == "volume") {
      voice.volume = number(name, word, 0.0, 1.0);
    } else if (name == "ring") {
      voice.ring = number(name, word, 0.05, 10.0);
    } else if (name == "bright") {
      voice.bright = number(name, word, 0.0, 1.0);
    } else {
      fail("the voice has a setting " + name, "volume, ring or bright");
    }
  }

  void read_section(const std::vector<std::string>& words) {
    if (tempo_ == 0.0 || meter_ == 0.0 || score_.voices.empty()) {
      fail("a section comes too early", "tempo, meter and a voice before it");
    }
    if (words.size() != 2) fail("the section has " + std::to_string(words.size() - 1) + " names", "one name");
    if (sections_.size() == max_sections) fail("there are more than 64 sections", "at most 64");
    check_section();
    if (find_section(words[1]) != nullptr) fail("the section " + words[1] + " is there twice", "a name of its own");
    sections_.push_back({words[1], std::vector<std::vector<Bar>>(score_.voices.size())});
  }

  /// Checks that the voices of the last section are equally long.
  void check_section() const {
    if (sections_.empty()) return;
    const Section& last = sections_.back();
    if (last.length() == 0) fail("the section " + last.name + " is empty", "a line of notes in it");
    for (std::size_t v = 0; v < last.bars.size(); ++v) {
      if (last.bars[v].empty() || last.bars[v].size() == last.length()) continue;
      fail("in section " + last.name + " the voice " + score_.voices[v].name + " has " +
               std::to_string(last.bars[v].size()) + " bars, another has " + std::to_string(last.length()),
           "the same number");
    }
  }

  void read_notes(const std::vector<std::string>& words) {
    const std::string name = words[0].substr(0, words[0].size() - 1);
    const auto voice = find_voice(name);
    if (!voice) fail("no voice is named " + name, "a voice that is declared");
    if (sections_.empty()) fail("there are notes before a section", "section NAME before them");
    std::vector<Bar>& bars = sections_.back().bars[*voice];
    bars.emplace_back();
    for (std::size_t k = 1; k < words.size(); ++k) {
      if (words[k] != "|") {
        add_word(*voice, word_of(words[k]));
      } else {
        check_bar(bars.back());
        bars.emplace_back();
      }
    }
    check_bar(bars.back());
  }

  /// Adds a word to the last bar of a voice.
  void add_word(std::size_t voice, Bar::Word word) {
    std::vector<Bar>& bars = sections_.back().bars[voice];
    if (word.holds) {
      const auto begun = std::find_if(bars.rbegin(), bars.rend(), [](const Bar& bar) { return !bar.words.empty(); });
      const bool sounds = begun != bars.rend() && (begun->words.back().holds || !begun->words.back().keys.empty());
      if (!sounds) fail("a hold (-) has no note before it in its section", "a note before it");
    }
    bars.back().words.push_back(std::move(word));
  }

  void check_bar(const Bar& bar) const {
    if (bar.words.empty()) fail("a bar is empty", "a note, . or - in each bar");
    if (bar.words.size() > max_words_in_bar) fail("a bar has more than 64 words", "at most 64");
  }

  Bar::Word word_of(const std::string& text) const {
    if (text == ".") return {};
    if (text == "-") return {{}, true};
    Bar::Word word;
    std::istringstream notes(text + "+");
    for (std::string note; std::getline(notes, note, '+');) {
      const auto key = key_in(note);
      if (!key) fail("there is a note " + text, "a note such as D3, F#4 or D3+Bb3 (C1 to B7), . or -");
      word.keys.push_back(*key);
    }
    return word;
  }

  void read_play(const std::vector<std::string>& words) {
    check_section();
    if (words.size() < 2) fail("play names no section", "play SECTION …");
    double start = 0.0;
    const double bar = meter_ * 60.0 / tempo_;  // s
    for (std::size_t k = 1; k < words.size(); ++k) {
      const Section* const section = find_section(words[k]);
      if (section == nullptr) fail("no section is named " + words[k], "a section above");
      for (std::size_t v = 0; v < section->bars.size(); ++v) add_notes(v, section->bars[v], start, bar);
      start += bar * static_cast<double>(section->length());
      if (start > Score::max_seconds) fail("the piece is longer than 300 s", "a shorter one");
    }
    score_.seconds = start;
    std::stable_sort(score_.notes.begin(), score_.notes.end(),
                     [](const ScoreNote& a, const ScoreNote& b) { return a.start < b.start; });
  }

  void add_notes(std::size_t voice, const std::vector<Bar>& bars, double start, double bar) {
    std::size_t sounding = 0;  // the number of the last notes that a hold lengthens
    for (std::size_t b = 0; b < bars.size(); ++b) {
      const double share = bar / static_cast<double>(bars[b].words.size());
      for (std::size_t w = 0; w < bars[b].words.size(); ++w) {
        const Bar::Word& word = bars[b].words[w];
        if (word.holds) {
          for (std::size_t n = score_.notes.size() - sounding; n < score_.notes.size(); ++n) {
            score_.notes[n].length += share;
          }
          continue;
        }
        sounding = word.keys.size();
        const double at = start + bar * static_cast<double>(b) + share * static_cast<double>(w);
        for (const int key : word.keys) score_.notes.push_back({voice, key, at, share});
        if (score_.notes.size() > Score::max_notes) fail("the piece has more than 20000 notes", "fewer");
      }
    }
  }

  std::optional<std::size_t> find_voice(const std::string& name) const {
    for (std::size_t v = 0; v < score_.voices.size(); ++v) {
      if (score_.voices[v].name == name) return v;
    }
    return std::nullopt;
  }

  const Section* find_section(const std::string& name) const {
    const auto found =
        std::find_if(sections_.begin(), sections_.end(), [&](const Section& s) { return s.name == name; });
    return found == sections_.end() ? nullptr : &*found;
  }

  std::string file_;
  int line_ = 0;
  double tempo_ = 0.0;  // beats a minute; 0: not read yet
  double meter_ = 0.0;  // beats a bar; 0: not read yet
  std::vector<Section> sections_;
  Score score_;
};

}  // namespace

Score parse_score(std::string_view text, const std::string& file) { return Reader(file).read(text); }

Score load_score(const std::string& path) {
  std::ifstream in;
  try {
    in = open_regular_file(path);
  } catch (const std::runtime_error& error) {
    throw SoundError(error.what());
  }
  std::string text(Score::max_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) throw SoundError(path + ": reading failed");
  text.resize(static_cast<std::size_t>(in.gcount()));
  return parse_score(text, path);
}

}  // namespace engine
