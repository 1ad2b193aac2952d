#include "game/sound/sounds.h"

#include "game/simulation/level.h"

namespace game {
namespace {

constexpr std::int64_t retry_ns = 3'000'000'000;  // between two attempts to open a lost device
constexpr std::int64_t pause_ns = 200'000'000;    // without a tick; longer than a tick of slow motion
constexpr engine::SoundId none = -1;

}  // namespace

Sounds::Sounds() : had_device_(audio_.has_device()) {
  load(Noise::thud, {"thud"});
  load(Noise::slap, {"slap"});
  load(Noise::creak, {"creak_1", "creak_2", "creak_3"});
  load(Noise::catches, {"catch"});
  load(Noise::lets_go, {"let_go"});
  load(Noise::jump, {"jump"});
  load(Noise::footstep, {"footstep"});
  load(Noise::fall, {"fall"});
  load(Noise::goal, {"goal"});
  load(Noise::throws, {"throw"});
  load(Noise::hook, {"hook"});
  load(Noise::checkpoint, {"checkpoint"});
  load(Noise::dies, {"die"});
  load(Noise::cut, {"cut"});
  load(Noise::coin, {"coin"});
  load(Noise::strains, {"creak_1", "creak_2", "creak_3"});
  wind_ = load_loop("whoosh");
  reel_ = load_loop("reel");
}

engine::SoundId Sounds::load(const std::string& name) {
  try {
    return audio_.add(engine::load_wav(assets_folder() + "/sounds/" + name + ".wav"));
  } catch (const engine::SoundError& error) {
    if (load_error_.empty()) load_error_ = error.what();
    return none;
  }
}

engine::LoopId Sounds::load_loop(const std::string& name) {
  const engine::SoundId sound = load(name);
  return audio_.start_loop(sound == none ? audio_.add({engine::Audio::rate, {0.0F, 0.0F}}) : sound);
}

void Sounds::load(Noise noise, const std::vector<std::string>& names) {
  Take& take = takes_[static_cast<std::size_t>(noise)];
  for (const std::string& name : names) {
    const engine::SoundId sound = load(name);
    if (sound != none) take.sounds[take.count++] = sound;
  }
}

engine::Playing Sounds::at_volume(engine::Playing how) const {
  how.volume *= volume_;
  return how;
}

void Sounds::play(const Cue& cue) {
  Take& take = takes_[static_cast<std::size_t>(cue.noise)];
  if (take.count > 0) audio_.play(take.sounds[take.next++ % take.count], at_volume(cue.how));
}

void Sounds::tick(const Simulation& simulation) {
  idle_ns_ = 0;
  const auto louder = [](const engine::Playing& one, const engine::Playing& other) {
    return one.volume >= other.volume ? one : other;
  };
  engine::Playing wind{0.0, 0.0, 1.0};
  engine::Playing reel = wind;
  for (std::size_t k = 0; k < static_cast<std::size_t>(simulation.players()); ++k) {
    cues_[k].update(simulation);
    for (const Cue& cue : cues_[k].cues()) play(cue);
    wind = louder(cues_[k].wind(), wind);
    reel = louder(cues_[k].reel(), reel);
  }
  audio_.set_loop(wind_, at_volume(wind));
  audio_.set_loop(reel_, at_volume(reel));
}

void Sounds::frame(std::int64_t elapsed_ns, const Loudness& loudness, Tune tune) {
  volume_ = loudness.sounds;
  audio_.set_volume(loudness.muted ? 0.0 : 1.0);
  music_.frame(elapsed_ns, tune, loudness.music);
  idle_ns_ += elapsed_ns;
  if (idle_ns_ > pause_ns) {
    for (const engine::LoopId loop : {wind_, reel_}) audio_.set_loop(loop, {0.0, 0.0, 1.0});
  }
  lost_ns_ = audio_.has_device() ? 0 : lost_ns_ + elapsed_ns;
  if (!had_device_ || lost_ns_ < retry_ns) return;
  lost_ns_ = 0;
  audio_.reopen_if_lost();
}

}  // namespace game
