#define SDL_MAIN_HANDLED  // keeps SDL from renaming main

#include "engine/window/sdl_window.h"

#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <vector>

#include "engine/window/sdl_display.h"
#include "engine/window/sdl_events.h"

namespace engine {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void no_display(const std::string& reason) {
  throw std::runtime_error("there is no display to open a window on (" + reason +
                           "): start it from a desktop session, or run with --headless");
}

/// SDL falls back to these drivers, which show nothing, if there is no display. They are used only on request.
bool shows_nothing(std::string_view driver) { return driver == "offscreen" || driver == "dummy" || driver == "evdev"; }

/// Keeps SDL's video subsystem open. Declare it before the members that need it.
struct Video {
  Video() {
    SDL_SetMainReady();
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) no_display(SDL_GetError());
    if (SDL_GetHint(SDL_HINT_VIDEODRIVER) != nullptr || !shows_nothing(SDL_GetCurrentVideoDriver())) return;
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    no_display("neither DISPLAY nor WAYLAND_DISPLAY leads to one");
  }
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;
  ~Video() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }
};

template <typename T>
T* need(T* made, const char* what) {
  if (made == nullptr) throw std::runtime_error(std::string("cannot open ") + what + ": " + SDL_GetError());
  return made;
}

SDL_Renderer* make_renderer(SDL_Window* window) {
  SDL_Renderer* made = SDL_CreateRenderer(window, -1, SDL_RENDERER_ACCELERATED | SDL_RENDERER_PRESENTVSYNC);
  if (made == nullptr) made = SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
  return need(made, "a renderer for the window");
}

/// Returns whether present() waits for the display. The software renderer claims it too, but with some drivers it does
/// not wait.
bool waits_for_display(SDL_Renderer* renderer) {
  constexpr std::uint32_t both = SDL_RENDERER_ACCELERATED | SDL_RENDERER_PRESENTVSYNC;
  SDL_RendererInfo info{};
  return SDL_GetRendererInfo(renderer, &info) == 0 && (info.flags & both) == both;
}

/// Zero if the caller of each frame keeps the time, as a browser does: waiting there would block the page.
Clock::duration frame_time(SDL_Window* window) {
#ifdef __EMSCRIPTEN__
  (void)window;
  return Clock::duration::zero();
#else
  SDL_DisplayMode mode{};
  const bool known = SDL_GetWindowDisplayMode(window, &mode) == 0 && mode.refresh_rate > 0;
  return std::chrono::nanoseconds(1'000'000'000 / (known ? std::clamp(mode.refresh_rate, 30, 240) : 60));
#endif
}

WindowSize usable_size(int display) {
  SDL_Rect usable{};
  if (SDL_GetDisplayUsableBounds(display, &usable) != 0) return {};
  return {usable.w, usable.h};
}

SDL_Window* make_window(const std::string& title, WindowSize wanted) {
  const WindowSize size = fitting_size(wanted, usable_size(0));
  return need(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width, size.height,
                               SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI),
              "the window");
}

/// Makes a window smaller that does not fit on its display together with its borders, which are known only now.
void fit_with_borders(SDL_Window* window) {
  int top = 0, left = 0, bottom = 0, right = 0;
  WindowSize size;
  SDL_GetWindowSize(window, &size.width, &size.height);
  if (SDL_GetWindowBordersSize(window, &top, &left, &bottom, &right) != 0) return;
  const WindowSize usable = usable_size(std::max(SDL_GetWindowDisplayIndex(window), 0));
  const WindowSize fits = fitting_size(size, usable, {left + right, top + bottom});
  if (!(fits == size)) SDL_SetWindowSize(window, fits.width, fits.height);
}

}  // namespace

WindowSize fitting_size(WindowSize wanted, WindowSize usable, WindowSize borders) {
  const auto fit = [](int side, int room, int border) {
    return room <= 0 ? side : std::clamp(side, 1, std::max(room - border, 1));
  };
  return {fit(wanted.width, usable.width, borders.width), fit(wanted.height, usable.height, borders.height)};
}

struct Window::Impl {
  Impl(const std::string& title, int width, int height);

  void check_display() const;
  template <typename Call>
  int call_display(const Call& call);
  bool close();

  void follow_size();
  void renew();

  DisplayLoss loss;
  HeadlessCanvas canvas;
  Video video;
  std::unique_ptr<SDL_Window, decltype(&SDL_DestroyWindow)> window;
  std::unique_ptr<SDL_Renderer, decltype(&SDL_DestroyRenderer)> renderer;
  std::unique_ptr<SDL_Texture, decltype(&SDL_DestroyTexture)> texture{nullptr, SDL_DestroyTexture};
  ribbon::Vec2 scale{1.0, 1.0};  // pixels per desktop unit
  EventReader events;
  InputState input;
  bool vsync;
  Clock::duration period;
  Clock::time_point shown = Clock::now();
};

