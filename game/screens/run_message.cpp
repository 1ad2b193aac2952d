#include "game/screens/run_message.h"

#include "game/screens/help.h"
#include "game/view/hud.h"
#include "game/words/words.h"

namespace game {
namespace {

RunMessage end_of(const PlayedRun& played, const std::string& leave) {
  if (!played.options().verify) return {words::end_of_recording, leave};
  const bool same = played.run().exit_status() == 0;
  return {same ? words::verified : words::differs,
          words::filled(words::two_parts, {{"first", played.run().closing_line()}, {"second", leave}})};
}

RunMessage stopped(const Session& session) {
  const auto key = [&session](Action action) {
    return codes_in_words(session.settings.bindings, action, session.uses_pad, 1);
  };
  return {words::stopped,
          words::filled(words::stopped_keys, {{"pause", key(Action::pause)}, {"step", key(Action::step)}})};
}

}  // namespace

RunMessage message_of(const PlayedRun& played, const Session& session, const Pace& pace, const Hint& hint, bool won) {
  if (played.is_over()) return end_of(played, session.uses_pad ? words::leave_button : words::leave_key);
  if (pace.is_stopped()) return stopped(session);
  const Simulation& simulation = played.run().simulation();
  const auto goal = simulation.goal_ticks();
  if (goal && !won) return {words::made_it, words::filled(words::made_it_in, {{"time", seconds_in_words(*goal)}})};
  if (played.run().has_replay()) return {};
  if (simulation.players() == 2 && !goal && simulation.is_at_flag(0) != simulation.is_at_flag(1))
    return {"", words::one_at_flag};
  if (pace.slowed() > 1) return {"", words::filled(words::slow_motion, {{"factor", std::to_string(pace.slowed())}})};
  if (hint.is_shown() && !goal)
    return {"", hint_in_words(played.run().level().hint, session.settings, session.uses_pad)};
  return {};
}

}  // namespace game
