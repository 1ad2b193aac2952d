#define SDL_MAIN_HANDLED  // keeps SDL from renaming main

#include "engine/window/sdl_audio.h"

#include <SDL.h>

#include <utility>

namespace engine {
namespace {

constexpr std::uint16_t frames_per_callback = 512;  // 12 ms: a delay that is not noticed

/// Locks the mixer against the audio thread.
class Lock {
 public:
  explicit Lock(SDL_AudioDeviceID device) : device_(device) {
    if (device_ != 0) SDL_LockAudioDevice(device_);
  }
  ~Lock() {
    if (device_ != 0) SDL_UnlockAudioDevice(device_);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  SDL_AudioDeviceID device_;
};

void fill(void* mixer, std::uint8_t* bytes, int size) {
  static_cast<Mixer*>(mixer)->mix({reinterpret_cast<float*>(bytes), static_cast<std::size_t>(size) / sizeof(float)});
}

}  // namespace

struct Audio::Impl {
  Impl() { open(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { close(); }

  void open();
  void close();
  bool is_lost() const { return device != 0 && SDL_GetAudioDeviceStatus(device) == SDL_AUDIO_STOPPED; }

  Mixer mixer{rate};
  bool has_driver = false;
  SDL_AudioDeviceID device = 0;
  std::string open_error;
};

void Audio::Impl::open() {
  has_driver = SDL_InitSubSystem(SDL_INIT_AUDIO) == 0;
  if (has_driver) {
    SDL_AudioSpec wanted{};
    wanted.freq = rate;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 2;
    wanted.samples = frames_per_callback;
    wanted.callback = fill;
    wanted.userdata = &mixer;
    device = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
  }
  open_error = device == 0 ? std::string("there is no sound: ") + SDL_GetError() : "";
  if (device != 0) SDL_PauseAudioDevice(device, 0);
}

void Audio::Impl::close() {
  if (device != 0) SDL_CloseAudioDevice(std::exchange(device, 0));
  if (std::exchange(has_driver, false)) SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

Audio::Audio() : impl_(std::make_unique<Impl>()) {}
Audio::~Audio() = default;

bool Audio::has_device() const { return impl_->device != 0 && !impl_->is_lost(); }

std::string Audio::why_silent() const { return impl_->is_lost() ? "the sound device was lost" : impl_->open_error; }

bool Audio::reopen_if_lost() {
  if (has_device()) return false;
  impl_->close();
  impl_->open();
  return has_device();
}

SoundId Audio::add(Sound sound) {
  const Lock lock(impl_->device);
  return impl_->mixer.add(std::move(sound));
}

void Audio::play(SoundId sound, const Playing& how) {
  const Lock lock(impl_->device);
  if (impl_->device != 0) impl_->mixer.play(sound, how);
}

LoopId Audio::start_loop(SoundId sound) {
  const Lock lock(impl_->device);
  return impl_->mixer.start_loop(sound);
}

void Audio::set_loop(LoopId loop, const Playing& how) {
  const Lock lock(impl_->device);
  impl_->mixer.set_loop(loop, how);
}

void Audio::fade_out() {
  const Lock lock(impl_->device);
  impl_->mixer.fade_out();
}

void Audio::set_volume(double volume) {
  const Lock lock(impl_->device);
  impl_->mixer.set_volume(volume);
}

}  // namespace engine
