// A small game with its own Box2D world, tick, contact listener and drawing. A cord was added to it: the rope of a
// wrecking ball. Lines that end with a comment were added for the cord.
//   wrecking_ball [TICKS]    the arrow keys push the ball, Space releases it, W lets wind blow, S saves, L restores
//   wrecking_ball study      prints the error and the cost of several accuracies of the rope, and recommends one
#include <SDL.h>
#include <box2d/box2d.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "ribbon/box2d/convert.h"         // conversions between vectors of cords and of Box2D
#include "ribbon/box2d/coupling.h"        // cords in a Box2D world
#include "ribbon/box2d/world_snapshot.h"  // bodies and contacts, to go back
#include "ribbon/layout.h"                // initial positions
#include "ribbon/study/study.h"           // which accuracy the cords need
#include "ribbon/weather.h"               // wind and water

namespace {
constexpr float dt = 1.0F / 60.0F;
SDL_FPoint to_pixels(b2Vec2 p) { return {60.0F * p.x, 540.0F - 60.0F * p.y}; }

struct Thuds : b2ContactListener {
  void BeginContact(b2Contact* /*contact*/) override { ++count; }
  int count = 0;
};

struct Saved {
  ribbon::box2d::WorldSnapshot world;  // bodies and contacts
  ribbon::box2d::CouplingState cords;  // the state of all cords, as plain data
};

struct Game {
  Game() {
    world.SetContactListener(&thuds);
    const b2BodyDef still;
    b2EdgeShape floor;
    floor.SetTwoSided({-20.0F, 0.5F}, {40.0F, 0.5F});
    world.CreateBody(&still)->CreateFixture(&floor, 0.0F);
    add_circle({5.5F, 5.0F}, 0.25F, b2_staticBody);  // an obstacle for the cord
    for (int k = 0; k < 6; ++k) add_circle({6.25F, 0.8125F + 0.625F * static_cast<float>(k)}, 0.3125F, b2_dynamicBody);
    ball = add_circle({0.8F, 5.2F}, 0.45F, b2_dynamicBody);

    ribbon::CordDef def;                                    // defines the cord; terms that are not set are off
    def.points = 41;                                        // more points bend more smoothly and cost more
    def.mass_per_length = 0.5;                              // kg/m
    def.radius = 0.03;                                      // m, half the thickness for contacts
    def.drag_across = 1.2;                                  // what wind acts on; it blows when you press W
    def.friction = 0.3;                                     // combines with the friction of fixtures as in Box2D
    def.pins = {0};                                         // the first point is fixed at the hook
    ribbon::lay_along(def, {{5.0, 8.5}, {0.8, 5.2}});       // m, from the hook to the ball; sets the length too
    cord = cords.add(ribbon::Cord(def));                    // moves the cord into the coupling; returns its id
    cords.hold(cord, def.points - 1, *ball, {0.0F, 0.0F});  // the centre of the ball holds the last point
  }

  void tick(float push) {
    ball->ApplyForceToCenter({push, 0.0F}, true);
    cords.tick(world, dt);  // in place of world.Step
    for (const auto& touch : cords.last_step().touch_events()) touches += touch.begins ? 1 : 0;  // in this tick
  }

  void save(Saved& saved) const {
    saved.world.save(world);         // Box2D cannot save a world
    cords.save(world, saved.cords);  // into the same memory each time
  }
  void restore(Saved& saved) {
    saved.world.restore(world);
    cords.restore(saved.cords, world);  // restores the grip of the ball too
  }

