#include "engine/sound/score_renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace engine {
namespace {

constexpr double echo_level = 0.16;
constexpr std::size_t samples_per_step = 8192;
constexpr std::size_t lead_in = std::size_t{4} * ScoreRenderer::rate;  // samples; an echo is 100 dB lower after it

std::size_t size_of(const Score& score) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(score.seconds * ScoreRenderer::rate));
}

}  // namespace

double ScoreRenderer::Delay::comb(double in) {
  const double out = line[at];
  damped += 0.6 * (out - damped);  // high frequencies die away sooner
  line[at] = in + feedback * damped;
  at = at + 1 == line.size() ? 0 : at + 1;
  return out;
}

double ScoreRenderer::Delay::allpass(double in) {
  const double old = line[at];
  const double out = old - feedback * in;
  line[at] = in + feedback * out;
  at = at + 1 == line.size() ? 0 : at + 1;
  return out;
}

ScoreRenderer::ScoreRenderer(Score score) : score_(std::move(score)), dry_(size_of(score_)) {
  loop_.reserve(dry_.samples().size());
  constexpr std::array<std::size_t, 4> comb_sizes = {655, 727, 811, 907};  // samples, 30 … 41 ms; primes or nearly
  for (std::size_t k = 0; k < combs_.size(); ++k) combs_[k] = {std::vector<double>(comb_sizes[k]), 0.82};
  allpasses_[0] = {std::vector<double>(113), 0.6};
  allpasses_[1] = {std::vector<double>(37), 0.6};
}

bool ScoreRenderer::step() {
  if (next_note_ < score_.notes.size()) {
    const ScoreNote& note = score_.notes[next_note_++];
    add_note(dry_, rate, score_.voices[note.voice], note, static_cast<std::uint32_t>(2654435761U * next_note_) | 1U);
    return true;
  }
  if (loop_.size() < dry_.samples().size()) step_echo();
  return loop_.size() < dry_.samples().size();
}

double ScoreRenderer::echo(double in) {
  double sum = 0.0;
  for (Delay& comb : combs_) sum += comb.comb(in);
  for (Delay& allpass : allpasses_) sum = allpass.allpass(sum);
  return sum;
}

/// The echo begins before the start of the loop with the end of it, so that it has no seam either.
void ScoreRenderer::step_echo() {
  const std::vector<double>& dry = dry_.samples();
  const std::size_t offset = dry.size() - lead_in % dry.size();
  for (std::size_t k = 0; k < samples_per_step && loop_.size() < dry.size(); ++k, ++echoed_) {
    const double in = dry[(offset + echoed_) % dry.size()];
    const auto out = static_cast<float>(in + echo_level * echo(in));
    if (echoed_ < lead_in) continue;
    loop_.push_back(out);
    most_ = std::max(most_, std::abs(out));
  }
}

Sound ScoreRenderer::finish() {
  while (step()) {
  }
  const float factor = most_ > 0.0F ? static_cast<float>(peak) / most_ : 0.0F;
  for (float& sample : loop_) sample *= factor;
  return {rate, std::move(loop_)};
}

Sound render(Score score) { return ScoreRenderer(std::move(score)).finish(); }

}  // namespace engine
