// Somebody's little game, with a Box2D world, tick, contact listener and drawing of its own, to which a cord was added:
// a wrecking ball. Lines with a comment behind them are what that took.
//   wrecking_ball [TICKS]    left and right push the ball, Space lets go of it, S saves, L goes back to that
#include <SDL.h>
#include <box2d/box2d.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "ribbon/box2d/convert.h"   // Box2D's vectors from the cords', and back
#include "ribbon/box2d/coupling.h"  // cords in a Box2D world
#include "ribbon/layout.h"          // how a cord lies at first

namespace {
constexpr float dt = 1.0F / 60.0F;
SDL_FPoint to_pixels(b2Vec2 p) { return {60.0F * p.x, 540.0F - 60.0F * p.y}; }

struct Thuds : b2ContactListener {
  void BeginContact(b2Contact* /*contact*/) override { ++count; }
  int count = 0;
};

struct Saved {
  std::vector<b2BodyDef> bodies;
  engine::CouplingState cords;  // plain data: where points are, who holds them, what touches them
};

struct Game {
  Game() {
    world.SetContactListener(&thuds);
    const b2BodyDef still;
    b2EdgeShape floor;
    floor.SetTwoSided({-20.0F, 0.5F}, {40.0F, 0.5F});
    world.CreateBody(&still)->CreateFixture(&floor, 0.0F);
    add_circle({5.5F, 5.0F}, 0.25F, b2_staticBody);  // in the cord's way
    for (int k = 0; k < 6; ++k) add_circle({6.25F, 0.8125F + 0.625F * static_cast<float>(k)}, 0.3125F, b2_dynamicBody);
    ball = add_circle({0.8F, 5.2F}, 0.45F, b2_dynamicBody);

    ribbon::CordDef def;                                    // what it is made of; whatever is not asked for is off
    def.points = 41;                                        // more of them bend finer and cost more
    def.mass_per_length = 0.5;                              // kg/m
    def.radius = 0.03;                                      // m: half as thick as it is where something touches it
    def.friction = 0.3;                                     // mixed with that of fixtures as Box2D does
    def.pins = {0};                                         // the first point stays where it is: on the hook
    ribbon::lay_along(def, {{5.0, 8.5}, {0.8, 5.2}});       // m, from the hook to the ball; that is its length, too
    cord = cords.add(ribbon::Cord(def));                    // from now on the coupling has it; this is its number there
    cords.hold(cord, def.points - 1, *ball, {0.0F, 0.0F});  // the ball's own centre holds the last point
  }

  void tick(float push) {
    ball->ApplyForceToCenter({push, 0.0F}, true);
    cords.gather(world, dt);  // the cords look who is near them
    cords.step();             // and move, together with who holds or touches them,
    cords.apply();            // who get their impulses from it
    world.Step(dt, 8, 3);
    for (const engine::TouchEvent& touch : cords.touch_events()) touches += touch.begins ? 1 : 0;  // since gather
  }

  Saved save() const {
    Saved saved{{}, cords.save(world)};  // Box2D cannot save a world: bodies are up to the game
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
      b2BodyDef& to = saved.bodies.emplace_back();
      to.position = body->GetPosition();
      to.angle = body->GetAngle();
      to.linearVelocity = body->GetLinearVelocity();
      to.angularVelocity = body->GetAngularVelocity();
    }
    return saved;
  }
  void restore(const Saved& saved) {
    auto from = saved.bodies.begin();
    for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext(), ++from) {
      body->SetTransform(from->position, from->angle);
      body->SetLinearVelocity(from->linearVelocity);
      body->SetAngularVelocity(from->angularVelocity);
    }
    cords.restore(saved.cords, world);  // the ball holds it again if it did then
  }

  void draw(SDL_Renderer* renderer) const {
    SDL_SetRenderDrawColor(renderer, 24, 26, 33, 255);
    SDL_RenderClear(renderer);
    SDL_SetRenderDrawColor(renderer, 240, 200, 120, 255);
    SDL_RenderDrawLineF(renderer, 0.0F, 510.0F, 960.0F, 510.0F);
    std::vector<SDL_FPoint> line;
    for (const ribbon::Vec2 x : cords.positions(cord)) line.push_back(to_pixels(engine::to_float(x)));  // its points
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
    const ribbon::Vec2 at = engine::to_double(ball->GetPosition());
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
  engine::Coupling cords;      // all cords of this world
  engine::CordIndex cord = 0;  // ours
};

/// Until the window is closed, or for so many ticks, of which the middle one is saved and gone back to in the end.
void play(Game& game, SDL_Renderer* renderer, int ticks) {
  const int half = ticks > 0 ? ticks / 2 : -1;
  Saved saved = game.save();
  const Uint8* key = SDL_GetKeyboardState(nullptr);
  for (int tick = 0; tick != ticks && SDL_QuitRequested() == SDL_FALSE; ++tick) {
    if (tick == half) game.print("half way");
    if (key[SDL_SCANCODE_S] != 0 || tick == half) saved = game.save();
    if (key[SDL_SCANCODE_L] != 0) game.restore(saved);
    if (key[SDL_SCANCODE_SPACE] != 0) game.cords.release(*game.ball);  // with the velocity that it has
    game.tick(300.0F * static_cast<float>(key[SDL_SCANCODE_RIGHT] - key[SDL_SCANCODE_LEFT]));
    game.draw(renderer);
    if (ticks < 0) SDL_Delay(16);
  }
  game.print("at the end");
  game.restore(saved);
  game.print("gone back");
}
}  // namespace

int main(int argc, char** argv) {
  SDL_Window* window = nullptr;
  SDL_Renderer* renderer = nullptr;
  if (SDL_CreateWindowAndRenderer(960, 540, 0, &window, &renderer) != 0) return 1;
  Game game;
  play(game, renderer, argc > 1 ? std::atoi(argv[1]) : -1);
  SDL_Quit();
}