Window::Impl::Impl(const std::string& title, int width, int height)
    : canvas(width, height),
      window(make_window(title, {width, height}), SDL_DestroyWindow),
      renderer(make_renderer(window.get()), SDL_DestroyRenderer),
      vsync(waits_for_display(renderer.get())),
      period(frame_time(window.get())) {
  watch_for_display_loss(window.get(), loss);
  fit_with_borders(window.get());
  follow_size();
}

void Window::Impl::check_display() const {
  if (loss.lost) throw std::runtime_error("the display was lost: the X server that showed the window has gone");
}

/// Calls a function that uses the display. Throws std::runtime_error if the display is or gets lost. The function may
/// be left by longjmp: it must call C functions only.
template <typename Call>
int Window::Impl::call_display(const Call& call) {
  check_display();
  std::jmp_buf escape;
  volatile int result = 0;
  if (setjmp(escape) == 0) {
    loss.escape = &escape;
    result = call();
  }
  loss.escape = nullptr;
  check_display();
  return result;
}

void Window::Impl::follow_size() {
  int pixels_x = 0, pixels_y = 0, units_x = 0, units_y = 0;
  SDL_GetWindowSize(window.get(), &units_x, &units_y);
  if (SDL_GetRendererOutputSize(renderer.get(), &pixels_x, &pixels_y) != 0) return;
  if (pixels_x < 1 || pixels_y < 1 || units_x < 1 || units_y < 1) return;  // minimised
  scale = {static_cast<double>(pixels_x) / units_x, static_cast<double>(pixels_y) / units_y};
  if (texture && pixels_x == canvas.width() && pixels_y == canvas.height()) return;
  canvas.resize(pixels_x, pixels_y);
  texture.reset(
      need(SDL_CreateTexture(renderer.get(), SDL_PIXELFORMAT_RGB888, SDL_TEXTUREACCESS_STREAMING, pixels_x, pixels_y),
           "a texture for the window"));
}

void Window::Impl::renew() {
  texture.reset();
  renderer.reset();  // a window has one at most
  renderer.reset(make_renderer(window.get()));
  vsync = waits_for_display(renderer.get());
  follow_size();
}

Window::Window(const std::string& title, int width, int height) : impl_(std::make_unique<Impl>(title, width, height)) {}

/// Closes the window: that calls the display and waits for an answer. Returns false if the display is or gets lost;
/// then no answer comes, and what is left cannot be closed.
bool Window::Impl::close() {
  if (loss.lost) return false;
  std::jmp_buf escape;
  volatile bool closed = false;
  if (setjmp(escape) == 0) {
    loss.escape = &escape;
    SDL_DestroyTexture(texture.release());
    SDL_DestroyRenderer(renderer.release());
    SDL_DestroyWindow(window.release());
    closed = true;
  }
  loss.escape = nullptr;
  return closed;
}

Window::~Window() {
  // After a loss the objects are leaked on purpose.
  static std::vector<Impl*> leaked;
  if (!impl_->close()) leaked.push_back(impl_.release());
}

Canvas& Window::canvas() { return impl_->canvas; }
const Canvas& Window::canvas() const { return impl_->canvas; }

const Raster& Window::raster() const { return impl_->canvas.raster(); }

double Window::pixel_scale() const { return std::max(impl_->scale.y, 1.0); }

WindowInput Window::poll() {
  SDL_Event event;
  while (impl_->call_display([&event] { return SDL_PollEvent(&event); }) != 0) {
    impl_->events.read(event, impl_->scale, impl_->input);
  }
  impl_->follow_size();
  return impl_->input.take();
}

void Window::present() {
  impl_->call_display([this] {
    const Raster& raster = impl_->canvas.raster();
    SDL_Renderer* const renderer = impl_->renderer.get();
    SDL_UpdateTexture(impl_->texture.get(), nullptr, raster.pixels().data(), 4 * raster.width());
    SDL_RenderCopy(renderer, impl_->texture.get(), nullptr, nullptr);
    SDL_RenderPresent(renderer);
    return 0;
  });
  // With vsync, the driver may not wait while the window is hidden: half a period is the minimum then.
  const auto earliest = impl_->shown + (impl_->vsync ? impl_->period / 2 : impl_->period);
  const auto now = Clock::now();
  if (now < earliest) std::this_thread::sleep_until(earliest);
  impl_->shown = std::max(earliest, now);
}

void Window::renew() {
  impl_->check_display();
  impl_->renew();
}

void Window::set_title(const std::string& title) {
  impl_->call_display([&] {
    SDL_SetWindowTitle(impl_->window.get(), title.c_str());
    return 0;
  });
}

void Window::set_fullscreen(bool fullscreen) {
  impl_->call_display([&] {
    return SDL_SetWindowFullscreen(impl_->window.get(), fullscreen ? std::uint32_t{SDL_WINDOW_FULLSCREEN_DESKTOP} : 0U);
  });
}

void Window::save_png(const std::string& path) const { impl_->canvas.save_png(path); }

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch()).count();
}

}  // namespace engine