  void draw(SDL_Renderer* renderer) const {
    SDL_SetRenderDrawColor(renderer, 24, 26, 33, 255);
    SDL_RenderClear(renderer);
    SDL_SetRenderDrawColor(renderer, 240, 200, 120, 255);
    SDL_RenderDrawLineF(renderer, 0.0F, 510.0F, 960.0F, 510.0F);
    std::vector<SDL_FPoint> line;
    for (const ribbon::Vec2 x : cords.cord(cord).positions())  // the points of the cord
      line.push_back(to_pixels(ribbon::box2d::to_float(x)));   // in the precision of Box2D
    SDL_RenderDrawLinesF(renderer, line.data(), static_cast<int>(line.size()));
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
      const b2Vec2 arm{body->GetFixtureList()->GetShape()->m_radius, 0.0F};
      line.clear();
      for (float a = 0.0F; a < 6.5F; a += 0.25F) line.push_back(to_pixels(body->GetWorldPoint(b2Mul(b2Rot(a), arm))));
      SDL_RenderDrawLinesF(renderer, line.data(), static_cast<int>(line.size()));
    }
    SDL_RenderPresent(renderer);
  }

  void print(const char* when) const {
    const ribbon::Vec2 at = ribbon::box2d::to_double(ball->GetPosition());
    std::printf("%s: ball at (%.3f, %.3f), thuds %d, touches %d\n", when, at.x, at.y, thuds.count, touches);
  }

  b2Body* add_circle(b2Vec2 position, float radius, b2BodyType type) {
    b2BodyDef def;
    def.type = type;
    def.position = position;
    b2CircleShape circle;
    circle.m_radius = radius;
    b2Body* body = world.CreateBody(&def);
    body->CreateFixture(&circle, 100.0F * radius);
    return body;
  }

  b2World world{{0.0F, -9.81F}};
  b2Body* ball = nullptr;
  Thuds thuds;
  int touches = 0;
  const ribbon::Weather wind{{.wind = {25.0, 0.0}, .gusts = 0.5}};  // m/s, to the right
  ribbon::box2d::Coupling cords;                                    // all cords of this world
  ribbon::box2d::CordId cord = 0;                                   // its id
};

/// Runs until the window is closed, or for `ticks` ticks; then it saves after half of them and restores at the end.
void play(Game& game, SDL_Renderer* renderer, int ticks) {
  const int half = ticks > 0 ? ticks / 2 : -1;
  Saved saved;
  game.save(saved);
  const Uint8* key = SDL_GetKeyboardState(nullptr);
  for (int tick = 0; tick != ticks && SDL_QuitRequested() == SDL_FALSE; ++tick) {
    if (tick == half) game.print("half way");
    if (key[SDL_SCANCODE_S] != 0 || tick == half) game.save(saved);
    if (key[SDL_SCANCODE_L] != 0) game.restore(saved);
    if (key[SDL_SCANCODE_SPACE] != 0) game.cords.body(*game.ball).release();  // the ball keeps its velocity
    if (key[SDL_SCANCODE_W] != 0) game.cords.set_medium(&game.wind);          // from the next tick on
    game.tick(300.0F * static_cast<float>(key[SDL_SCANCODE_RIGHT] - key[SDL_SCANCODE_LEFT]));
    game.draw(renderer);
    if (ticks < 0) SDL_Delay(16);
  }
  game.print("at the end");
  game.restore(saved);
  game.print("gone back");
}

void study() {
  const auto make = [] {  // the scene, anew for each run; the same push in each
    const auto game = std::make_shared<Game>();
    return ribbon::study::Scene{game->world, game->cords, [game](int tick) { game->tick(tick < 30 ? 300.0F : 0.0F); }};
  };
  const ribbon::study::Study results = ribbon::study::measure(make, 120);
  std::fputs(results.table().c_str(), stdout);
  const auto best = results.cheapest_within(0.01);  // m
  std::printf("for 1 cm: %s\n", best ? results.settings[*best].setting.name.c_str() : "none of them");
}
}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "study") == 0) {
    study();
    return 0;
  }
  SDL_Window* window = nullptr;
  SDL_Renderer* renderer = nullptr;
  if (SDL_CreateWindowAndRenderer(960, 540, 0, &window, &renderer) != 0) return 1;
  Game game;
  play(game, renderer, argc > 1 ? std::atoi(argv[1]) : -1);
  SDL_Quit();
}
