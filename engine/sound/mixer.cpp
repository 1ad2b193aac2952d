#include "engine/sound/mixer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace engine {
namespace {

constexpr double settling_time = 0.012;  // s, time constant of volume changes: long enough to avoid clicks
constexpr float inaudible = 1e-5F;
constexpr float knee = 0.7F;  // the limiter is linear below this amplitude

/// A soft limiter: compresses amplitudes above the knee to stay below 1, with a continuous slope at the knee.
float limit(float x) {
  const float size = std::abs(x);
  if (size <= knee) return x;
  const float headroom = 1.0F - knee;
  const float above = (size - knee) / headroom;
  return std::copysign(knee + headroom * above / (1.0F + above), x);
}

/// Clamps x; NaN gives `min`.
double clamped(double x, double min, double max) { return x > min ? std::min(x, max) : min; }

float approached(float from, float to, float fraction) {
  const float next = from + fraction * (to - from);
  return std::abs(to - next) < inaudible ? to : next;
}

}  // namespace

Mixer::Mixer(int rate) : rate_(rate), approach_(static_cast<float>(1.0 / (settling_time * rate))) {
  voices_.reserve(max_voices);
}

SoundId Mixer::add(Sound sound) {
  sounds_.push_back(std::move(sound));
  return static_cast<SoundId>(sounds_.size()) - 1;
}

/// Equal-power panning: the loudness does not depend on the pan.
Mixer::Gains Mixer::gains_of(const Playing& how) {
  const double volume = clamped(how.volume, 0.0, 4.0);
  const double pan = std::isnan(how.pan) ? 0.0 : clamped(how.pan, -1.0, 1.0);
  return {static_cast<float>(volume * std::sqrt(0.5 * (1.0 - pan))),
          static_cast<float>(volume * std::sqrt(0.5 * (1.0 + pan)))};
}

double Mixer::step_of(SoundId sound, double pitch) const {
  return clamped(pitch, 0.125, 8.0) * sounds_[static_cast<std::size_t>(sound)].rate / rate_;
}

void Mixer::play(SoundId sound, const Playing& how) {
  if (voices() == max_voices) voices_.erase(voices_.begin());
  voices_.push_back({sound, 0.0, step_of(sound, how.pitch), gains_of(how)});
}

LoopId Mixer::start_loop(SoundId sound) {
  const double step = step_of(sound, 1.0);
  loops_.push_back({sound, 0.0, step, step, {}, {}});
  return static_cast<LoopId>(loops_.size()) - 1;
}

void Mixer::set_loop(LoopId loop, const Playing& how) {
  Loop& set = loops_[static_cast<std::size_t>(loop)];
  set.target = gains_of(how);
  set.target_step = step_of(set.sound, how.pitch);
}

void Mixer::fade_out() {
  for (Voice& voice : voices_) voice.ends = true;
  for (Loop& loop : loops_) loop.target = {};
}

void Mixer::set_volume(double volume) { target_volume_ = static_cast<float>(clamped(volume, 0.0, 1.0)); }

void Mixer::add_voice(Voice& voice, std::span<float> stereo) const {
  const std::vector<float>& x = samples(voice.sound);
  for (std::size_t k = 0; k + 1 < stereo.size(); k += 2) {
    const auto here = static_cast<std::size_t>(voice.at);
    voice.is_over = here + 1 >= x.size() || voice.fade == 0.0F;
    if (voice.is_over) return;
    const auto part = static_cast<float>(voice.at - static_cast<double>(here));
    const float value = voice.fade * (x[here] + part * (x[here + 1] - x[here]));
    stereo[k] += voice.gains.left * value;
    stereo[k + 1] += voice.gains.right * value;
    voice.at += voice.step;
    if (voice.ends) voice.fade = approached(voice.fade, 0.0F, approach_);
  }
}

void Mixer::add_loop(Loop& loop, std::span<float> stereo) const {
  const auto is_silent = [](const Gains& gains) { return gains.left == 0.0F && gains.right == 0.0F; };
  if (is_silent(loop.gains) && is_silent(loop.target)) return;
  const std::vector<float>& x = samples(loop.sound);
  for (std::size_t k = 0; k + 1 < stereo.size(); k += 2) {
    loop.gains.left = approached(loop.gains.left, loop.target.left, approach_);
    loop.gains.right = approached(loop.gains.right, loop.target.right, approach_);
    loop.step += static_cast<double>(approach_) * (loop.target_step - loop.step);
    const auto here = static_cast<std::size_t>(loop.at);
    const float next = x[here + 1 < x.size() ? here + 1 : 0];
    const auto part = static_cast<float>(loop.at - static_cast<double>(here));
    const float value = x[here] + part * (next - x[here]);
    stereo[k] += loop.gains.left * value;
    stereo[k + 1] += loop.gains.right * value;
    loop.at = std::fmod(loop.at + loop.step, static_cast<double>(x.size()));
  }
}

void Mixer::mix(std::span<float> stereo) {
  std::fill(stereo.begin(), stereo.end(), 0.0F);
  for (Voice& voice : voices_) add_voice(voice, stereo);
  std::erase_if(voices_, [](const Voice& voice) { return voice.is_over; });
  for (Loop& loop : loops_) add_loop(loop, stereo);
  for (std::size_t k = 0; k + 1 < stereo.size(); k += 2) {
    volume_ = approached(volume_, target_volume_, approach_);
    stereo[k] = limit(volume_ * stereo[k]);
    stereo[k + 1] = limit(volume_ * stereo[k + 1]);
  }
}

}  // namespace engine
